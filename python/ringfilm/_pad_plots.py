"""Figures of pads."""

import numpy

from ._drawing import TOTAL, caption, fitting_unit, from_zero, label_of, new_figure, plain
from ._ringfilm import quantities, version

_ALONG = ("film_thickness", "pressure", "film_content")


def plot_pad(result, what="film", axes=None, label=None, **style):
    """See PadResult.plot."""
    names = list(result.values)
    if what not in ("film", *_ALONG, *names):
        known = ", ".join(("film", *_ALONG))
        raise ValueError(f"{what!r} cannot be drawn; one of {known}, or a number of the pad over time")
    if what == "film" and (axes is not None or label is not None or style):
        raise ValueError(
            "'film' is a figure of two panels: axes, label and style are for film_thickness, pressure, "
            "film_content or a number of the pad"
        )
    if not len(result.time):
        raise ValueError("this pad has no film to draw: it was not solved at any instant")
    draw = _draw_along if what in _ALONG else _draw_over_time
    if axes is not None:
        own = plain(result.title) if label is None else plain(label)
        draw(axes, result, what, {"label": own, **style})
        return axes.figure
    if what == "film":
        figure = new_figure(2)
        gap, pressure = figure.subplots(2, 1, sharex=True)
        reported = _draw_along(gap, result, "film_thickness", TOTAL)
        _draw_along(pressure, result, "pressure", TOTAL)
        gap.set_xlabel("")
        reported = reported.replace("Film thickness", "Film thickness and pressure")
    else:
        figure = new_figure(1)
        own = {} if label is None else {"label": plain(label)}
        reported = draw(figure.subplots(), result, what, {**TOTAL, **own, **style})
        if label is not None:
            figure.axes[0].legend(fontsize=7)
    program = version().split(" commit ")[0]
    caption(figure, f"{reported} Case: {result.title or 'without a title'}; {program}.")
    return figure


def _described(name):
    return next(
        quantity
        for table in ("pad_film", "pad", "pad_width")
        for quantity in quantities()[table]
        if quantity.name == name
    )


def _in_reading_unit(axes, which, values, name):
    """Numbers in a unit of their size; the axis shows which, and an axis that has one already keeps it."""
    quantity = _described(name)
    axis = getattr(axes, f"{which}axis")
    before, unit, factor = getattr(axis, "_ringfilm_unit", (None, None, None))
    if before != quantity.unit or not axes.lines:
        unit, factor = fitting_unit(values, quantity)
        axis._ringfilm_unit = (quantity.unit, unit, factor)
    axis.set_label_text(label_of(quantity.long_name, unit), fontsize=8)
    return numpy.asarray(values) / factor


def _draw_along(axes, result, name, style):
    values, where = getattr(result, name)[-1], ""
    if values.ndim == 2:
        middle = values.shape[0] // 2
        unit, factor = fitting_unit(result.y, _described("x"))
        values, where = values[middle], f" on the strip y = {result.y[middle] / factor:.4g} {unit}"
    if len(result.time) > 1:
        where += f" at the last instant, t = {result.time[-1]:.4g} s"
    y = _in_reading_unit(axes, "y", values, name)
    x = _in_reading_unit(axes, "x", result.x, "x")
    (line,) = axes.plot(x, y, **{"linewidth": 1.3, **style})
    if numpy.nanmin(y) >= 0:
        from_zero(axes, line)
    return f"{_described(name).long_name.capitalize()} along the pad{where}."


def _draw_over_time(axes, result, name, style):
    if len(result.time) < 2:
        raise ValueError(f"{name!r} has one instant only, the film is steady: see values[{name!r}]")
    y = _in_reading_unit(axes, "y", getattr(result, name), name)
    x = _in_reading_unit(axes, "x", result.time, "time")
    axes.plot(x, y, **{"linewidth": 1.3, **style})
    long_name = _described(name).long_name
    return f"{long_name[0].upper()}{long_name[1:]} over time."
