# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""The verbs of npr do what their help says."""

import os
import unittest

from commandtest import TETRAHEDRON, CommandTest, read_png, run

STYLES = ("technical", "toon", "ink", "plain")


class TestCommand(CommandTest):
    def test_render_in_every_style(self):
        for style in STYLES:
            with self.subTest(style=style):
                result = self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "160x120")
                self.assertEqual(result.stderr, "", "nothing is said when stderr is no terminal")
                width, height, channels, rows = read_png(self.image)
                self.assertEqual((width, height, channels), (160, 120, 3))
                self.assertEqual(bytes(rows[0][:3]), b"\xff\xff\xff", "white paper")
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

    def test_style_file(self):
        style = self.write("mine.json", self.run_well("styles", "--show", "ink").stdout.replace("#ffffff", "#ff0000"))
        self.run_well("render", self.model, "-o", self.image, "--style", style, "--size", "32x32")
        self.assertEqual(bytes(read_png(self.image)[3][0][:3]), b"\xff\x00\x00")

    def test_styles(self):
        listed = self.run_well("styles").stdout
        for style in STYLES:
            self.assertIn(style, listed)

    def test_lines(self):
        path = self.path("lines.vtp")
        self.run_well("lines", self.model, "-o", path, "--lines", "creases")
        with open(path, "rb") as file:
            content = file.read()
        self.assertIn(b"LineType", content)
        self.assertIn(b"Strength", content)
        listed = self.run_well("lines", "--list").stdout
        for name in ("contours", "suggestive", "creases", "boundaries"):
            self.assertIn(name, listed)

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
