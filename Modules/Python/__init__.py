# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Non-photorealistic rendering for VTK.

All classes of vtkNPR stand here, next to a few functions; two need no display::

    import vtknpr
    from vtkmodules.vtkFiltersSources import vtkConeSource

    cone = vtkConeSource()
    cone.Update()
    vtknpr.render(cone.GetOutput(), "cone.png", style="technical")
"""

import operator as _operator
import os as _os

# VTK's own modules must be there before ours, whose classes derive from theirs.
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPolyData as _vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm as _vtkAlgorithm
from vtkmodules.vtkIOImage import vtkPNGWriter as _vtkPNGWriter
from vtkmodules.vtkRenderingCore import (
    vtkActor as _vtkActor,
    vtkPolyDataMapper as _vtkPolyDataMapper,
    vtkRenderer as _vtkRenderer,
    vtkRenderWindow as _vtkRenderWindow,
    vtkWindowToImageFilter as _vtkWindowToImageFilter,
)

from .vtkNPRFiltersSurfaces import *  # noqa: F401,F403
from .vtkNPRFiltersCurvature import *  # noqa: F401,F403
from .vtkNPRFiltersLines import *  # noqa: F401,F403
from .vtkNPRFiltersSources import *  # noqa: F401,F403
from .vtkNPRFiltersStrokes import *  # noqa: F401,F403
from .vtkNPRIO import *  # noqa: F401,F403
from .vtkNPRRenderingIllustration import *  # noqa: F401,F403
from .vtkNPRRenderingImageSpace import *  # noqa: F401,F403
from .vtkNPRRenderingOffscreen import *  # noqa: F401,F403
from .vtkNPRRenderingShading import *  # noqa: F401,F403
from .vtkNPRRenderingStrokes import *  # noqa: F401,F403

from .vtkNPRRenderingIllustration import (
    vtkNPRIllustration,
    vtkNPRIllustrationStyle,
    vtkNPRViewpoint,
)
from .vtkNPRRenderingOffscreen import vtkNPROffscreen
from .define import Quantities, _raising_mistakes, define_lines  # noqa: F401
from .errors import _raising_vtk_errors

_LARGEST_SIDE = 16384  # of an image, in pixels


def illustrate(renderer, style="technical", lines=None):
    """Turn what a vtkRenderer shows into an illustration.

    The renderer should be in a window that has its size, and its camera should be set. `style` is
    the name of a built-in style or the path of a style file, `lines` the kinds of lines to draw
    instead of the style's, also those of define_lines(): names, or the name of one. Returns the
    vtkNPRIllustration; keep it as long as the illustration is to be seen: its Remove(), or another
    illustrate(), takes it off. Raises ValueError for a style that is not valid, RuntimeError for
    errors of filters and readers that it runs, and what the functions of define_lines() raise; the
    renderer is then as it was.
    """
    if isinstance(lines, str):
        lines = [lines]
    document = vtkNPRIllustrationStyle()
    if not document.Load(_os.fspath(style)) or not (lines is None or document.SelectLines(lines)):
        raise ValueError(document.GetErrorMessage())
    illustration = vtkNPRIllustration()
    illustration.SetRenderer(renderer)
    illustration.SetStyle(document)
    try:
        with _raising_vtk_errors(), _raising_mistakes():
            if not illustration.Apply():
                raise ValueError("there is no renderer to illustrate")
            if illustration.GetNumberOfLineTypes() > 0:
                illustration.GetLines(_vtkPolyData())  # else the first render finds what is wrong
    except BaseException:
        illustration.Remove()
        raise
    return illustration


def _get_surface(surface):
    """The vtkPolyData that is given, or that the last filter of a pipeline makes."""
    given = surface
    if isinstance(given, _vtkAlgorithm) and given.GetNumberOfOutputPorts() > 0:
        with _raising_vtk_errors():
            given.Update()
        surface = given.GetOutputDataObject(0)
    if not isinstance(surface, _vtkPolyData):
        raise TypeError(f"the surface must be a vtkPolyData, or a source or filter that makes one, not {type(given).__name__}")
    return surface


def _check_size(size):
    try:
        width, height = (_operator.index(side) for side in size)
    except (TypeError, ValueError):
        width = height = 0
    if not (1 <= width <= _LARGEST_SIDE and 1 <= height <= _LARGEST_SIDE):
        raise ValueError(f"size {size!r}: give (width, height) in pixels, each from 1 to {_LARGEST_SIDE}")
    return width, height


def render(surface, path, style="technical", size=(1600, 1200), view="three-quarter", lines=None):
    """Draw a vtkPolyData, or what a source or filter makes, into a PNG file, without a display.

    `view` is a name that vtkNPRViewpoint knows or (azimuth, elevation) in degrees; `size` is
    (width, height) in pixels, `lines` as for illustrate(). Raises TypeError for a surface of another
    kind, ValueError for what is not valid, OSError when the file can not be written, RuntimeError
    where nothing can be drawn with and for errors of filters and readers, and what the functions of
    define_lines() raise.
    """
    surface = _get_surface(surface)
    size = _check_size(size)
    if surface.GetNumberOfPolys() + surface.GetNumberOfStrips() == 0:
        raise ValueError("the surface has no polygons, so there is nothing to draw")
    path = _os.fspath(path)
    if not path.lower().endswith(".png"):
        raise ValueError(f"{path}: only .png is written here")
    if not vtkNPROffscreen.Setup():
        raise RuntimeError(vtkNPROffscreen.GetErrorMessage())
    mapper = _vtkPolyDataMapper()
    mapper.SetInputData(surface)
    actor = _vtkActor()
    actor.SetMapper(mapper)
    renderer = _vtkRenderer()
    renderer.AddActor(actor)
    window = _vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(4)
    window.SetSize(*size)
    window.AddRenderer(renderer)

    viewpoint = vtkNPRViewpoint()
    if not isinstance(view, str):
        viewpoint.SetAzimuth(view[0])
        viewpoint.SetElevation(view[1])
    elif view in vtkNPRViewpoint.GetViewNames():
        viewpoint.SetViewByName(view)
    else:
        raise ValueError(f"unknown view {view!r}; the views are {', '.join(vtkNPRViewpoint.GetViewNames())}")
    viewpoint.Apply(renderer)
    illustration = illustrate(renderer, style, lines)
    grab = _vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.ShouldRerenderOff()
    with _raising_vtk_errors(), _raising_mistakes():
        window.Render()
        grab.Update()
    writer = _vtkPNGWriter()
    writer.SetInputConnection(grab.GetOutputPort())
    writer.SetFileName(path)
    writer.Write()
    illustration.Remove()
    if writer.GetErrorCode() != 0:
        raise OSError(f"{path}: could not be written")
