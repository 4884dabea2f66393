#!/usr/bin/python3
# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Plain vtkRenderWindow() draws without a display after one call, in each backend."""
import math
import os
import sys
import unittest

for name in ("DISPLAY", "WAYLAND_DISPLAY", "NPR_OFFSCREEN"):
    os.environ.pop(name, None)

from vtkmodules.vtkCommonCore import vtkObject, vtkUnsignedCharArray
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkRenderWindowInteractor,
)
import vtkmodules.vtkInteractionStyle  # the interactor's default style
import vtkmodules.vtkRenderingOpenGL2  # VTK's own factory comes first, as in any script

from vtknpr.vtkNPRRenderingOffscreen import vtkNPROffscreen

SIZE = 200


def draw_sphere():
    """A window with a sphere whose diameter is half the window's."""
    sphere = vtkSphereSource()
    sphere.SetThetaResolution(128)
    sphere.SetPhiResolution(128)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(sphere.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.AddActor(actor)
    renderer.GetActiveCamera().ParallelProjectionOn()
    renderer.GetActiveCamera().SetParallelScale(1.0)
    window = vtkRenderWindow()
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    window.Render()
    return window


def covered_pixels(window):
    data = vtkUnsignedCharArray()
    window.GetPixelData(0, 0, SIZE - 1, SIZE - 1, 1, data, 0)
    pixels = memoryview(data).cast("B")
    return sum(1 for i in range(0, len(pixels), 3) if any(pixels[i : i + 3]))


class TestOffscreen(unittest.TestCase):
    # Newer Debian has no OSMesa; there AUTO takes EGL.
    backends = [
        name
        for name, index in (("osmesa", 2), ("egl", 3))
        if not vtkNPROffscreen.GetBackendReason(index).startswith("does not work")
    ]

    def test_draws_in_each_backend(self):
        self.assertIn("egl", self.backends)
        for name in self.backends:
            with self.subTest(backend=name):
                self.assertTrue(vtkNPROffscreen.Setup(name))
                window = draw_sphere()
                self.assertEqual(window.GetClassName(), vtkNPROffscreen.GetWindowClassName())
                self.assertEqual(window.GetMultiSamples(), 0)
                expected = math.pi * SIZE * SIZE / 16
                self.assertLess(abs(covered_pixels(window) - expected), 0.01 * expected)
                self.assertTrue(vtkNPROffscreen.GetGLRenderer(window))
                self.assertTrue(vtkNPROffscreen.GetGLVendor(window))
                self.assertRegex(vtkNPROffscreen.GetGLVersion(window), r"^[34]\.")

    def test_environment_and_report(self):
        os.environ["NPR_OFFSCREEN"] = "egl"
        self.addCleanup(os.environ.pop, "NPR_OFFSCREEN")
        self.assertTrue(vtkNPROffscreen.Setup())
        self.assertEqual(vtkNPROffscreen.GetBackend(), vtkNPROffscreen.EGL)
        indices = range(vtkNPROffscreen.GetNumberOfBackends())
        taken = [vtkNPROffscreen.GetBackendName(i) for i in indices if vtkNPROffscreen.GetBackendTaken(i)]
        self.assertEqual(len(taken), 1)
        self.assertTrue(taken[0].startswith("egl"))
        for i in indices:
            self.assertTrue(vtkNPROffscreen.GetBackendReason(i))

    def test_interactor_needs_no_display(self):
        self.assertTrue(vtkNPROffscreen.Setup(vtkNPROffscreen.EGL))
        interactor = vtkRenderWindowInteractor()
        interactor.SetRenderWindow(draw_sphere())
        interactor.Initialize()
        self.assertEqual(interactor.GetClassName(), "vtkGenericRenderWindowInteractor")

    def test_unknown_backend(self):
        vtkObject.GlobalWarningDisplayOff()
        self.addCleanup(vtkObject.GlobalWarningDisplayOn)
        self.assertFalse(vtkNPROffscreen.Setup("opengl"))
        self.assertIn("Unknown backend 'opengl'", vtkNPROffscreen.GetErrorMessage())
        self.assertFalse(vtkNPROffscreen.Setup("native"))
        self.assertIn("DISPLAY is not set", vtkNPROffscreen.GetErrorMessage())


if __name__ == "__main__":
    sys.exit(unittest.main())
