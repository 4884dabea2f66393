# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""npr curvature: arrays, statistics and pictures of the curvature of a sphere and a saddle."""

import math
import os
import re
import unittest

try:
    from vtkmodules.vtkIOLegacy import vtkPolyDataReader
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    vtkPolyDataReader = vtkXMLPolyDataReader = None

from commandtest import CommandTest, read_png, run

RADIUS = 2.0

ARRAYS = {
    "Normals": 3,
    "CurvatureTensor": 6,
    "PrincipalCurvature1": 1,
    "PrincipalCurvature2": 1,
    "PrincipalDirection1": 3,
    "PrincipalDirection2": 3,
    "MeanCurvature": 1,
    "GaussianCurvature": 1,
    "CurvatureDerivatives": 4,
    "DerivativeDoubt": 1,
    "ShapeIndex": 1,
    "Curvedness": 1,
    "PointArea": 1,
    "BorderPoints": 1,
    "UnknownCurvature": 1,
}


def grid(n, place):
    """An OBJ of n x n quads over the unit square; place gives the point of (u, v)."""
    rows = ["v %.9g %.9g %.9g" % place(i / n, j / n) for i in range(n + 1) for j in range(n + 1)]
    for i in range(n):
        for j in range(n):
            a = i * (n + 1) + j + 1
            rows.append("f %d %d %d %d" % (a, a + n + 1, a + n + 2, a + 1))
    return "\n".join(rows) + "\n"


def on_sphere(u, v):
    around, up = 2.0 * math.pi * u, math.pi * (v - 0.5)
    return (
        RADIUS * math.cos(up) * math.cos(around),
        RADIUS * math.cos(up) * math.sin(around),
        RADIUS * math.sin(up),
    )


def on_saddle(u, v):
    x, y = 2.0 * u - 1.0, 2.0 * v - 1.0
    return (x, y, 0.5 * (x * x - y * y))


def colours(path):
    """How many pixels of a picture are reddish, bluish, and dark."""
    _, _, channels, rows = read_png(path)
    red = blue = dark = 0
    for row in rows[: len(rows) * 8 // 10]:
        for x in range(0, len(row), channels):
            r, b = row[x], row[x + 2]
            red += r > b + 40
            blue += b > r + 40
            dark += r < 80 and b < 80
    return red, blue, dark


class TestCurvature(CommandTest):
    def setUp(self):
        super().setUp()
        self.sphere = self.write("sphere.obj", grid(40, on_sphere))
        self.saddle = self.write("saddle.obj", grid(30, on_saddle))

    def statistics(self, output):
        """The rows of the table, each by its name as six numbers."""
        rows = {}
        for line in output.splitlines():
            found = re.match(r"  (k1|k2|mean H|Gaussian K) +(.*)", line)
            if found:
                rows[found.group(1)] = [float(x) for x in found.group(2).split()]
        return rows

    def test_statistics_of_a_sphere(self):
        result = self.run_well("curvature", self.sphere)
        rows = self.statistics(result.stdout)
        self.assertEqual(len(rows), 4)
        for name, truth in (("k1", 1 / RADIUS), ("k2", 1 / RADIUS), ("mean H", 1 / RADIUS), ("Gaussian K", RADIUS**-2)):
            for value in rows[name]:
                self.assertAlmostEqual(value, truth, delta=0.02 * truth, msg=name)
        self.assertRegex(result.stdout, r"border points +0 of")
        self.assertRegex(result.stdout, r"unknown +0 of")

    def test_every_estimator(self):
        words = run("curvature", "--help").stdout
        names = re.search(r"--estimator TEXT:\{([^}]*)\}", words).group(1).split(",")
        self.assertIn("per-face", names)
        for name in names:
            with self.subTest(estimator=name):
                result = self.run_well("curvature", self.sphere, "--estimator", name)
                self.assertRegex(result.stdout, r"estimator +" + name)
                self.assertAlmostEqual(self.statistics(result.stdout)["k1"][2], 1 / RADIUS, delta=0.02)

    @unittest.skipIf(vtkXMLPolyDataReader is None, "needs VTK's Python package")
    def test_arrays(self):
        for extension, kind in ((".vtp", vtkXMLPolyDataReader), (".vtk", vtkPolyDataReader)):
            with self.subTest(extension=extension):
                path = self.path("out" + extension)
                result = self.run_well("curvature", self.saddle, "-o", path, "--quiet")
                self.assertEqual(result.stdout + result.stderr, "")
                reader = kind()
                reader.SetFileName(path)
                reader.Update()
                surface = reader.GetOutput()
                self.assertEqual(surface.GetNumberOfPoints(), 31 * 31)
                self.assertEqual(surface.GetNumberOfPolys(), 2 * 30 * 30)
                for name, size in ARRAYS.items():
                    array = surface.GetPointData().GetArray(name)
                    self.assertIsNotNone(array, name)
                    self.assertEqual(array.GetNumberOfComponents(), size, name)
                middle = surface.FindPoint(0.0, 0.0, 0.0)
                self.assertAlmostEqual(surface.GetPointData().GetArray("GaussianCurvature").GetValue(middle), -1.0, delta=0.05)

    def test_pictures(self):
        for name in ("k1", "k2", "mean", "gaussian", "shape-index", "curvedness"):
            with self.subTest(show=name):
                self.run_well("curvature", self.saddle, "-o", self.image, "--show", name, "--size", "320x300", "--view", "40,60", "--up", "z")
                width, height, channels, _ = read_png(self.image)
                self.assertEqual((width, height, channels), (320, 300, 3))
                red, blue, _ = colours(self.image)
                if name == "gaussian":
                    self.assertGreater(blue, 5000, "a saddle's Gaussian curvature is negative")
                    self.assertLess(red, 500)
                if name == "k1":
                    # |k1| and |k2| are equal along the diagonals: k1 is the hill on two sides, the hollow on the others.
                    self.assertGreater(red, 2000)
                    self.assertGreater(blue, 2000)
                os.remove(self.image)
        # On a saddle strokes are all over; on a sphere all directions are alike, and there are none.
        ink = []
        for model in (self.saddle, self.sphere):
            self.run_well("curvature", model, "-o", self.image, "--show", "directions", "--size", "640x600", "--view", "40,60", "--up", "z")
            ink.append(colours(self.image)[2])
        self.assertGreater(ink[0], 3 * ink[1])
        self.run_well("curvature", self.sphere, "-o", self.image, "--size", "320x300")
        red, blue, _ = colours(self.image)
        self.assertGreater(red, 10000, "a sphere bends outwards everywhere")
        self.assertEqual(blue, 0)

    def test_small_pictures_have_no_legend(self):
        self.run_well("curvature", self.sphere, "-o", self.image, "--size", "64x48")
        self.assertEqual(read_png(self.image)[:2], (64, 48))

    def test_sample(self):
        result = self.run_well("curvature", "--sample")
        self.assertEqual(len(self.statistics(result.stdout)), 4)

    def test_info_says_the_same(self):
        here = self.statistics(self.run_well("info", self.sphere).stdout)
        self.assertEqual(here, self.statistics(self.run_well("curvature", self.sphere).stdout))

    def test_bad_words(self):
        out = self.path("out.vtp")
        for words, part in (
            (["curvature"], "one model file, or --sample"),
            (["curvature", self.sphere, self.saddle], "one model file"),
            (["curvature", self.sphere, "--sample"], "one model file"),
            (["curvature", self.sphere, "-o", self.path("out.ply")], ".vtp or .vtk"),
            (["curvature", self.sphere, "-o", out, "--show", "k1"], "--show draws a picture"),
            (["curvature", self.sphere, "--show", "k1"], "--show draws a picture"),
            (["curvature", self.sphere, "-o", self.image, "--show", "beauty"], "beauty"),
            (["curvature", self.sphere, "-o", self.image, "--size", "big"], "--size"),
            (["curvature", self.sphere, "-o", self.image, "--view", "behind"], "--view"),
            (["curvature", self.sphere, "--estimator", "guess"], "guess"),
            (["curvature", self.sphere, "--smoothing", "-1"], "--smoothing"),
            (["curvature", self.sphere, "--radius", "wide"], "--radius"),
            (["curvature", self.sphere, "--radius", "nan"], "--radius"),
            (["curvature", self.sphere, "--radius", "1000"], "1.5 to 40"),
        ):
            with self.subTest(words=words[2:]):
                result = run(*words)
                self.assertEqual(result.returncode, 1, result.stderr)
                self.assertIn(part, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertFalse(os.path.exists(out))

    def test_bad_files(self):
        nowhere = os.path.join(self.folder, "nowhere", "out.vtp")
        flat = self.write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n")
        for code, words in (
            (2, ["curvature", self.path("missing.obj")]),
            (2, ["curvature", flat]),
            (3, ["curvature", self.sphere, "-o", nowhere]),
            (3, ["curvature", self.sphere, "-o", os.path.join(self.folder, "nowhere", "out.png")]),
        ):
            with self.subTest(words=words[1:]):
                result = run(*words)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertFalse(os.path.exists(nowhere))


if __name__ == "__main__":
    unittest.main()
