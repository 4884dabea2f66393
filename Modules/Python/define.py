# SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
# SPDX-License-Identifier: BSD-3-Clause
"""Lines that users define, as functions over numpy arrays or as formulas."""

from contextlib import contextmanager as _contextmanager

import numpy as _numpy
from vtkmodules.util.numpy_support import numpy_to_vtk as _numpy_to_vtk, vtk_to_numpy as _vtk_to_numpy

from .vtkNPRFiltersLines import vtkNPRCallbackLines, vtkNPRExpressionLines, vtkNPRLineDefinition

_VECTORS = ("e1", "e2", "n", "v", "w", "p")

# What functions have raised, while a function of the package keeps it; else None.
_mistakes = None


@_contextmanager
def _raising_mistakes():
    """Raise, at the end, the first exception of functions of define_lines() that ran meanwhile.

    An exception can not pass through VTK, which would print and forget it.
    """
    global _mistakes
    before, _mistakes = _mistakes, []
    try:
        yield
        if _mistakes:
            raise _mistakes[0]
    finally:
        _mistakes = before


class Quantities:
    """What is known at all points of a surface in a view: numpy arrays by their names.

    As attributes or keys: ndotv, sintheta, kr, dwkr, k1, k2, K, H, P, Q, S, T with one number a
    point, the vectors e1, e2, n, v, w, p with three (also e1x, e1y ...), and by key any point array
    of the surface. Curvatures are without unit: k1, k2, H and kr are times the surface's length
    scale, K, P, Q, S, T and dwkr times its square. Only what is asked for is computed. The arrays
    are good during the call that they are made for.
    """

    def __init__(self, lines):
        self._lines = lines

    @property
    def eye(self):
        """Where the eye is; in parallel projection the unit vector towards it."""
        eye = [0.0, 0.0, 0.0]
        self._lines.GetEye(eye)
        return _numpy.array(eye)

    @property
    def eye_at_infinity(self):
        """Whether the projection is parallel."""
        return self._lines.IsEyeAtInfinity()

    def __len__(self):
        return self._lines.GetNumberOfPoints()

    def __getitem__(self, name):
        if name[:-1] in _VECTORS and name[-1] in "xyz":
            return self[name[:-1]][:, "xyz".index(name[-1])]
        array = self._lines.GetQuantity(name)
        if array is None:
            raise KeyError(name)
        return _vtk_to_numpy(array)

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        try:
            return self[name]
        except KeyError:
            known = ", ".join(vtkNPRCallbackLines.GetQuantityNames())
            raise AttributeError(f"no quantity {name!r} here; there are: {known}") from None


def _to_array(what, values, count):
    values = _numpy.asarray(values, dtype=float)
    if values.shape not in ((), (1,), (count,)):
        raise ValueError(f"the {what} must be one number for each of {count} points, but its shape is {values.shape}")
    values = _numpy.broadcast_to(values, (count,))
    return _numpy_to_vtk(_numpy.ascontiguousarray(values), deep=True)


def define_lines(name, field, test=None, view_dependent=True, **parameters):
    """Define a kind of line, and make it known by its name, in this process.

    `field` and `test` are functions of one argument, the Quantities, that return one number for
    each point. Lines run where the field is 0 and the test is above 0; without a test, everywhere.
    Their strength rises smoothly from 0 there to 1 where the test is 1, so return how far it holds
    (`(q.dwkr - 2) / 2`) rather than whether (`q.dwkr > 2`). The functions are called once for each
    view; with `view_dependent=False` once for a surface.

    Or both are formulas, texts as vtkNPRExpressionLines takes them; its parameters `fade`, `levels`
    and `constants` (a dict) then go by their names, and `view_dependent` is found out.

    Returns the definition, for vtkNPRFeatureLines.AddDefinition(). By their name the lines are
    extracted, chained, faded, drawn and exported as built-in ones: `render(..., lines=["contours",
    name])`, `AddDefinition(name)`, or a style's `"type": name`. Raises ValueError for what is wrong.
    What the functions raise, vtknpr.render() and vtknpr.illustrate() raise; elsewhere VTK prints it.
    """
    is_formula = isinstance(field, str)
    for what, given in (("field", field), ("test", field if test is None else test)):
        if not (isinstance(given, str) if is_formula else callable(given)):
            raise ValueError(
                f"the {what} of the lines {name!r} is {given!r}; field and test must be both functions or both formulas"
            )
    if is_formula:
        lines = _make_formulas(name, field, test or "", **parameters)
    elif parameters:
        raise TypeError(f"functions take no {', '.join(parameters)}")
    else:
        lines = vtkNPRCallbackLines()
        lines.SetName(name)
        lines.SetViewDependent(view_dependent)

        def evaluate(caller, event):
            quantities = Quantities(caller)
            count = len(quantities)
            try:
                if test is not None:
                    caller.SetTest(_to_array(f"test of the lines {name!r}", test(quantities), count))
                caller.SetField(_to_array(f"field of the lines {name!r}", field(quantities), count))
            except Exception as mistake:
                if _mistakes is None:
                    raise
                _mistakes.append(mistake)
                caller.SetField(_to_array("field", 1.0, count))  # nowhere 0: no lines

        lines.AddObserver("UpdateDataEvent", evaluate)
    if not vtkNPRLineDefinition.AddKind(lines):
        raise ValueError(f"lines can not be called {name!r}: it is empty or a built-in kind")
    return lines


def _make_formulas(name, field, test, fade=1.0, levels=(0.0,), constants=None):
    lines = vtkNPRExpressionLines()
    lines.SetName(name)
    lines.SetField(field)
    lines.SetTest(test)
    lines.SetFade(fade)
    lines.SetLevels(list(levels))
    for key, value in (constants or {}).items():
        if not lines.AddConstant(key, value):
            raise ValueError(f"{key!r} can not be a constant: it is no name, or means something already")
    problem = lines.FindProblem()
    if problem:
        raise ValueError(f"lines {name!r}: {problem}")
    return lines
