# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""The verbs of npr do what their help says."""

import math
import os
import re
import signal
import struct
import subprocess
import time
import unittest

try:
    from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
except ImportError:
    vtkXMLPolyDataReader = None

from commandtest import NPR, TETRAHEDRON, CommandTest, read_png, run

TETRAHEDRON_STL = """SOLID tetrahedron
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 1 0
vertex 1 0 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 1 0 0
vertex 0 0 1
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 0 0 0
vertex 0 0 1
vertex 0 1 0
endloop
endfacet
facet normal 0 0 0
outer loop
vertex 1 0 0
vertex 0 1 0
vertex 0 0 1
endloop
endfacet
ENDSOLID tetrahedron
"""


def read_segments(path):
    """The segments of all polylines, each as its two points."""
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    lines = reader.GetOutput()
    segments = []
    for i in range(lines.GetNumberOfCells()):
        points = lines.GetCell(i).GetPoints()
        chain = [points.GetPoint(j) for j in range(points.GetNumberOfPoints())]
        segments += zip(chain, chain[1:])
    return segments


def edge_of(segment, corners):
    """The edge between two of the corners that the segment lies on; None if on no one."""
    for i, a in enumerate(corners):
        for b in corners[:i]:
            if all(abs(math.dist(a, p) + math.dist(p, b) - math.dist(a, b)) < 1e-6 for p in segment):
                return (a, b)
    return None


STYLES = ("technical", "toon", "ink", "pencil", "brush", "plain")


class TestCommand(CommandTest):
    def test_render_in_every_style(self):
        for style in STYLES:
            with self.subTest(style=style):
                result = self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "160x120")
                self.assertEqual(result.stderr, "", "nothing is said when stderr is no terminal")
                width, height, channels, rows = read_png(self.image)
                self.assertEqual((width, height, channels), (160, 120, 3))
                self.assertGreaterEqual(min(rows[0][:3]), 0xF0, "white paper")
                self.assertTrue(any(min(row) < 200 for row in rows), "something is drawn")
                os.remove(self.image)

    def test_ink_is_black_on_white(self):
        self.run_well("render", self.model, "-o", self.image, "--style", "ink", "--size", "200x200")
        _, _, channels, rows = read_png(self.image)
        dark = sum(1 for row in rows for x in range(0, len(row), channels) if row[x] < 64)
        light = sum(1 for row in rows for x in range(0, len(row), channels) if row[x] > 250)
        self.assertGreater(dark, 300)
        self.assertGreater(light, 0.8 * 200 * 200)

    def test_lines_none(self):
        self.run_well("render", self.model, "-o", self.image, "--style", "ink", "--lines", "none", "--size", "64x64")
        _, _, _, rows = read_png(self.image)
        self.assertTrue(all(min(row) == 255 for row in rows))

    def test_background(self):
        self.run_well("render", self.model, "-o", self.image, "--background", "#204060", "--size", "64x64")
        self.assertEqual(bytes(read_png(self.image)[3][0][:3]), b"\x20\x40\x60")

    def test_transparent_background(self):
        self.run_well("render", self.model, "-o", self.image, "--background", "transparent", "--size", "64x64")
        _, _, channels, rows = read_png(self.image)
        self.assertEqual(channels, 4)
        alphas = [row[x + 3] for row in rows for x in range(0, len(row), 4)]
        self.assertEqual(alphas[0], 0)
        self.assertEqual(max(alphas), 255)
        self.run_well("render", self.model, "-o", self.image, "--style", "ink", "--background", "transparent", "--size", "200x200")
        rows = read_png(self.image)[3]
        ink = sum(1 for row in rows for x in range(0, len(row), 4) if row[x] < 64 and row[x + 3] > 200)
        self.assertGreater(ink, 300, "ink is opaque")

    def test_views_and_projections(self):
        for words in (
            ["--view", "front"],
            ["--view", "10,-20"],
            ["--view=-90,0", "--up", "z"],
            ["--projection", "parallel"],
            ["--eye", "3,2,4"],
            ["--eye", "3,2,4", "--target", "0.2,0.2,0.2", "--up", "0,0,1", "--projection", "parallel"],
        ):
            with self.subTest(words=words):
                self.run_well("render", self.model, "-o", self.image, "--size", "80x60", *words)
                rows = read_png(self.image)[3]
                self.assertTrue(any(min(row) < 160 for row in rows), "the model is in the image")

    def test_image_kinds(self):
        for extension, magic in ((".jpg", b"\xff\xd8"), (".bmp", b"BM"), (".ppm", b"P6"), (".tif", b"II")):
            with self.subTest(extension=extension):
                path = self.path("image" + extension)
                self.run_well("render", self.model, "-o", path, "--size", "32x32")
                with open(path, "rb") as file:
                    self.assertTrue(file.read(2) == magic)

    def test_render_the_sample(self):
        folder = self.path("demo")
        size = ("--size", "160x120")
        self.run_well("demo", folder, *size)
        self.run_well("render", "--sample", "-o", self.image, "--style", "ink", *size)
        self.assertEqual(read_png(self.image), read_png(os.path.join(folder, "ink.png")))
        self.run_well("render", "--sample", "-o", self.path("sample.svg"), "--style", "ink")

    def test_several_models(self):
        other = self.write("other.obj", TETRAHEDRON.replace("v 0 0 0", "v 2 2 2"))
        self.run_well("render", self.model, other, "-o", self.image, "--size", "64x64")

    def test_same_image_again(self):
        images = []
        for _ in range(2):
            self.run_well("render", self.model, "-o", self.image, "--size", "100x100")
            with open(self.image, "rb") as file:
                images.append(file.read())
        self.assertEqual(images[0], images[1])

    def test_verbose_and_quiet(self):
        words = ["render", self.model, "-o", self.image, "--size", "32x32"]
        verbose = self.run_well(*words, "--verbose").stderr
        for stage in ("read", "prepare", "curvature", "lines", "draw", "peak memory"):
            self.assertIn(stage, verbose)
        self.assertEqual(self.run_well(*words, "--quiet").stderr, "")

    def test_interrupt_while_writing(self):
        command = [NPR, "render", self.model, "-o", self.image, "--size", "6000x4500", "--lines", "none"]
        process = subprocess.Popen(command, stderr=subprocess.DEVNULL)
        while process.poll() is None and not any(name.startswith(".part") for name in os.listdir(self.folder)):
            time.sleep(0.01)
        process.send_signal(signal.SIGINT)
        self.assertNotEqual(process.wait(60), 0)
        self.assertEqual(os.listdir(self.folder), ["model.obj"])

    def test_style_file(self):
        style = self.write("mine.json", self.run_well("styles", "--show", "ink").stdout.replace("#ffffff", "#ff0000"))
        self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "32x32")
        self.assertEqual(bytes(read_png(self.image)[3][0][:3]), b"\xff\x00\x00")

    def test_styles(self):
        listed = self.run_well("styles").stdout
        for style in STYLES:
            self.assertIn(style, listed)

    def test_set(self):
        few, many = self.path("few.vtp"), self.path("many.vtp")
        self.run_well("lines", self.model, "-o", few, "--lines", "topographic", "--set", "topographic.levels=2",
                      "--set", "topographic.direction=0,1,0")
        self.run_well("lines", self.model, "-o", many, "--lines", "topographic", "--set", "topographic.levels=8")
        self.assertLess(len(read_segments(few)), len(read_segments(many)))

    @unittest.skipUnless(vtkXMLPolyDataReader, "needs VTK's Python modules")
    def test_heights_are_upwards(self):
        stl = self.write("model.stl", TETRAHEDRON_STL)
        style = self.write("map.json", '{"lines": [{"type": "topographic", "direction": [1, 0, 0]}]}')
        path = self.path("lines.vtp")
        for model, words, axis in (
            (self.model, [], 1),
            (stl, [], 2),
            (stl, ["--up", "x"], 0),
            (self.model, ["--eye", "3,2,4", "--up", "0,0,2"], 2),
            (self.model, ["--set", "topographic.direction=3,0,0"], 0),
        ):
            with self.subTest(words=words):
                self.run_well("lines", model, "-o", path, "--lines", "topographic", *words)
                segments = read_segments(path)
                self.assertGreater(len(segments), 10)
                for a, b in segments:
                    self.assertAlmostEqual(a[axis], b[axis], 5)
        images = []
        for words in (["--up", "y"], ["--set", "topographic.direction=0,1,0"], ["--set", "topographic.direction=0,0,1"]):
            self.run_well("render", self.model, "-o", self.image, "--lines", "topographic", "--style", "ink", "--size", "64x64", *words)
            images.append(read_png(self.image)[3])
        self.assertEqual(images[0], images[1])
        self.assertNotEqual(images[0], images[2])
        self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "64x64")
        of_style = read_png(self.image)[3]
        self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "64x64", "--set", "topographic.direction=1,0,0")
        self.assertEqual(of_style, read_png(self.image)[3], "what a style says counts")

    def test_lines(self):
        path = self.path("lines.vtp")
        self.run_well("lines", self.model, "-o", path, "--lines", "creases")
        with open(path, "rb") as file:
            content = file.read()
        self.assertIn(b"LineType", content)
        self.assertIn(b"Strength", content)

    def test_list_of_lines(self):
        rows = self.run_well("lines", "--list").stdout.splitlines()
        columns = [rows[0].index(word) for word in ("MOVES", "SHOWS", "PARAMETERS")]
        kinds = {}
        for row in rows[1:]:
            self.assertTrue(all(row[column - 1] == " " != row[column] for column in columns), row)
            name, moves, shows, parameters = (
                row[start:end].strip() for start, end in zip([0, *columns], [*columns, None])
            )
            self.assertTrue(shows)
            kinds[name] = (moves, parameters)
        for name in ("contours", "contour-edges", "suggestive"):
            self.assertEqual(kinds[name][0], "with view")
        for name in ("ridges", "valleys", "creases", "boundaries", "non-manifold", "region-borders"):
            self.assertEqual(kinds[name][0], "-")
        self.assertIn("angle 40", kinds["creases"][1])
        self.assertEqual(kinds["boundaries"][1], "-")
        self.assertEqual(kinds["region-borders"][1], 'array "RegionId"')

    def test_define(self):
        path = self.path("lines.vtp")
        self.run_well(
            "lines", self.model, "-o", path, "--lines", "cut,creases",
            "--define", "cut", "-px + part", "py > 0.1 and pz > 0.1", "--define", "heap", "pz - half", "",
            "--constant", "part=0.2", "--constant", "half=0.5",
        )  # fmt: skip
        with open(path, "rb") as file:
            content = file.read()
        self.assertIn(b"LineTypeNames", content)
        if vtkXMLPolyDataReader:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(path)
            reader.Update()
            lines = reader.GetOutput()
            names = lines.GetFieldData().GetAbstractArray("LineTypeNames")
            self.assertEqual([names.GetValue(i) for i in range(3)], ["cut", "creases", "heap"])
            types = lines.GetCellData().GetArray("LineType")
            for i in range(lines.GetNumberOfCells()):
                (x0, x1, y0, _, z0, z1) = lines.GetCell(i).GetBounds()
                if types.GetValue(i) == 0:
                    self.assertAlmostEqual(x0, 0.2, 5)
                    self.assertAlmostEqual(x1, 0.2, 5)
                    self.assertGreater(min(y0, z0), 0.1 - 1e-5)
                elif types.GetValue(i) == 2:
                    self.assertAlmostEqual(z0, 0.5, 5)
                    self.assertAlmostEqual(z1, 0.5, 5)
        self.run_well("render", self.model, "-o", self.image, "--style", "ink", "--size", "64x64")
        before = read_png(self.image)[3]
        self.run_well("render", self.model, "-o", self.image, "--style", "ink", "--size", "64x64", "--define", "cut", "pz - 0.4", "")
        self.assertNotEqual(before, read_png(self.image)[3], "what is defined is drawn")
        result = run("render", self.model, "-o", self.image, "--define", "cut", "pz - 0.4", "foo > 2")
        self.assertEqual(result.returncode, 2, "lines that do not fit the model: " + result.stderr)

    def test_quantities(self):
        path = self.path("lines.vtp")
        self.run_well("lines", self.model, "-o", path, "--lines", "creases", "--quantities", "K,ndotv,p")
        if vtkXMLPolyDataReader:
            reader = vtkXMLPolyDataReader()
            reader.SetFileName(path)
            reader.Update()
            lines = reader.GetOutput()
            for name, components in (("K", 1), ("ndotv", 1), ("p", 3)):
                array = lines.GetPointData().GetArray(name)
                self.assertEqual(array.GetNumberOfTuples(), lines.GetNumberOfPoints())
                self.assertEqual(array.GetNumberOfComponents(), components)
            places = lines.GetPointData().GetArray("p")
            for i in range(lines.GetNumberOfPoints()):
                for a, b in zip(places.GetTuple(i), lines.GetPoint(i)):
                    self.assertAlmostEqual(a, b, 5)
        for code, quantities, *said in (
            (1, "K,Strength", "--quantities", '"Strength"'),
            (2, "Heat", '"Heat"', "no point arrays"),
            (2, "n.x", '"n.x"', "ndotv, sintheta, kr, dwkr, k1, k2, K, H, P, Q, S, T, e1, e2, n, v, w, p"),
        ):
            with self.subTest(quantities=quantities):
                result = run("lines", self.model, "-o", path, "--quantities", quantities)
                self.assertEqual(result.returncode, code, result.stderr)
                for text in said:
                    self.assertIn(text, result.stderr)

    def test_define_wrongly(self):
        path = self.path("lines.vtp")
        for code, words, *said in (
            (1, ["--define", "a", "kr +", ""], "--define a", '"kr +"', "column 5"),
            (1, ["--define", "a", "kr", "K > ("], "test", "column 5"),
            (1, ["--define", "a b", "kr", ""], "name"),
            (1, ["--define", "contours", "kr", ""], "--define contours", "built-in"),
            (1, ["--define", "a", "kr", "", "--define", "a", "K", ""], "--define a", "twice"),
            (1, ["--define", "a", "", ""], "no field"),
            (1, ["--define", "a", "kr"], "FIELD"),
            (1, ["--define", "a", "kr", "", "--constant", "K=2"], "K=2"),
            (1, ["--constant", "b=2"], "--define"),
            (2, ["--define", "a", "kr + krr", ""], "'krr'", "column 6", "dwkr"),
        ):
            with self.subTest(words=words):
                result = run("lines", self.model, "-o", path, *words)
                self.assertEqual(result.returncode, code, result.stderr)
                for text in said:
                    self.assertIn(text, result.stderr)
                self.assertFalse(os.path.exists(path))

    def check_creases(self, segments, *offsets):
        """The six edges of a tetrahedron at each offset, each covered once."""
        corners = [(o + x, y, z) for o in offsets for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
        edges = [edge_of(segment, corners) for segment in segments]
        self.assertNotIn(None, edges)
        self.assertEqual(len(set(edges)), 6 * len(offsets))
        length = sum(math.dist(*segment) for segment in segments)
        self.assertAlmostEqual(length, (3 + 3 * math.sqrt(2)) * len(offsets), 5)

    @unittest.skipUnless(vtkXMLPolyDataReader, "needs VTK's Python modules")
    def test_lines_are_the_creases(self):
        path = self.path("lines.vtp")
        self.run_well("lines", self.model, "-o", path, "--lines", "creases")
        self.check_creases(read_segments(path), 0)

    @unittest.skipUnless(vtkXMLPolyDataReader, "needs VTK's Python modules")
    def test_lines_of_two_models(self):
        points = {"v 0 ": "v 5 ", "v 1 ": "v 6 "}
        other = self.write("other.obj", "".join(points.get(row[:4], row[:4]) + row[4:] for row in TETRAHEDRON.splitlines(True)))
        path = self.path("lines.vtp")
        self.run_well("lines", self.model, other, "-o", path, "--lines", "creases, boundaries")
        self.check_creases(read_segments(path), 0, 5)

    def test_up_axis(self):
        def image(*words):
            self.run_well("render", *words, "-o", self.image, "--size", "48x48")
            with open(self.image, "rb") as file:
                return file.read()

        stl = self.write("model.stl", TETRAHEDRON_STL)
        self.assertNotEqual(image(stl, "--up", "z"), image(stl, "--up", "y"))
        self.assertEqual(image(stl), image(stl, "--up", "z"), "CAD has z up")
        self.assertEqual(image(self.model), image(self.model, "--up", "y"))
        self.assertEqual(image(stl, self.model), image(stl, self.model, "--up", "y"), "they do not agree")

    def test_list_with_blanks(self):
        self.run_well("render", self.model, "-o", self.image, "--lines", "contours, creases ", "--size", "32x32")

    def test_info_reads_a_volume_as_render_does(self):
        size = 12
        values = b"".join(
            struct.pack("<f", 1.0 if math.dist((x, y, z), (5.5, 5.5, 5.5)) < 3.2 else 0.0)
            for z in range(size)
            for y in range(size)
            for x in range(size)
        )
        header = f"NRRD0004\ntype: float\ndimension: 3\nsizes: {size} {size} {size}\nendian: little\nencoding: raw\n\n"
        path = self.write("ball.nrrd", header.encode() + values)
        usual, smoothed, raw = (
            self.run_well("info", path, "--iso", "0.5", *words).stdout
            for words in ([], ["--volume-smoothing", "1"], ["--volume-smoothing", "0"])
        )
        self.assertEqual(usual, smoothed, "render smooths by one voxel")
        self.assertNotEqual(usual, raw)

    def test_info(self):
        text = self.run_well("info", self.model).stdout
        self.assertIn("points         4", text)
        self.assertIn("polygons       4", text)
        self.assertIn(".ply", self.run_well("info", "--formats").stdout)

    def test_doctor(self):
        for backend, window in (("osmesa", "OSMesa"), ("egl", "EGL")):
            with self.subTest(backend=backend):
                text = self.run_well("doctor", environment={"NPR_OFFSCREEN": backend}).stdout
                for line in ("VTK", "threads", "window", "GL renderer", "GL version", "not taken"):
                    self.assertIn(line, text)
                self.assertIn(window, text)

    def test_names_of_backends_agree(self):
        text = self.run_well("doctor").stdout
        listed = {row.split()[0] for row in text.splitlines() if "taken: " in row}
        self.assertEqual(listed, {"native", "egl", "osmesa"})
        result = run("doctor", environment={"NPR_OFFSCREEN": "abacus"})
        known = re.search(r"one of ([\w, ]+), or unset", result.stderr).group(1).split(", ")
        self.assertEqual(set(known), listed | {"auto"})
        for name in known:
            result = run("doctor", environment={"NPR_OFFSCREEN": name})
            self.assertNotIn("unknown value", result.stderr)

    def test_demo(self):
        folder = self.path("demo")
        self.run_well("demo", folder, "--size", "160x120")
        with open(os.path.join(folder, "index.html")) as page:
            index = page.read()
        for style in STYLES:
            self.assertIn(style + ".png", index)
            self.assertEqual(read_png(os.path.join(folder, style + ".png"))[:2], (160, 120))

    def test_help(self):
        for words in (["--help"], ["render", "--help"], ["lines", "--help"]):
            self.assertIn("xample", self.run_well(*words).stdout)
        self.assertEqual(run("--version").stdout.split()[0], "npr")


if __name__ == "__main__":
    unittest.main()
