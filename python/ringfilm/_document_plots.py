"""Figures of the gas between rings and of lives."""

import types

import numpy

from ._drawing import (
    BY_ANGLE,
    TOTAL,
    caption,
    crank_axis,
    draw_over_angle,
    fitting_unit,
    from_intake,
    from_zero,
    label_of,
    new_figure,
    plain,
)
from ._ringfilm import quantities

# One colour a region, path or ring from the chamber on (Okabe and Ito), in grey print by the line style, too.
_COLOURS = ("#000000", "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#999999")
_STYLES = ("-", "--", "-.", ":")
_GAS = {
    "pressure": ("pressure, absolute", "bar", 1e5),
    "flow": ("mass flow to the crankcase", "g/s", 1e-3),
    "position": ("position of the ring above its lower flank", "um", 1e-6),
}
_LIFE = ("mean_power_loss", "min_film_thickness", "mean_absolute_oil_flow")


def _is_synthetic(document):
    return any(note["topic"] == "synthetic-trace" for note in document._of("notes"))


def _finish(figure, text, document):
    synthetic = (
        " The cylinder pressure is SYNTHETIC: made by a formula, not measured." if _is_synthetic(document) else ""
    )
    caption(figure, f"{text}{synthetic} Case: {document._of('title') or 'without a title'}; {document._of('program')}.")
    return figure


def _draw_gas(axes, gas, what, style, strokes):
    """Draws the lines of one quantity: the pressures of the chamber and the lands, the flows of the end gaps."""
    words, unit, size = _GAS[what]
    names = [name for name in getattr(gas, what) if not str(name).startswith(("groove", "above", "below"))]
    angles, order = from_intake(gas.crank_angle)
    if not names:
        axes.text(0.5, 0.5, "no ring in a groove", transform=axes.transAxes, ha="center", color="0.45")
    for i, name in enumerate(names):
        look = {"color": _COLOURS[i % len(_COLOURS)], "linestyle": _STYLES[i % len(_STYLES)]}
        label = f"ring {name}" if what == "position" else name
        values = numpy.asarray(getattr(gas, what)[name])[order] / size
        draw_over_angle(axes, angles, values, **{**look, "label": label, **style})
    if what == "pressure":
        axes.set_yscale("log")
    else:
        axes.axhline(0, color="0.6", linewidth=0.8, zorder=0)
    axes.set_ylabel(label_of(words, f"{unit}, logarithmic" if what == "pressure" else unit), fontsize=8)
    peak = gas["regions"][0]["peak_pressure_angle"]
    crank_axis(axes, peak, strokes)
    if names:
        axes.legend(fontsize=7)


def plot_gas(gas, what="overview", axes=None, **style):
    """See GasPathResult.plot."""
    if what not in ("overview", *_GAS):
        raise ValueError(f"{what!r} cannot be drawn; one of {', '.join(('overview', *_GAS))}")
    if what == "overview" and (axes is not None or style):
        raise ValueError("'overview' is a figure of several panels: axes and style are for one of them")
    if axes is not None:
        _draw_gas(axes, gas, what, style, "inside")
        axes.set_xlabel(BY_ANGLE, fontsize=8)
        return axes.figure
    moves = any(numpy.any(values) for values in gas.position.values())
    names = [name for name in _GAS if name != "position" or moves] if what == "overview" else [what]
    figure = new_figure(len(names))
    panels = numpy.atleast_1d(figure.subplots(len(names), 1, sharex=True))
    for panel, name in zip(panels, names):
        _draw_gas(panel, gas, name, style, "above" if panel is panels[0] else "none")
    panels[-1].set_xlabel(BY_ANGLE, fontsize=8)
    reported = {"pressure": "pressures of the chamber and the piston lands", "flow": "flows through the end gaps"}
    text = "; ".join(reported.get(name, "positions of the rings in their grooves") for name in names)
    return _finish(figure, f"Gas of the ring pack over one cycle: {text}. Dotted grey line: peak pressure.", gas)


def _described(life, name):
    """The quantity of a value; of what has no table its name and unit."""
    tables = quantities()
    unit = life["units"][name]
    plain_one = types.SimpleNamespace(long_name=name.replace("_", " "), unit=unit, display_unit=unit)
    return next((one for table in ("worn", "cycle") for one in tables[table] if one.name == name), plain_one)


def _draw_over_hours(axes, life, name, style):
    """A value over the running hours: its band, its line, the measured states as dots."""
    quantity, states = _described(life, name), life["states"]
    unit, size = fitting_unit(life.values[name], quantity)

    def scale(values):
        return numpy.asarray(values, float) / size

    (line,) = axes.plot(life.hours, scale(life.values[name]), **{"linewidth": 1.3, **style})
    if all(name in state.get("band", {}) for state in states):
        low, high = (scale([state["band"][name][end] for state in states]) for end in (0, 1))
        axes.fill_between(life.hours, low, high, color=line.get_color(), alpha=0.2, linewidth=0)
    measured = [state for state in states if state["state_origin"] == "measured"]
    if measured:
        values = scale([numpy.nan if state[name] is None else state[name] for state in measured])
        axes.plot([state["hours"] for state in measured], values, "o", color=line.get_color(), markersize=4)
    axes.set_ylabel(label_of(quantity.long_name, unit), fontsize=8)
    if numpy.nanmin(line.get_ydata(), initial=0.0) >= 0:
        from_zero(axes, line)


def _draw_faces(axes, life, style):
    """The face of each state, the later the lighter."""
    from matplotlib import colormaps

    unit, size = fitting_unit(life.face_height, _described(life, "face_height"))
    for i, (state, height) in enumerate(zip(life["states"], life.face_height)):
        look = {
            "color": colormaps["viridis"](0.85 * i / max(len(life["states"]) - 1, 1)),
            "label": f"{state['hours']:g} h",
        }
        axes.plot(1e3 * life.x, height / size, **{"linewidth": 1.3, **look, **style})
    axes.set_xlabel("position from the chamber edge [mm]", fontsize=8)
    axes.set_ylabel(label_of("height of the face above its lowest point", unit), fontsize=8)
    axes.legend(fontsize=7)


def plot_life(life, what="overview", axes=None, label=None, **style):
    """See LifeResult.plot."""
    if what not in ("overview", "face_height", *life.values):
        raise ValueError(f"{what!r} cannot be drawn; one of overview, face_height, {', '.join(life.values)}")
    if not life["states"]:
        raise ValueError("this life has no states to draw")
    if what == "overview" and (axes is not None or label is not None or style):
        raise ValueError("'overview' is a figure of several panels: axes, label and style are for one value")
    own = {} if label is None else {"label": plain(label)}
    names = _LIFE if what == "overview" else (what,)
    figure = new_figure(len(names)) if axes is None else axes.figure
    panels = numpy.atleast_1d(figure.subplots(len(names), 1, sharex=True)) if axes is None else [axes]
    for panel, name in zip(panels, names):
        if name == "face_height":
            _draw_faces(panel, life, style)
        else:
            _draw_over_hours(panel, life, name, {**({} if axes is not None else TOTAL), **own, **style})
    if what != "face_height":
        panels[-1].set_xlabel("running time [h]", fontsize=8)
    if axes is not None:
        return figure
    if label is not None:
        panels[0].legend(fontsize=7)
    words = (
        "Face of the ring, a line for each of the hours."
        if what == "face_height"
        else (
            "Over the running hours. Dots: measured states; lines between them: interpolated or computed; band: other "
            "interpolations, or the range of fitted wear coefficients."
        )
    )
    return _finish(figure, words, life)
