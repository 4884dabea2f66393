# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package: all modules import, the pipeline runs, and a few lines make a picture."""
import os
import tempfile
import unittest

import numpy
import vtknpr
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkOutputWindow
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkFiltersSources import vtkCylinderSource, vtkSphereSource
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource
from vtkmodules.vtkIOImage import vtkPNGReader
from vtkmodules.vtkIOPLY import vtkPLYReader
from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
from vtkmodules.vtkRenderingCore import vtkActor, vtkCamera, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow


def make_sphere():
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(48)
    sphere.SetPhiResolution(48)
    sphere.SetRadius(2.0)
    return sphere


def read_image(path):
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    image = reader.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)


class TestPackage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.image = os.path.join(folder.name, "image.png")

    def test_curvature_of_a_sphere(self):
        sphere = make_sphere()
        preparation = vtknpr.vtkNPRSurfacePreparation()
        preparation.SetInputConnection(sphere.GetOutputPort())
        normals = vtknpr.vtkNPRSurfaceNormals()
        normals.SetInputConnection(preparation.GetOutputPort())
        tensor = vtknpr.vtkNPRCurvatureTensor()
        tensor.SetInputConnection(normals.GetOutputPort())
        tensor.Update()
        curvature = vtk_to_numpy(tensor.GetOutput().GetPointData().GetArray("MeanCurvature"))
        self.assertLess(numpy.abs(curvature - 0.5).max(), 0.02)

    def test_contour_of_a_sphere(self):
        sphere = make_sphere()
        preparation = vtknpr.vtkNPRSurfacePreparation()
        preparation.SetInputConnection(sphere.GetOutputPort())
        normals = vtknpr.vtkNPRSurfaceNormals()
        normals.SetInputConnection(preparation.GetOutputPort())
        camera = vtkCamera()
        camera.ParallelProjectionOn()
        camera.SetPosition(1, 2, 3)
        lines = vtknpr.vtkNPRFeatureLines()
        lines.SetInputConnection(normals.GetOutputPort())
        lines.AddDefinition("contours")
        lines.SetCamera(camera)
        lines.Update()
        points = vtk_to_numpy(lines.GetOutput().GetPoints().GetData())
        self.assertEqual(lines.GetOutput().GetNumberOfLines(), 1)
        self.assertLess(numpy.abs(points @ [1, 2, 3]).max() / numpy.sqrt(14), 0.02)
        self.assertLess(numpy.abs(numpy.linalg.norm(points, axis=1) - 2).max(), 0.01)

    def test_render(self):
        sphere = make_sphere()
        sphere.Update()
        vtknpr.render(sphere.GetOutput(), self.image, style="ink", size=(200, 160), view=(30, 10))
        image = read_image(self.image)
        self.assertEqual(image.shape, (160, 200, 3))
        dark = (image.max(axis=2) < 80).sum()
        self.assertTrue(300 < dark < 3000, dark)
        self.assertEqual(image[80, 100].min(), 255)

    def test_render_takes_sources_and_one_kind(self):
        sphere = make_sphere()
        images = []
        for lines in ("contours", ["contours"]):
            vtknpr.render(sphere, self.image, style="ink", size=(200, 160), lines=lines)
            images.append(read_image(self.image))
        numpy.testing.assert_array_equal(*images)
        self.assertGreater((images[0].max(axis=2) < 80).sum(), 300)

    def test_render_refuses(self):
        cylinder = vtkCylinderSource()
        cylinder.Update()
        for words in (
            {"path": "picture.gif"},
            {"style": "nonsense"},
            {"view": "sideways"},
            {"surface": vtkPolyData()},
            {"lines": "scribbles"},
            {"size": (0, 0)},
            {"size": (100, -1)},
            {"size": (100, 20000)},
            {"size": (100,)},
            {"size": (100.5, 100)},
            {"size": 100},
        ):
            with self.subTest(words=words), self.assertRaises(ValueError):
                vtknpr.render(**{"surface": cylinder.GetOutput(), "path": self.image, **words})
        for surface in (None, "model.ply", vtkRTAnalyticSource(), vtkPNGReader):
            with self.subTest(surface=surface), self.assertRaisesRegex(TypeError, "vtkPolyData"):
                vtknpr.render(surface, self.image)
        self.assertFalse(os.path.exists(self.image))
        with self.assertRaises(OSError):
            vtknpr.render(cylinder.GetOutput(), "/no/such/folder/image.png", size=(32, 32))

    def test_errors_of_filters_and_readers_are_raised(self):
        window = vtkOutputWindow.GetInstance()
        missing = vtkXMLPolyDataReader()
        missing.SetFileName("/no/such/file.vtp")
        ply = vtkPLYReader()  # warns of it, and fails
        ply.SetFileName("/no/such/file.ply")
        for words, said in (
            ({"surface": missing}, "/no/such/file.vtp"),
            ({"surface": ply}, "Could not open PLY file"),
            ({"lines": "isolines"}, "^The lines \"isolines\": a point array is needed.*no point arrays"),
        ):
            with self.subTest(words=words), self.assertRaisesRegex(RuntimeError, said):
                vtknpr.render(**{"surface": make_sphere(), "path": self.image, "size": (64, 64), **words})
            self.assertFalse(os.path.exists(self.image))
        self.assertEqual(vtkOutputWindow.GetInstance(), window)

    def test_illustrate_undoes_what_it_can_not_finish(self):
        vtknpr.vtkNPROffscreen.Setup()
        sphere = make_sphere()
        mapper = vtkPolyDataMapper()
        mapper.SetInputConnection(sphere.GetOutputPort())
        actor = vtkActor()
        actor.SetMapper(mapper)
        renderer = vtkRenderer()
        renderer.SetBackground(0.1, 0.2, 0.3)
        renderer.AddActor(actor)
        window = vtkRenderWindow()
        window.SetOffScreenRendering(1)
        window.AddRenderer(renderer)
        with self.assertRaisesRegex(RuntimeError, "point array"):
            vtknpr.illustrate(renderer, "ink", "isolines")
        self.assertEqual(actor.GetMapper(), mapper)
        self.assertEqual(renderer.GetActors().GetNumberOfItems(), 1)
        self.assertIsNone(renderer.GetPass())
        self.assertEqual(renderer.GetBackground(), (0.1, 0.2, 0.3))


if __name__ == "__main__":
    unittest.main()
