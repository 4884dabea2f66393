# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever is wrong, npr says in one line what, where and what to do, and leaves no file behind."""

import os
import unittest

from commandtest import TETRAHEDRON, CommandTest, run

USAGE, INPUT, OUTPUT = 1, 2, 3


class TestBadInput(CommandTest):
    def refuse(self, words, code, *mentioned):
        before = sorted(os.listdir(self.folder))
        result = run(*words)
        self.assertEqual(result.returncode, code, (words, result.stdout, result.stderr))
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        self.assertTrue(result.stderr.startswith("npr: "), result.stderr)
        self.assertEqual(result.stdout, "")
        for text in mentioned:
            self.assertIn(text, result.stderr)
        self.assertEqual(sorted(os.listdir(self.folder)), before, "a file was left behind")

    def refuse_model(self, name, content, *mentioned):
        path = self.write(name, content)
        self.refuse(["render", path, "-o", self.image], INPUT, path, *mentioned)

    def render(self, *words):
        return ["render", self.model, "-o", self.image, *words]

    def test_missing_model(self):
        path = self.path("nothing.ply")
        self.refuse(["render", path, "-o", self.image], INPUT, path)

    def test_unknown_model_extension(self):
        self.refuse_model("model.xyzzy", "hello", ".ply")

    def test_folder_as_model(self):
        self.refuse(["render", self.folder, "-o", self.image], INPUT, self.folder)

    def test_empty_models(self):
        for name in ("a.obj", "a.ply", "a.stl", "a.vtp", "a.vtk", "a.gltf", "a.glb", "a.vti", "a.nrrd", "a.mha", "a.nii", "a.vdb"):
            with self.subTest(name=name):
                self.refuse_model(name, "")

    def test_truncated_ply(self):
        header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
        self.refuse_model("cut.ply", header + "0 0 0\n1 0 0\n")

    def test_no_triangles(self):
        self.refuse_model("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n")

    def test_nan_points(self):
        self.refuse_model("nan.obj", TETRAHEDRON.replace("0 0 0", "nan nan nan").replace("v 1 0 0", "v nan 0 0").replace("v 0 1 0", "v nan 0 0").replace("v 0 0 1", "v nan 0 0"))

    def test_all_points_in_one_place(self):
        self.refuse_model("spot.obj", "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n")

    def test_no_area(self):
        """Two triangles, each with its corners on a line; beside one with an area they do no harm."""
        lines = "v 0 0 0\nv 0.1 0.1 0.1\nv 0.3 0.3 0.3\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 4 5 6\n"
        flat = self.write("flat.obj", lines)
        for words in (
            ["render", flat, "-o", self.image],
            ["render", flat, "-o", self.path("drawing.svg")],
            ["render", self.model, flat, "-o", self.image],
            ["lines", flat, "-o", self.path("lines.vtp")],
            ["sheet", flat, "-o", self.image],
            ["curvature", flat, "-o", self.image],
        ):
            with self.subTest(words=words):
                self.refuse(words, INPUT, flat, "none of its 2 polygons has an area", "npr info")
        some = self.write("some.obj", lines + "f 1 2 4\n")
        self.run_well("render", some, "-o", self.image, "--size", "32x32")
        self.assertIn("2 triangles without area", self.run_well("info", flat).stdout)

    def test_unknown_style(self):
        self.refuse(self.render("--style", "nonsense"), INPUT, "nonsense", "technical")

    def test_missing_style_file(self):
        path = self.path("none.json")
        self.refuse(self.render("--style", path), INPUT, path)

    def test_bad_json(self):
        path = self.write("bad.json", '{\n  "lines": [\n}\n')
        self.refuse(self.render("--style", path), INPUT, path, "line 3")

    def test_style_names_the_key(self):
        for content, key in (
            ('{"lines": [{"type": "contours", "width": -1}]}', "/lines/0/width"),
            ('{"lines": [{"type": "wrinkles"}]}', "wrinkles"),
            ('{"lines": [{"type": "creases", "angel": 30}]}', "/lines/0/angel"),
            ('{"shading": {"style": "velvet"}}', "velvet"),
            ('{"shading": {"style": "toon", "tone": 3}}', "/shading/tone"),
            ('{"background": "#12"}', "/background"),
            ('{"sahding": {}}', "/sahding"),
            ('{"name": "a", "lines": [], "name": "b"}', "/name"),
            ('{"strokes": {"wobble": 1, "cap": "butt", "wobble": 2}}', "/strokes/wobble"),
            ('{"lines": [{"type": "creases"}, {"type": "contours", "width": 1, "width": 2}]}', "/lines/1/width"),
            ("[]", "object"),
        ):
            with self.subTest(content=content):
                path = self.write("style.json", content)
                self.refuse(self.render("--style", path), INPUT, path, key)

    def test_unwritable_output(self):
        path = self.path("no/such/folder/image.png")
        self.refuse(["render", self.model, "-o", path], OUTPUT, path)
        self.refuse(["render", self.model, "-o", "/proc/image.png"], OUTPUT, "/proc/image.png")

    def test_folder_of_the_demo(self):
        self.refuse(["demo", self.model], OUTPUT, self.model + " is a file")
        self.refuse(["demo", self.model + "/demo"], OUTPUT, self.model + "/demo", "can not be made")
        self.refuse(["demo", "/proc/demo"], OUTPUT, "/proc/demo", "can not be made")

    def test_lines_that_need_arrays(self):
        for kind, message in (("isolines", "no point arrays"), ("region-borders", "no cell arrays")):
            for words in (self.render(), ["lines", self.model, "-o", self.path("lines.vtp")]):
                self.refuse([*words, "--lines", kind], INPUT, f"--set {kind}.array=NAME", message)

    def test_unknown_image_kind(self):
        self.refuse(["render", self.model, "-o", self.path("image.xyz")], USAGE, ".png")

    def test_devices_are_not_replaced(self):
        pipe = self.path("pipe.png")
        os.mkfifo(pipe)
        self.refuse(["render", self.model, "-o", pipe], OUTPUT, pipe, "name a file")

    def test_links_stay(self):
        target = self.path("target.png")
        link = self.path("link.png")
        os.symlink("target.png", link)
        for _ in range(2):  # it leads nowhere, then to a file
            self.assertEqual(run("render", self.model, "-o", link).returncode, 0)
            self.assertTrue(os.path.islink(link))
            with open(target, "rb") as file:
                self.assertEqual(file.read(4), b"\x89PNG")
            with open(target, "wb") as file:
                file.write(b"old")

    def test_bad_words(self):
        for words in (
            ["frobnicate"],
            [],
            ["render", self.model],
            ["render", "-o", self.image],
            self.render("--sample"),
            self.render("--size", "0x10"),
            self.render("--size", "big"),
            self.render("--view", "sideways"),
            self.render("--view", "1,2,3"),
            self.render("--eye", "1,2"),
            self.render("--eye", "0,0,0", "--target", "0,0,0"),
            self.render("--projection", "fisheye"),
            self.render("--up", "q"),
            ["lines", self.model, "-o", self.path("lines.txt")],
            ["lines", self.model, "-o", self.path("lines.vtp"), "--lines", "wrinkles"],
            ["info"],
            ["info", self.model, "--volume-smoothing", "99"],
        ):
            with self.subTest(words=words):
                self.refuse(words, USAGE)

    def test_bad_view_is_refused_before_models_are_read(self):
        missing = self.path("nothing.ply")
        for words in (
            ["--size", "big"],
            ["--view", "sideways"],
            ["--view", "1,2,3"],
            ["--up", "q"],
            ["--up", "1,0,0"],
            ["--eye", "1,2"],
            ["--eye", "1,2,3", "--up", "0,0"],
            ["--eye", "1,2,3", "--up", "0,0,0"],
            ["--eye", "1,2,3", "--target", "1,2"],
            ["--eye", "1,2,3", "--target", "1,2,3"],
            ["--eye", "1,2,3", "--target", "1,2,9", "--up", "z"],
            ["--view", "front", "--eye", "1,2,3"],
        ):
            with self.subTest(words=words):
                self.refuse(["render", missing, "-o", self.image, *words], USAGE, words[-2])
                self.refuse(["demo", self.path("demo"), *words], USAGE, words[-2])

    def test_bad_lines_and_background(self):
        self.refuse(self.render("--lines", "wrinkles"), USAGE, "wrinkles", "contours")
        self.refuse(self.render("--outline", "halo"), USAGE, "halo", "image-edges")
        self.refuse(self.render("--set", "levels=5"), USAGE, "KIND.PARAMETER=VALUE")
        self.refuse(self.render("--set", "topographic.levels=5"), USAGE, "topographic", "contours")
        self.refuse(self.render("--lines", "topographic", "--set", "topographic.level=5"), USAGE, "level", "levels")
        self.refuse(self.render("--lines", "topographic", "--set", "topographic.levels=many"), USAGE, "number")
        width = self.render("--lines", "contours", "--set", "contours.width=5")
        self.refuse(width, USAGE, "contours/width", "its own keys are: none\n")
        none = ["lines", self.model, "-o", self.path("lines.vtp"), "--lines", "none"]
        self.refuse(none, USAGE, "--lines none", "npr lines --list")
        self.refuse(self.render("--background", "#12"), USAGE, "#12")
        for extension in (".jpg", ".bmp", ".ppm"):
            words = ["render", self.model, "-o", self.path("image" + extension), "--background", "transparent"]
            self.refuse(words, USAGE, "transparent", extension, ".png or .tif")

    def test_no_lines_named(self):
        self.refuse(self.render("--lines", ""), USAGE, "--lines", "none draws no lines")

    def test_unknown_backend(self):
        result = run(*self.render(), environment={"NPR_OFFSCREEN": "abacus"})
        self.assertEqual(result.returncode, 4)
        self.assertIn("abacus", result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
