# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""npr sheet: each kind of line in a cell of its own."""

import os
import unittest

from commandtest import CommandTest, read_png, run

CELL = (160, 120)


class TestSheet(CommandTest):
    def sheet(self, *words):
        result = self.run_well("sheet", *words, "-o", self.image, "--size", "%dx%d" % CELL)
        width, height, channels, rows = read_png(self.image)
        self.assertEqual(channels, 3)
        return result, width, height, rows

    def picture(self, rows, width, height, across, down, cell):
        """The lightest channels of the pixels of a cell, without its label."""
        gap = (width - across * CELL[0]) // (across + 1)
        left = gap + cell % across * (CELL[0] + gap)
        top = gap + cell // across * ((height - gap) // down)
        return bytes(
            max(rows[y][3 * x : 3 * x + 3]) for y in range(top, top + CELL[1]) for x in range(left, left + CELL[0])
        )

    def test_every_kind_that_needs_nothing(self):
        result, width, height, rows = self.sheet()
        listed = [row.split()[0] for row in self.run_well("lines", "--list").stdout.splitlines()[1:]]
        left_out = result.stdout.split(":")[1].replace(",", " ").split()
        self.assertEqual(left_out, ["expression"], "the sample has data for all others")
        count = len(listed) - len(left_out)
        self.assertGreaterEqual(count, 8)
        across = next(n for n in range(1, 100) if n * n >= count)
        down = -(-count // across)
        self.assertTrue(across * CELL[0] < width < across * CELL[0] * 1.2)
        self.assertTrue(down * CELL[1] < height < down * CELL[1] * 1.5)
        pictures = set()
        for i in range(count):
            picture = self.picture(rows, width, height, across, down, i)
            ink = sum(1 for value in picture if value < 200)
            self.assertTrue(100 < ink < 0.4 * len(picture), "cell %d has %d pixels of ink" % (i, ink))
            pictures.add(picture)
        # The sample is closed, so some kinds have no lines on it, and their cells are alike.
        self.assertGreaterEqual(len(pictures), 6, "each cell shows a kind of its own")
        border = [rows[0], rows[-1]] + [row[:9] + row[-9:] for row in rows]
        self.assertTrue(all(min(row) == 255 for row in border), "white margins")
        self.assertTrue(result.stderr == "")

    def test_kinds_that_need_data(self):
        result, *_ = self.sheet(self.model)
        left_out = result.stdout.split(":")[1].replace(",", " ").split()
        self.assertEqual(sorted(left_out), ["expression", "isolines", "region-borders"])
        for kind in ("isolines", "region-borders"):
            _, width, height, rows = self.sheet("--lines", kind)
            picture = rows[: height - height // 5]  # without the label
            values = [max(row[x : x + 3]) for row in picture for x in range(0, len(row), 3)]
            self.assertGreater(sum(1 for value in values if value < 60), 20, kind)

    def test_one_kind_is_black_the_contours_grey(self):
        for kind, is_drawn in (("creases", True), ("boundaries", False)):
            _, width, height, rows = self.sheet(self.model, "--lines", kind)
            picture = rows[: height - height // 5]  # without the label
            values = [max(row[x : x + 3]) for row in picture for x in range(0, len(row), 3)]
            black = sum(1 for value in values if value < 60)
            grey = sum(1 for value in values if 150 < value < 240)
            self.assertEqual(black > 50, is_drawn, black)
            self.assertTrue(is_drawn or grey > 50, grey)

    def test_same_as_sample(self):
        images = []
        for words in ([], ["--sample"]):
            self.sheet("--lines", "contours, creases", *words)
            with open(self.image, "rb") as file:
                images.append(file.read())
        self.assertEqual(images[0], images[1])

    def test_quiet(self):
        result = self.run_well("sheet", self.model, "-o", self.image, "--size", "64x64", "--quiet")
        self.assertEqual(result.stdout + result.stderr, "")

    def test_what_is_refused(self):
        for code, part, words in (
            (1, "scribbles", [self.model, "-o", self.image, "--lines", "creases,scribbles"]),
            (1, "no kind", [self.model, "-o", self.image, "--lines", ","]),
            (1, "--lines none", [self.model, "-o", self.image, "--lines", "none"]),
            (1, "-o", [self.model]),
            (1, "not both", [self.model, "--sample", "-o", self.image]),
            (1, "unknown kind of image", [self.model, "-o", self.path("image.gif")]),
            (1, "smaller --size", [self.model, "-o", self.image, "--size", "16000x16000"]),
            (2, "absent.obj", [self.path("absent.obj"), "-o", self.image]),
            (2, '"RegionId"', [self.model, "-o", self.image, "--lines", "region-borders", "--size", "64x64"]),
            (3, "absent", [self.model, "-o", self.path("absent/image.png")]),
        ):
            with self.subTest(words=words):
                result = run("sheet", *words)
                self.assertEqual(result.returncode, code, result.stderr)
                self.assertIn(part, result.stderr)
                self.assertEqual(len(result.stderr.splitlines()), 1, "one line")
                self.assertFalse(os.path.exists(self.image))


if __name__ == "__main__":
    unittest.main()
