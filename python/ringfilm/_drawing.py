"""What all figures share: units and labels, the crank axis, captions. matplotlib is only loaded here."""

import textwrap

import numpy

from ._ringfilm import _unit_scale

# Distinct for colour-blind readers and in grey print (Okabe and Ito); one line style a contribution.
TOTAL = {"color": "#000000", "linestyle": "-"}
BOUNDARY = {"color": "#D55E00", "linestyle": "--"}
VISCOUS = {"color": "#0072B2", "linestyle": ":"}

BY_ANGLE = "crank angle [degree], 0 = firing TDC"
_STROKES = ((-270, "intake"), (-90, "compression"), (90, "power"), (270, "exhaust"))
_LABEL_WIDTH, _CAPTION_WIDTH = 28, 140  # letters, as high as a panel and as wide as a figure
_FRAME = "ringfilm-crank-axis"

# Degrees between neighbours beyond which nothing is known of what lies between them.
_GAP = 10.0
_COARSE = 4.0

# Unit, its size in SI, up to how many of it.
_BY_SIZE = {
    "m": (("nm", 1e-9, 1000), ("um", 1e-6, 1000), ("mm", 1e-3, 100)),
    "Pa": (("Pa", 1.0, 1000), ("kPa", 1e3, 1000), ("MPa", 1e6, 1000), ("GPa", 1e9, 1000)),
}


def shown(values, quantity):
    """Values in the unit that people read."""
    factor, offset = _unit_scale(quantity.display_unit, quantity.unit)
    return (numpy.asarray(values) - offset) / factor


def fitting_unit(values, quantity):
    """(unit, size in SI) in which the numbers can be read: that of the quantity, if they are of its size."""
    finite = numpy.abs(numpy.asarray(values)[numpy.isfinite(values)])
    largest = finite.max(initial=0.0)
    factor, offset = _unit_scale(quantity.display_unit, quantity.unit)
    if largest == 0 or offset != 0 or 0.1 <= largest / factor < 1000:
        return quantity.display_unit, factor
    for unit, size, most in _BY_SIZE.get(quantity.unit, ()):
        if 1 <= largest / size < most:
            return unit, size
    plain_units = ((quantity.display_unit, factor), (quantity.unit, 1.0))
    return min(plain_units, key=lambda of: abs(numpy.log10(largest / of[1]) - 1))


def label_of(long_name, unit, width=_LABEL_WIDTH):
    """Words of an axis in lines that fit beside a panel, the unit last."""
    words = long_name if unit in ("", "1") else f"{long_name} [{unit}]"
    return textwrap.fill(words, width, break_long_words=False)


def plain(text):
    """Text of a user, in which matplotlib would take dollars for mathematics."""
    return text.replace("$", r"\$")


def from_intake(angles):
    """Angles from -360 to 360 with the order in which they follow each other there."""
    turned = numpy.where(angles >= 360, angles - 720, angles)
    order = numpy.argsort(turned, kind="stable")
    return turned[order], order


def draw_over_angle(axes, angles, values, **style):
    """A curve that does not run across angles that were not computed; they are points where they are far apart."""
    angles, values = numpy.asarray(angles, float), numpy.asarray(values, float)
    gaps = numpy.flatnonzero(numpy.diff(angles) > _GAP)
    x = numpy.insert(angles, gaps + 1, (angles[gaps] + angles[gaps + 1]) / 2)
    y = numpy.insert(values, gaps + 1, numpy.nan)
    there = numpy.isfinite(numpy.concatenate(([numpy.nan], y, [numpy.nan])))
    alone = numpy.flatnonzero(there[1:-1] & ~there[:-2] & ~there[2:])
    if angles.size > 1 and numpy.median(numpy.diff(angles)) > _COARSE:
        alone = numpy.flatnonzero(there[1:-1])
    look = {"linewidth": 1.3, **style}
    if alone.size:
        marker = {"--": "x", ":": "+"}.get(style.get("linestyle"), "o")
        look = {"marker": marker, "markersize": 3.5 if marker == "o" else 6, "markevery": list(alone), **look}
    (line,) = axes.plot(x, y, **look)
    return line


def from_zero(axes, line):
    """Begins the axis at zero, and leaves its end to all that is drawn into it."""
    is_zero = numpy.nanmax(line.get_ydata(), initial=0.0) <= 0
    axes.update_datalim([(0.0, 0.0), (0.0, 1.0 if is_zero else 0.0)], updatex=False)
    if not is_zero:
        line.sticky_edges.y.append(0.0)
    axes.autoscale_view(scalex=False)


def crank_axis(axes, peak, strokes="above"):
    """From -360 to 360 degree with dead centres, strokes and the peak of the gas pressure; once, if called again.

    strokes: "above", "inside" or "none".
    """
    known = {child.get_gid() for child in axes.get_children()}
    if numpy.isfinite(peak):
        peak = peak - 720 if peak >= 360 else peak
        gid = f"{_FRAME}-{peak:g}"
        if gid not in known:
            axes.axvline(peak, color="0.55", linewidth=0.8, linestyle=(0, (1, 2)), zorder=0, gid=gid)
    if _FRAME in known:
        return
    axes.set_xlim(-360, 360)
    axes.set_xticks(range(-360, 361, 90))
    for angle in (-360, -180, 0, 180, 360):
        axes.axvline(angle, color="0.8", linewidth=0.8, zorder=0, gid=_FRAME)
    up = strokes == "above"
    if strokes == "inside":
        axes.set_ymargin(0.1)  # space for the text
    for angle, stroke in _STROKES if strokes != "none" else ():
        axes.annotate(
            stroke,
            (angle, 1),
            xycoords=("data", "axes fraction"),
            xytext=(0, 2 if up else -2),
            textcoords="offset points",
            ha="center",
            va="bottom" if up else "top",
            fontsize=7,
            color="0.45",
        )


def dotted_line(result):
    """The sentence of a caption on the line of the peak pressure."""
    return " Dotted grey line: peak of the gas pressure." if numpy.isfinite(result.peak_gas_pressure_angle) else ""


def new_figure(n_panels):
    """A figure for panels one above the other."""
    from ._shown_figure import ShownFigure

    figure = ShownFigure(figsize=(7.5, 1.2 + 2.0 * n_panels), layout="constrained")
    figure.get_layout_engine().set(w_pad=0.1, h_pad=0.08)
    return figure


def caption(figure, text):
    """Writes below the panels, in as many lines as it takes."""
    lines = textwrap.wrap(text, _CAPTION_WIDTH)
    height = (0.06 + 0.145 * len(lines)) / figure.get_figheight()
    figure.get_layout_engine().set(rect=(0, height, 1, 1 - height))
    figure.text(
        0.0133,
        0.06 / figure.get_figheight(),
        plain("\n".join(lines)),
        fontsize=7,
        color="0.3",
        va="bottom",
        linespacing=1.3,
    )
