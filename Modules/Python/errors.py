# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK only prints, raised."""

from contextlib import contextmanager as _contextmanager
import re as _re

from vtkmodules.vtkCommonCore import vtkOutputWindow as _vtkOutputWindow, vtkStringOutputWindow as _vtkStringOutputWindow

# "ERROR: In file.cxx, line 12\nvtkFilter (0x55d): text"
_HEADING = _re.compile(r"^(ERROR|(?:Generic )?Warning): In .*\n(?:vtk\w+ \((?:0x)?[0-9a-f]+\): )?", _re.MULTILINE)
# What the pipeline says after the filter has said what is wrong.
_FOLLOWS = _re.compile(r"Algorithm (\w+).* returned failure for request")


def _find_error(text):
    """The first error of a text that VTK's objects have printed; None without one."""
    parts = _HEADING.split(text)[1:]
    before = None
    for kind, message in zip(parts[::2], parts[1::2]):
        message = message.strip()
        failure = _FOLLOWS.match(message)
        if failure:
            return before or f"{failure.group(1)} failed"
        if kind == "ERROR":
            return message
        before = message  # some readers warn of what they fail at
    return None


@_contextmanager
def _raising_vtk_errors():
    """Raise, at the end, the first error of VTK's objects meanwhile as a RuntimeError.

    Those that somebody observes (ErrorEvent) are his. Messages are logged as they always are.
    """
    window, messages = _vtkOutputWindow.GetInstance(), _vtkStringOutputWindow()
    _vtkOutputWindow.SetInstance(messages)
    try:
        yield
    finally:
        _vtkOutputWindow.SetInstance(window)
    error = _find_error(messages.GetOutput())
    if error:
        raise RuntimeError(error)
