# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines that are functions over numpy arrays, or formulas: they do what built-in ones do."""
import os
import tempfile
import unittest

import numpy
import vtknpr
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkRenderingCore import vtkCamera

SINE = numpy.sin(numpy.radians(15))


def facing(q):
    return numpy.minimum((q.sintheta - SINE) / SINE, q.ndotv / 0.02)


def suggestive(q):
    rise = (q.dwkr - 2) * q.sintheta / 2
    return numpy.where(facing(q) > 0, numpy.minimum(facing(q), rise), facing(q))


def read_image(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    return vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)


class TestDefineLines(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        source = vtknpr.vtkNPRSampleSource()
        cls.preparation = vtknpr.vtkNPRSurfacePreparation()
        cls.preparation.SetInputConnection(source.GetOutputPort())
        cls.normals = vtknpr.vtkNPRSurfaceNormals()
        cls.normals.SetInputConnection(cls.preparation.GetOutputPort())
        cls.tensor = vtknpr.vtkNPRCurvatureTensor()
        cls.tensor.SetInputConnection(cls.normals.GetOutputPort())
        cls.tensor.Update()
        cls.camera = vtkCamera()
        cls.camera.SetPosition(3, 4, 8)

    def extract(self, lines, surface=None):
        filter = vtknpr.vtkNPRFeatureLines()
        filter.SetInputConnection((surface or self.tensor).GetOutputPort())
        filter.AddDefinition(lines)
        filter.SetCamera(self.camera)
        filter.Update()
        result = vtkPolyData()
        result.ShallowCopy(filter.GetOutput())
        return result

    def test_suggestive_contours(self):
        mine = vtknpr.define_lines("mine", field=lambda q: q.kr, test=suggestive)
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        builtin = self.extract("suggestive")
        self.assertGreater(builtin.GetNumberOfLines(), 10)
        for lines in (mine, "mine"):
            result = self.extract(lines)
            self.assertEqual(result.GetNumberOfLines(), builtin.GetNumberOfLines())
            for get in (
                lambda data: data.GetPoints().GetData(),
                lambda data: data.GetPointData().GetArray("Strength"),
            ):
                difference = vtk_to_numpy(get(result)) - vtk_to_numpy(get(builtin))
                self.assertLess(numpy.abs(difference).max(), 1e-5)
            self.assertEqual(result.GetFieldData().GetAbstractArray("LineTypeNames").GetValue(0), "mine")

    def test_quantities(self):
        seen = {}

        def field(q):
            names = vtknpr.vtkNPRCallbackLines.GetQuantityNames()
            seen.update({name: q[name].copy() for name in names})
            seen.update(eye=q.eye, infinite=q.eye_at_infinity, nx=q.nx.copy(), count=len(q))
            seen.update(mean=q["MeanCurvature"].copy())
            with self.assertRaises(AttributeError):
                q.curvature
            with self.assertRaises(KeyError):
                q["no such array"]
            return q.px

        vtknpr.define_lines("mine", field, view_dependent=False)
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        result = self.extract("mine")
        self.assertGreater(result.GetNumberOfLines(), 0)
        self.assertLess(numpy.abs(vtk_to_numpy(result.GetPoints().GetData())[:, 0]).max(), 1e-6)
        count = self.tensor.GetOutput().GetNumberOfPoints()
        self.assertEqual(seen["count"], count)
        for name in ("e1", "e2", "n", "v", "w", "p"):
            self.assertEqual(seen[name].shape, (count, 3), name)
        numpy.testing.assert_allclose(seen["p"], vtk_to_numpy(self.tensor.GetOutput().GetPoints().GetData()), atol=1e-5)
        numpy.testing.assert_array_equal(seen["nx"], seen["n"][:, 0])
        numpy.testing.assert_allclose(seen["H"], (seen["k1"] + seen["k2"]) / 2, rtol=1e-5, atol=1e-5)
        numpy.testing.assert_allclose(seen["ndotv"], (seen["n"] * seen["v"]).sum(axis=1), atol=1e-5)
        self.assertEqual(seen["mean"].shape, (count,))

    def test_calls(self):
        """Once a view, or once a surface."""
        for dependent, expected in ((True, 3), (False, 1)):
            calls = []
            lines = vtknpr.define_lines("mine", lambda q: calls.append(1) or q.p[:, 1], view_dependent=dependent)
            filter = vtknpr.vtkNPRFeatureLines()
            filter.SetInputConnection(self.tensor.GetOutputPort())
            filter.AddDefinition(lines)
            camera = vtkCamera()
            filter.SetCamera(camera)
            for position in ((1, 2, 9), (2, 2, 9), (3, 2, 9)):
                camera.SetPosition(*position)
                filter.Update()
            self.assertEqual(len(calls), expected)
            vtknpr.vtkNPRLineDefinition.RemoveKind("mine")

    def test_eye(self):
        eyes = []

        def field(q):
            eyes.append((q.eye_at_infinity, *q.eye))
            return q.kr

        lines = vtknpr.define_lines("mine", field)
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        self.extract(lines)
        numpy.testing.assert_allclose(eyes[0], (0, 3, 4, 8), atol=1e-5)
        self.camera.ParallelProjectionOn()
        self.addCleanup(self.camera.ParallelProjectionOff)
        self.extract(lines)
        numpy.testing.assert_allclose(eyes[1], (1, *(numpy.array([3, 4, 8]) / numpy.sqrt(89))), atol=1e-5)

    def test_formulas(self):
        vtknpr.define_lines("mine", "py - a", test="px > 0", levels=[0, 0.1], fade=0.5, constants={"a": 0.25})
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        result = self.extract("mine")
        heights = numpy.unique(numpy.round(vtk_to_numpy(result.GetPoints().GetData())[:, 1], 5))
        numpy.testing.assert_allclose(heights, [0.25, 0.35])

    def test_draw(self):
        source = self.preparation.GetInputAlgorithm()
        source.Update()
        vtknpr.define_lines("mine", field=lambda q: numpy.sin(30 * q.py), test=lambda q: q.ndotv)
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        with tempfile.TemporaryDirectory() as folder:
            images = []
            for lines in (["contours"], ["contours", "mine"]):
                path = os.path.join(folder, "image.png")
                vtknpr.render(source.GetOutput(), path, style="ink", size=(200, 160), lines=lines)
                images.append((read_image(path) < 128).sum())
        self.assertGreater(images[1], 1.5 * images[0])

    def test_refused(self):
        for words in (
            {"name": "contours", "field": lambda q: q.kr},
            {"name": "", "field": lambda q: q.kr},
            {"name": "mine", "field": "kr +"},
            {"name": "mine", "field": "kr", "test": "1 < kr < 2"},
            {"name": "mine", "field": "kr", "constants": {"K": 1}},
            {"name": "mine", "field": 3},
            {"name": "mine", "field": None},
            {"name": "mine", "field": lambda q: q.kr, "test": 3},
            {"name": "mine", "field": lambda q: q.kr, "test": "K"},
            {"name": "mine", "field": "kr", "test": lambda q: q.K},
        ):
            with self.subTest(words=words), self.assertRaises(ValueError):
                vtknpr.define_lines(**words)
        with self.assertRaises(TypeError):
            vtknpr.define_lines("mine", lambda q: q.kr, fade=2)

    def test_render_raises_what_functions_raise(self):
        source = self.preparation.GetInputAlgorithm()
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        good = lambda q: q.py
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "image.png")
            for error, said, field, test in (
                (ZeroDivisionError, "division", lambda q: 1 / 0, None),
                (ZeroDivisionError, "division", good, lambda q: 1 / 0),
                (ValueError, "'mine'.*one number for each", lambda q: q.py[:-1], None),
                (ValueError, "'mine'.*one number for each", lambda q: q.p, None),
                (ValueError, "'mine'.*one number for each", good, lambda q: q.py[:-1]),
                (AttributeError, "'krr'", lambda q: q.krr, None),
                (KeyError, "no such array", lambda q: q["no such array"], None),
            ):
                vtknpr.define_lines("mine", field, test)
                with self.subTest(said=said), self.assertRaisesRegex(error, said):
                    vtknpr.render(source, path, size=(80, 60), lines=["mine"])
                self.assertFalse(os.path.exists(path))
            # Nothing is left of it for the next picture.
            vtknpr.define_lines("mine", good)
            vtknpr.render(source, path, size=(80, 60), lines=["mine"])
            self.assertTrue(os.path.exists(path))

    def test_mistakes_in_functions(self):
        """No lines and an error, but no crash."""
        self.addCleanup(vtknpr.vtkNPRLineDefinition.RemoveKind, "mine")
        for field in (lambda q: q.kr[:-1], lambda q: 1 / 0, lambda q: q.krr, lambda q: "text"):
            errors = []
            lines = vtknpr.define_lines("mine", field)
            lines.AddObserver("ErrorEvent", lambda caller, event: errors.append(event))
            self.assertEqual(self.extract(lines).GetNumberOfLines(), 0)
            self.assertTrue(errors)
        # What the surface does not have is asked for.
        lines = vtknpr.define_lines("mine", lambda q: q.kr)
        self.assertEqual(self.extract(lines, self.normals).GetNumberOfLines(), 0)
        # Not a number: no lines there.
        lines = vtknpr.define_lines("mine", lambda q: numpy.where(q.px > 0, q.py - 0.3, numpy.nan))
        points = vtk_to_numpy(self.extract(lines).GetPoints().GetData())
        self.assertGreater(points[:, 0].min(), 0)


if __name__ == "__main__":
    unittest.main()
