# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""npr render writes vector drawings: layers, hidden lines, true scale, and what it refuses."""

import math
import os
import re
import subprocess
import sys
import unittest
import xml.etree.ElementTree as ElementTree

from commandtest import CommandTest, read_png, run, write_png

COMPARE, RSVG_CONVERT = sys.argv.pop(1), sys.argv.pop(1)
USAGE, OUTPUT = 1, 3
SVG = "{http://www.w3.org/2000/svg}"
INKSCAPE = "{http://www.inkscape.org/namespaces/inkscape}"


def box(x, y, z):
    """An OBJ file of a box with its least corner at the origin."""
    corners = [(i & 1, i >> 1 & 1, i >> 2) for i in range(8)]
    faces = ((1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6))
    lines = [f"v {x * a} {y * b} {z * c}" for a, b, c in corners]
    return "\n".join(lines + ["f " + " ".join(map(str, face)) for face in faces]) + "\n"


def ball(rows):
    """An OBJ file of a sphere, of quadrilaterals but for its poles."""
    columns = 2 * rows
    text = ["v 0 1 0", "v 0 -1 0"]
    for row in range(1, rows):
        down = math.pi * row / rows
        for column in range(columns):
            around = 2 * math.pi * column / columns
            text.append(f"v {math.sin(down) * math.sin(around)} {math.cos(down)} {math.sin(down) * math.cos(around)}")
    for column in range(columns):
        here, after = 3 + column, 3 + (column + 1) % columns
        last = (rows - 2) * columns
        text += [f"f 1 {here} {after}", f"f 2 {last + after} {last + here}"]
        for row in range(0, last, columns):
            text.append(f"f {row + here} {row + columns + here} {row + columns + after} {row + after}")
    return "\n".join(text) + "\n"


def path_points(data):
    """The points and control points of a path of SVG."""
    points, place, start, command = [], (0.0, 0.0), (0.0, 0.0), ""
    tokens = re.findall(r"[A-Za-z]|-?(?:\d+\.?\d*|\.\d+)", data)
    while tokens:
        if tokens[0].isalpha():
            command = tokens.pop(0)
        if command in "Zz":
            place = start
            continue
        origin = place if command.islower() else (0.0, 0.0)
        for _ in range(3 if command in "Cc" else 1):
            x = origin[0] + float(tokens.pop(0)) if command not in "Vv" else place[0]
            y = origin[1] + float(tokens.pop(0)) if command not in "Hh" else place[1]
            end = (x, y)
            points.append(end)
        place = end
        if command in "Mm":
            start, command = place, "L" if command == "M" else "l"
    return points


class Drawing:
    """What an SVG file of ours says."""

    def __init__(self, path):
        self.root = ElementTree.parse(path).getroot()
        self.layers = {group.get(INKSCAPE + "label"): group for group in self.root.findall(SVG + "g")}
        self.has_image = self.root.find(".//" + SVG + "image") is not None

    def size(self):
        """Width and height of all lines."""
        points = []
        for group in self.layers.values():
            for path in group.iter(SVG + "path"):
                points += path_points(path.get("d"))
        return tuple(max(p[i] for p in points) - min(p[i] for p in points) for i in (0, 1))


class TestDrawings(CommandTest):
    def draw(self, model, *words, name="drawing.svg", **options):
        path = self.path(name)
        self.run_well("render", model, "-o", path, *words, **options)
        return Drawing(path) if name.endswith(".svg") else path

    def refuse(self, words, code, *mentioned, name="drawing.svg", model="none.stl"):
        """Before the model is even read, unless there is one."""
        path = self.path(name)
        result = run("render", model, "-o", path, *words)
        self.assertEqual(result.returncode, code, result.stderr)
        for text in mentioned:
            self.assertIn(text, result.stderr)
        self.assertFalse(os.path.exists(path))

    def test_hidden_lines_are_layers(self):
        model = self.write("box.obj", box(4, 3, 2))
        ink = ("--style", "ink")
        none = self.draw(model, *ink)
        self.assertTrue(any(name.endswith("(visible)") for name in none.layers))
        self.assertFalse([name for name in none.layers if "hidden" in name])
        for hidden, is_dashed in (("dashed", True), ("shown", False)):
            drawing = self.draw(model, *ink, "--hidden", hidden)
            layers = [group for name, group in drawing.layers.items() if name.endswith("(hidden)")]
            # Of a box, three edges are hidden; they meet at a corner.
            paths = [path for layer in layers for path in layer.iter(SVG + "path")]
            self.assertTrue(1 <= len(paths) <= 3, len(paths))
            self.assertEqual(all("stroke-dasharray" in layer.attrib for layer in layers), is_dashed)

    def test_scale_is_exact(self):
        model = self.write("box.obj", box(40, 30, 20))
        front = ("--style", "ink", "--view", "front", "--projection", "parallel")
        for words, factor in (
            (["--scale", "1:2"], 0.5),
            (["--scale", "5:2"], 2.5),
            (["--scale", "1:20", "--unit", "cm"], 0.5),
            (["--scale", "1:1", "--paper", "60x50"], 1.0),
            (["--scale", "1:1", "--paper", "Letter", "--size", "300x900"], 1.0),
        ):
            with self.subTest(words=words):
                width, height = self.draw(model, *front, *words).size()
                self.assertAlmostEqual(width, factor * 40, delta=0.003)
                self.assertAlmostEqual(height, factor * 30, delta=0.003)

    def test_paper(self):
        for words, width, height in (
            ([], "297mm", "210mm"),
            (["--paper", "a3"], "420mm", "297mm"),
            (["--paper", "Letter", "--size", "600x800"], "215.9mm", "279.4mm"),
            (["--paper", "120x80.5"], "120mm", "80.5mm"),
        ):
            with self.subTest(words=words):
                root = self.draw(self.model, "--style", "ink", *words).root
                self.assertEqual((root.get("width"), root.get("height")), (width, height))

    def test_scale_bar(self):
        parallel = ("--style", "ink", "--projection", "parallel")
        self.assertIn("scale bar", " ".join(self.draw(self.model, *parallel, "--scale-bar").layers))
        self.assertNotIn("scale bar", " ".join(self.draw(self.model, *parallel).layers))

    def test_styles_are_honoured(self):
        style = self.write(
            "mine.json",
            """{ "name": "mine", "shading": { "style": "paper" }, "strokes": { "cap": "butt" },
            "lines": [ { "type": "creases", "width": 4, "color": "#ff8000", "opacity": 0.5,
                         "dashes": [10, 5] } ] }""",
        )
        layer = self.draw(self.model, "--style", style, "--size", "800x600").layers["creases (visible)"]
        unit = 0.19  # mm: a thousandth of the 190 mm that A4 leaves within its margins
        self.assertAlmostEqual(float(layer.get("stroke-width")), 4 * unit, places=3)
        self.assertEqual(layer.get("stroke"), "#ff8000")
        self.assertEqual(layer.get("stroke-linecap"), "butt")
        dashes = [float(length) for length in layer.get("stroke-dasharray").split()]
        self.assertEqual([round(length / unit, 2) for length in dashes], [10, 5])
        self.assertFalse(self.draw(self.model, "--style", style, "--lines", "none").layers)

    def test_shading(self):
        for words, has_image in (
            ([], True),
            (["--shading", "none"], False),
            (["--hidden", "dashed"], False),
            (["--hidden", "dashed", "--shading", "image"], True),
            (["--style", "ink"], False),
            (["--style", "toon", "--background", "transparent"], True),
        ):
            with self.subTest(words=words):
                self.assertEqual(self.draw(self.model, *words).has_image, has_image)

    def test_lines_need_no_graphics(self):
        environment = {"NPR_OFFSCREEN": "none of them"}
        self.draw(self.model, "--style", "ink", environment=environment)
        result = run("render", self.model, "-o", self.image, environment=environment)
        self.assertEqual(result.returncode, 4)

    def test_the_same_bytes_on_every_run(self):
        for name in ("drawing.svg", "drawing.pdf"):
            files = []
            for threads in ("1", "3"):
                self.draw(self.model, "--style", "pencil", name=name,
                          environment={"VTK_SMP_MAX_THREADS": threads, "TBB_NUM_THREADS": threads})
                with open(self.path(name), "rb") as file:
                    files.append(file.read())
            self.assertEqual(files[0], files[1])

    def test_pdf(self):
        with open(self.draw(self.model, name="drawing.pdf"), "rb") as file:
            self.assertTrue(file.read().startswith(b"%PDF-"))

    def test_images_by_the_surfaces_or_by_the_depth_buffer(self):
        dark = {}
        seconds = {}
        for visibility in ("exact", "depth"):
            words = ["--style", "ink", "--size", "300x300", "--visibility", visibility, "--verbose"]
            result = self.run_well("render", self.model, "-o", self.image, *words)
            seconds[visibility] = float(re.search(r"visibility +([\d.]+) s", result.stderr).group(1))
            rows = read_png(self.image)[3]
            dark[visibility] = sum(1 for row in rows for value in row if value < 64)
        self.assertGreater(dark["exact"], 1000)
        self.assertAlmostEqual(dark["exact"] / dark["depth"], 1, delta=0.05)
        self.assertEqual(seconds["depth"], 0)
        self.refuse(["--visibility", "exact"], USAGE, "--visibility", "images")
        self.refuse(["--visibility", "guess"], USAGE, "--visibility", name="other.png")

    def test_demo(self):
        self.run_well("demo", self.folder, "--size", "160x120")
        self.assertTrue(any("hidden" in name for name in Drawing(self.path("drawing.svg")).layers))
        with open(self.path("index.html")) as page:
            self.assertIn("drawing.svg", page.read())

    def test_refusals(self):
        parallel = ["--projection", "parallel"]
        for words, mentioned in (
            (["--scale", "1:2"], "--projection parallel"),
            (["--scale-bar"], "--projection parallel"),
            (parallel + ["--scale", "2"], "1:2"),
            (parallel + ["--scale", "1:0"], "1:0"),
            (parallel + ["--scale", "1:nan"], "1:nan"),
            (["--paper", "A9"], "A9"),
            (["--paper", "10x10"], "10x10"),
            (["--paper", "100x"], "100x"),
            (["--unit", "ell"], "ell"),
            (["--hidden", "maybe"], "maybe"),
            (["--shading", "lots"], "lots"),
        ):
            with self.subTest(words=words):
                self.refuse(words, USAGE, mentioned)
        for words in (["--hidden", "dashed"], ["--scale", "1:1"], ["--paper", "A4"], ["--scale-bar"]):
            with self.subTest(words=words):
                self.refuse(words, USAGE, words[0], ".svg", name="image.png")
        self.refuse([], OUTPUT, "mkdir", name="no/such/folder/drawing.pdf")
        self.refuse([], USAGE, ".svg", name="drawing.dxf")

    def test_too_large_for_the_paper(self):
        model = self.write("box.obj", box(400, 300, 20))
        words = ["--view", "front", "--projection", "parallel", "--scale"]
        self.refuse(words + ["1:1"], USAGE, "400 x 300 mm", "277 x 190 mm", "1:2", model=model)
        self.draw(model, *words, "1:2", "--style", "ink")

    def test_too_small_for_the_paper(self):
        model = self.write("box.obj", box(400, 300, 20))
        words = ["--view", "front", "--projection", "parallel", "--style", "ink", "--scale"]
        fitting = "take --scale 1:2, a smaller --paper, or another --unit than mm"
        self.refuse(words + ["1:1000000"], USAGE, "0.0004 x 0.0003 mm", "277 x 190 mm", fitting, model=model)
        path = self.path("small.svg")
        for scale, warning in (("1:20", "20 x 15 mm"), ("1:10", "")):
            with self.subTest(scale=scale):
                result = self.run_well("render", model, "-o", path, *words, scale)
                self.assertIn(warning, result.stderr)
                self.assertEqual(result.stderr.count(fitting), 1 if warning else 0, result.stderr)
        self.assertEqual(self.run_well("render", model, "-o", path, *words, "1:20", "--quiet").stderr, "")

    def test_tones(self):
        model = self.write("ball.obj", ball(24))
        drawing = self.draw(model, "--style", "toon", "--shading", "tones")
        self.assertFalse(drawing.has_image)
        self.assertEqual(list(drawing.layers)[0], "tones")
        fills = [path.get("fill") for path in drawing.layers["tones"].iter(SVG + "path")]
        self.assertEqual(fills, ["#e8a15c", "#b57e48", "#795430"])  # 1, 0.78 and 0.52 of the style's colour
        with open(self.path("drawing.svg")) as file:
            self.assertLess(len(file.read()), 15000)
        dashed = self.draw(model, "--style", "toon", "--shading", "tones", "--hidden", "dashed", "--outline", "back-faces")
        self.assertEqual(len(list(dashed.layers["tones"].iter(SVG + "path"))), 3)
        self.refuse(["--style", "ink", "--shading", "tones"], USAGE, "toon", name="refused.svg")
        self.refuse(["--style", "technical", "--shading", "tones"], USAGE, "toon", name="refused.svg", model=model)

    def test_pixels_are_those_of_images(self):
        """Five pixels to a millimetre; the page has margins of 10 mm around the picture."""
        for words, model in (
            (["--style", "ink"], self.write("box.obj", box(4, 3, 2))),
            (["--style", "toon", "--shading", "tones"], self.write("ball.obj", ball(24))),
        ):
            with self.subTest(words=words):
                size = ["--size", "800x600"]
                self.run_well("render", model, "-o", self.image, *words[:2], *size)
                self.draw(model, *words, *size, "--paper", "180x140")
                page = self.path("page.png")
                subprocess.run([RSVG_CONVERT, "-b", "white", "-d", "127", "-p", "127", self.path("drawing.svg"), "-o", page],
                               check=True)
                width, height, channels, rows = read_png(page)
                self.assertEqual((width, height), (900, 700))
                picture = [row[50 * channels : 850 * channels] for row in rows[50:650]]
                write_png(page, 800, 600, channels, picture)
                result = subprocess.run([COMPARE, self.image, page, "--ink-amount", "0.1", "--local-ssim", "0.6"],
                                        capture_output=True, text=True)
                self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
