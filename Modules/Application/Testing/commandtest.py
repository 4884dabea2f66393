# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of the command share: running it, and small models to run it on."""

import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

NPR = sys.argv.pop(1)

TETRAHEDRON = """v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


def run(*words, environment=None):
    """Run npr; its result has returncode, stdout and stderr."""
    env = dict(os.environ, **(environment or {}))
    env.pop("DISPLAY", None)
    return subprocess.run([NPR, *words], capture_output=True, text=True, env=env, timeout=200)


def read_png(path):
    """Width, height and rows of bytes (RGB or RGBA) of a PNG with 8 bits a channel."""
    with open(path, "rb") as file:
        data = file.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    place, packed = 8, b""
    while place < len(data):
        length, kind = struct.unpack(">I4s", data[place : place + 8])
        body = data[place + 8 : place + 8 + length]
        if kind == b"IHDR":
            width, height, _, color = struct.unpack(">IIBB", body[:10])
        elif kind == b"IDAT":
            packed += body
        place += 12 + length
    channels = {2: 3, 6: 4}[color]
    raw, rows, previous = zlib.decompress(packed), [], bytearray(width * channels)
    for y in range(height):
        start = y * (width * channels + 1)
        rows.append(unfilter(raw[start], bytearray(raw[start + 1 : start + 1 + width * channels]), previous, channels))
        previous = rows[-1]
    return width, height, channels, rows


def write_png(path, width, height, channels, rows):
    """Write what read_png() gives."""
    def chunk(kind, body):
        return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

    header = struct.pack(">IIBBBBB", width, height, 8, {3: 2, 4: 6}[channels], 0, 0, 0)
    packed = zlib.compress(b"".join(b"\0" + bytes(row) for row in rows))
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", packed) + chunk(b"IEND", b""))


def unfilter(kind, row, above, channels):
    """Undo PNG's prediction of a row."""
    for i, value in enumerate(row):
        left = row[i - channels] if i >= channels else 0
        corner = above[i - channels] if i >= channels else 0
        if kind == 1:
            value += left
        elif kind == 2:
            value += above[i]
        elif kind == 3:
            value += (left + above[i]) // 2
        elif kind == 4:
            estimate = left + above[i] - corner
            value += min((left, above[i], corner), key=lambda neighbour: abs(estimate - neighbour))
        row[i] = value & 255
    return row


class CommandTest(unittest.TestCase):
    """A test with a folder of its own and a small model in it."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.model = self.write("model.obj", TETRAHEDRON)
        self.image = self.path("image.png")

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, content):
        mode = "wb" if isinstance(content, bytes) else "w"
        with open(self.path(name), mode) as file:
            file.write(content)
        return self.path(name)

    def run_well(self, *words, **options):
        result = run(*words, **options)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result
