"""Fields along the face: few crank angles as curves, many as a map."""

import numpy

from ._drawing import BY_ANGLE, crank_axis, dotted_line, from_intake, from_zero, label_of

FIELDS = (
    "film_thickness",
    "film_pressure",
    "film_content",
    "local_lambda_ratio",
    "asperity_pressure",
    "local_deformation",
)

_FEW_ANGLES = 8
_HIGH = 60  # letters along the axis of a figure of one large panel
_BY_PLACE = "position from the chamber edge [mm]"
_UNITS = {"m": ("um", 1e-6), "Pa": ("bar", 1e5)}


def draw_field(axes, result, name, style, strokes):
    """Few angles as curves along the face, many as a map that stays blank where nothing was computed."""
    variables, _ = result._dataset()
    if name not in variables:
        raise ValueError(f"this result has no field {name}: state output.fields in the case")
    _, values, attributes = variables[name]
    unit, factor = _UNITS.get(attributes.get("units", "1"), ("1", 1.0))
    angles, order = from_intake(numpy.asarray(variables["field_crank_angle"][1]))
    values = numpy.asarray(values)[order] / factor
    x = numpy.asarray(variables["x"][1]) * 1e3
    if len(angles) <= _FEW_ANGLES:
        return _draw_profiles(axes, x, angles, values, (name, attributes["long_name"], unit), style, strokes)
    return _draw_map(axes, result, (x, angles, values), (name, attributes["long_name"], unit), style, strokes)


def _draw_profiles(axes, x, angles, values, words, style, strokes):
    from matplotlib import colormaps

    name, long_name, unit = words
    whose = style.pop("label", "")
    styles = ("-", "--", "-.", ":")
    for i, (angle, along) in enumerate(zip(angles, values)):
        look = {"color": colormaps["viridis"](0.85 * i / max(len(angles) - 1, 1)), "linestyle": styles[i % 4]}
        label = f"{angle:g} degree"
        look = style if strokes == "inside" else {**look, **style}
        (line,) = axes.plot(x, along, **{"linewidth": 1.3, **look}, label=f"{whose}, {label}" if whose else label)
        if along.min() >= 0:
            from_zero(axes, line)
    if name == "film_content":
        axes.set_ylim(0, 1.05)
    axes.set_xlabel(_BY_PLACE, fontsize=8)
    axes.set_ylabel(label_of(long_name, unit, _HIGH), fontsize=8)
    if strokes != "inside":
        axes.legend(fontsize=7, title="crank angle", title_fontsize=7)
    reported = ", ".join(f"{angle:g}" for angle in angles)
    return f"{long_name[0].upper()}{long_name[1:]}, at a crank angle of {reported} degree."


def _edges(middles):
    """Edges of cells around their middles."""
    between = (middles[1:] + middles[:-1]) / 2
    return numpy.concatenate(([2 * middles[0] - between[0]], between, [2 * middles[-1] - between[-1]]))


def _columns(angles, values):
    """Edges and columns of a map over crank angle, each no wider than the usual step; blank between."""
    step = numpy.median(numpy.diff(angles))
    if 720 - (angles[-1] - angles[0]) <= 1.5 * step:  # the cycle closes
        angles, values = numpy.append(angles, angles[0] + 720), numpy.concatenate((values, values[:1]))
    middle = (angles[1:] + angles[:-1]) / 2
    right = numpy.minimum(numpy.append(middle, numpy.inf), angles + step / 2)
    left = numpy.maximum(numpy.append(-numpy.inf, middle), angles - step / 2)
    blank = numpy.flatnonzero(left[1:] > right[:-1] + 1e-9)
    edges = numpy.append(numpy.insert(left, blank + 1, right[blank]), right[-1])
    return edges, numpy.insert(values, blank + 1, numpy.nan, axis=0)


def _limits(name, values):
    """The scale of a colour bar: from zero, and logarithmic where the wide gap at the edges would hide the film."""
    from matplotlib.colors import LogNorm

    if name == "film_content":
        return {"vmin": 0.0, "vmax": 1.0}
    low, high = numpy.nanmin(values), numpy.nanmax(values)
    if name in ("film_thickness", "local_lambda_ratio") and 0 < 20 * low < high:
        return {"norm": LogNorm(low, high)}
    return {"vmin": min(low, 0.0), "vmax": high if high > 0 else 1.0}


def _draw_map(axes, result, field, words, style, strokes):
    from matplotlib.colors import LogNorm
    from matplotlib.ticker import LogLocator

    x, angles, values = field
    name, long_name, unit = words
    style.pop("label", None)
    edges, columns = _columns(angles, values)
    limits = {} if style.keys() & {"norm", "vmin", "vmax"} else _limits(name, values)
    look = {"cmap": "viridis", "rasterized": True, "zorder": -1, **limits, **style}
    mesh = axes.pcolormesh(edges, _edges(x), columns.T, **look)
    ticks = {"ticks": LogLocator(subs=(1, 2, 5)), "format": "%g"} if isinstance(mesh.norm, LogNorm) else {}
    axes.figure.colorbar(mesh, ax=axes, **ticks).set_label(label_of(long_name, unit, _HIGH), fontsize=8)
    axes.set_xlabel(BY_ANGLE, fontsize=8)
    axes.set_ylabel(_BY_PLACE, fontsize=8)
    # Words inside could not be read on the colours, above they would run into a title of the owner.
    crank_axis(axes, result.peak_gas_pressure_angle, "above" if strokes == "above" else "none")
    reported = f"{long_name[0].upper()}{long_name[1:]} at {len(angles)} crank angles"
    blank = ", white where none was computed" if numpy.isnan(columns).any() or edges[-1] - edges[0] < 720 else ""
    return f"{reported}{blank}.{dotted_line(result)}"
