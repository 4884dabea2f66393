# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models as people have them are drawn: scans, CAD parts, textured and medical ones."""

import os
import sys
import unittest

from commandtest import CommandTest, read_png

MODELS = sys.argv.pop(1)
SKIPPED = 125

# The model, and the options that it needs.
SUBJECTS = (
    ("bunny/bunny.ply", ["--view", "front"]),
    ("dragon/dragon_vrip_res4.ply", ["--view", "front"]),
    ("cad/motor.stl", []),
    ("assimp/OBJ/spider.obj", []),
    ("assimp/glTF2/BoxTextured-glTF-Binary/BoxTextured.glb", []),
    ("brain/ch2bet.nii.gz", ["--iso", "60"]),
)


class TestModels(CommandTest):
    def test_drawings(self):
        for name, options in SUBJECTS:
            with self.subTest(model=name):
                model = os.path.join(MODELS, name)
                self.run_well("render", model, "-o", self.image, "--style", "ink", "--size", "320x240", *options)
                _, _, channels, rows = read_png(self.image)
                values = [row[x] for row in rows for x in range(0, len(row), channels)]
                ink = sum(1 for value in values if value < 100) / len(values)
                self.assertTrue(0.004 < ink < 0.3, f"{100 * ink:.2f} % of the drawing is ink")
                self.assertEqual(min(rows[0]), 255, "a margin all around")


if __name__ == "__main__":
    missing = [name for name, _ in SUBJECTS if not os.path.exists(os.path.join(MODELS, name))]
    if missing and not os.environ.get("CI"):
        print("skipped; these were not fetched:", ", ".join(missing))
        sys.exit(SKIPPED)
    unittest.main()
