"""Charts of measurements: surfaces, their parameters, friction loops."""

import math
import statistics

import numpy
import ringfilm

from chart import LEFT, RIGHT, Panel, Style, legend
from cycle_charts import LINES, curves, cycle_panel
from shipped import RINGS, ROOT, case, ring
from svg import BLACK, BLUE, GREEN, GREY, ORANGE, RED, WIDTH, Picture

ACROSS = WIDTH - LEFT - RIGHT
MEASURED = ROOT / "cases" / "measured"
ROW = 100


def heights(name):
    found = ringfilm.surface.read(str(MEASURED / name))
    return found.heights, found.step


def surface_steps():
    """One row of a map of the new ring after each step of its preparation."""
    raw, step = heights("ring_new.x3p")
    tilt = ringfilm.surface.prepare(raw, step, form="tilt")
    fine = ringfilm.surface.prepare(raw, step, form="tilt", short_cutoff=4e-6)
    rough = ringfilm.surface.prepare(raw, step, form="tilt", short_cutoff=4e-6, long_cutoff=40e-6)
    picture = Picture("One row of a height map, as read and after levelling and filters", 640)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC surface", anchor="end", size=12, colour="#a00")
    rows = (
        ("as read, about its mean", raw - numpy.nanmean(raw), BLACK),
        ("F-operation: tilt removed", tilt, BLUE),
        ("S-filter, short cut-off 4 µm: finer waves removed", fine, GREEN),
        ("L-filter, long cut-off 40 µm: longer waves removed", rough, RED),
    )
    places = [1e6 * step[0] * i for i in range(raw.shape[1])]
    for k, (title, values, colour) in enumerate(rows):
        panel = Panel(picture, LEFT, 40 + 146 * k, ACROSS, 100, (0, places[-1]), (-1.5, 1.5))
        panel.title(title)
        panel.y_axis("", [-1.5, 0, 1.5], zero=True)
        panel.x_axis("x [µm]" if k == 3 else "", range(0, 101, 20))
        if k:
            panel.curve(places, 1e6 * rows[k - 1][1][ROW], Style("#bbb", width=1))
        panel.curve(places, 1e6 * values[ROW], Style(colour, width=1.2))
    picture.text(16, 320, "height [µm]", anchor="middle", turn=-90)
    return picture


def material_ratio():
    """The material ratio curve of the liner's map with its core."""
    raw, step = heights("liner.sur")
    level = ringfilm.surface.prepare(raw, step, form="tilt", short_cutoff=1e-6, long_cutoff=80e-6)
    curve = 1e6 * ringfilm.surface.material_ratio_curve(level, step)
    core = ringfilm.surface.core_roughness(1e-6 * curve)
    picture = Picture("Material ratio curve with its core", 370)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC surface", anchor="end", size=12, colour="#a00")
    ratios = (numpy.arange(curve.size) + 0.5) / curve.size
    shares = numpy.concatenate([0.5 * numpy.linspace(0, 1, 121) ** 2, 1 - 0.5 * numpy.linspace(1, 0, 121) ** 2])
    panel = Panel(picture, LEFT, 40, ACROSS - 150, 270, (0, 100), (-1.5, 1.5))
    panel.y_axis("height [µm]", [-1.5, -1, -0.5, 0, 0.5, 1, 1.5], zero=True)
    panel.x_axis("material ratio [%]", range(0, 101, 20))
    panel.frame()
    panel.curve(100 * shares, numpy.interp(shares, ratios, curve), Style(BLUE, width=2.2))
    # The line of least squares falls by Rk over the whole range and cuts the curve at Mr1.
    rk = 1e6 * core.Rk_m
    upper = float(numpy.interp(core.Mr1, ratios, curve))
    panel.curve([0, 100], [upper, upper - rk], Style(ORANGE, "7 3"))
    for height in (upper, upper - rk):
        panel.level(height, Style(GREY, "3 3", 1))
    for place, words in ((core.Mr1, "Mr1"), (core.Mr2, "Mr2")):
        panel.upright(100 * place, Style(GREEN, "3 3", 1.2), words, y=panel.top + panel.height - 8)
    right = panel.left + panel.width + 14
    for height, words, colour in (
        (upper + 0.3, f"Rpk {1e6 * core.Rpk_m:.3f} µm", RED),
        (upper - rk / 2, f"Rk {rk:.3f} µm (core)", ORANGE),
        (upper - rk - 0.3, f"Rvk {1e6 * core.Rvk_m:.3f} µm", BLUE),
    ):
        picture.text(right, panel.at(0, height)[1] + 4, words, colour=colour)
    return picture


def cutoff():
    """Parameters of one map against the short cut-off."""
    raw, step = heights("ring_new.x3p")
    level = ringfilm.surface.prepare(raw, step, form="tilt")
    cutoffs = [1e-6 * value for value in (1, 1.5, 2, 3, 4, 6, 8)]
    density, radius, rms = [], [], []
    for value in cutoffs:
        filtered = ringfilm.surface.prepare(level, step, form="none", short_cutoff=value, long_cutoff=80e-6)
        measures = ringfilm.surface.surface_measures(filtered, step)
        single = ringfilm.surface.single_parameters(measures)
        density.append(single.density_per_m2)
        radius.append(single.beta_m)
        rms.append(single.sigma_m)
    picture = Picture("Density, radius and roughness of asperities against the short cut-off", 340)
    lines = (
        (density, Style(BLUE), "density N"),
        (radius, Style(RED, "7 3"), "radius β"),
        (rms, Style(BLACK, "2 3"), "roughness σ"),
    )
    legend(picture, LEFT, 20, [(style, words) for _, style, words in lines], 140)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC surface", anchor="end", size=12, colour="#a00")
    panel = Panel(picture, LEFT, 40, ACROSS, 230, (0.9, 9), (0.03, 30), "xy")
    panel.y_axis("value over that at 1 µm [-]", [0.1, 1, 10])
    panel.x_axis("short cut-off [µm]", (1, 1.5, 2, 3, 4, 6, 8))
    panel.frame()
    for values, style, _ in lines:
        panel.curve([1e6 * value for value in cutoffs], [value / values[0] for value in values], style)
        panel.points([1e6 * value for value in cutoffs], [value / values[0] for value in values], style.colour)
    return picture


def pair_contact():
    """What a pair of maps carries, and what is left for the flow, against the separation."""
    step = heights("ring_new.x3p")[1]
    ring_map, liner_map = (
        ringfilm.surface.prepare(heights(name)[0], step, form="tilt", short_cutoff=2e-6, long_cutoff=80e-6)
        for name in ("ring_new.x3p", "liner.sur")
    )
    separations = [1e-6 * value for value in (0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0, 1.1, 1.2)]
    laws = {}
    for words, hardness in (("elastic", None), ("capped at 2.5 GPa", 2.5e9)):
        laws[words] = ringfilm.surface.contact_law(
            ring_map, step, separations, 134.8e9, hardness, liner_map, shifts=3, flow_factors=hardness is not None
        )
    measures = [ringfilm.surface.surface_measures(one, step) for one in (ring_map, liner_map)]
    pair = ringfilm.surface.pair_parameters(*measures, "rq")
    by_summits = ringfilm.laws.GreenwoodTripp(pair.density_per_m2, pair.beta_m, pair.sigma_m, 134.8e9)
    picture = Picture("Contact pressure and flow factors of a pair of maps against their separation", 370)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC surfaces", anchor="end", size=12, colour="#a00")
    x = [1e6 * h for h in separations]
    left = Panel(picture, LEFT, 50, 290, 250, (0.2, 1.3), (0.1, 3000), "y")
    left.title("contact pressure [MPa]")
    left.y_axis("", [0.1, 1, 10, 100, 1000])
    left.x_axis("separation h [µm]", [0.2, 0.4, 0.6, 0.8, 1, 1.2])
    left.frame()
    styles = {"elastic": Style(BLUE), "capped at 2.5 GPa": Style(RED, "7 3")}
    for words, law in laws.items():
        left.curve(x, 1e-6 * law["contact_pressure"], styles[words])
        spread = law["contact_pressure_deviation"]
        low, high = law["contact_pressure"] - spread, law["contact_pressure"] + spread
        left.band(x, [max(0.1, 1e-6 * value) for value in low], 1e-6 * high, styles[words].colour, 0.2)
    left.curve(x, [1e-6 * float(by_summits.pressure(h)) for h in separations], Style(BLACK, "2 3"))
    right = Panel(picture, LEFT + 366, 50, 290, 250, (0.2, 1.3), (0, 1))
    right.title("flow factors [-]")
    right.y_axis("", [0, 0.25, 0.5, 0.75, 1])
    right.x_axis("separation h [µm]", [0.2, 0.4, 0.6, 0.8, 1, 1.2])
    right.frame()
    flow = laws["capped at 2.5 GPa"]
    for name, style in (("phi_x", Style(BLUE)), ("phi_y", Style(ORANGE, "7 3")), ("phi_s", Style(GREEN, "2 3"))):
        right.curve(x, flow[name], style)
    entries = [(styles[words], words) for words in laws] + [(Style(BLACK, "2 3"), "by N, β, σ of the sum")]
    legend(picture, LEFT - 40, 360, entries, [95, 175, 0])
    entries = [(Style(BLUE), "φ_{x}"), (Style(ORANGE, "7 3"), "φ_{y}"), (Style(GREEN, "2 3"), "φ_{s}")]
    legend(picture, LEFT + 450, 360, entries, 70)
    return picture


def loop_rows(name):
    """Rows (load [nN], loop, position [um], trace [mV], retrace [mV]) of a file of friction loops."""
    lines = (MEASURED / name).read_text(encoding="utf-8").splitlines()
    return [[float(cell) for cell in line.split(",")] for line in lines if line[:1].isdigit()]


def friction_loop():
    """One loop, and the line of friction over load of three rings."""
    picture = Picture("A friction loop, and friction signal over load of three samples", 380)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC loops", anchor="end", size=12, colour="#a00")
    rows = loop_rows("loops_new.csv")
    load = max(row[0] for row in rows)
    loop = [row for row in rows if row[0] == load and row[1] == rows[0][1]]
    x = [row[2] for row in loop]
    limit = math.ceil(max(abs(value) for row in loop for value in row[3:5]) / 5) * 5
    one = Panel(picture, LEFT, 50, 290, 250, (0, math.ceil(x[-1])), (-limit, limit))
    one.title(f"one loop of the new ring at {load:g} nN")
    one.y_axis("lateral signal [mV]", [-limit, -limit / 2, 0, limit / 2, limit], zero=True)
    one.x_axis("position [µm]", range(0, math.ceil(x[-1]) + 1))
    one.frame()
    one.curve(x, [row[3] for row in loop], Style(BLUE, width=1.2))
    one.curve(x, [row[4] for row in loop], Style(RED, "5 2", 1.2))
    legend(picture, LEFT, 366, ((Style(BLUE), "trace"), (Style(RED, "5 2"), "retrace")), 100)
    kept = loop[len(loop) // 10 : -len(loop) // 10]
    half = 0.5 * statistics.fmean(row[3] - row[4] for row in kept)
    middle = 0.5 * statistics.fmean(row[3] + row[4] for row in kept)
    px, top = one.at(0.5 * one.x[1], middle + half)
    low = one.at(0, middle)[1]
    picture.arrow(px, low, px, top, both=True)
    picture.text(px + 6, (low + top) / 2 + 4, "TMR")
    line = Panel(picture, LEFT + 366, 50, 290, 250, (0, 60), (0, 20))
    line.title("friction signal over load")
    samples = (("loops_new.csv", Style(BLUE), "new"), ("loops_run_in.csv", Style(ORANGE, "7 3"), "run-in"))
    samples += (("loops_embedded.csv", Style(BLACK, "2 3"), "embedded"),)
    read = [(ringfilm.lateral_force.read(str(MEASURED / name))[0], style, words) for name, style, words in samples]
    most_load = max(1e9 * entry.load for sample, _, _ in read for entry in sample.loads)
    most = max(1e3 * entry.tmr_V for sample, _, _ in read for entry in sample.loads)
    line.x, line.y = (0, math.ceil(most_load / 10) * 10 + 5), (0, math.ceil(most / 4) * 4)
    line.x_axis("load [nN]", range(0, int(line.x[1]) + 1, 10))
    line.y_axis("TMR [mV]", [line.y[1] * i / 4 for i in range(5)], label_gap=44)
    line.frame()
    for sample, style, _ in read:
        line.points(
            [1e9 * entry.load for entry in sample.loads], [1e3 * entry.tmr_V for entry in sample.loads], style.colour
        )
        ends = [0, line.x[1]]
        line.curve(
            ends, [1e3 * (sample.line.offset + sample.line.slope * 1e-9 * value) for value in ends], style, cut=True
        )
    legend(picture, LEFT + 346, 366, [(style, words) for _, style, words in read], [90, 105, 0])
    return picture


def measured_cycle():
    """Film and friction of the cases with measured fragments, next to those of the paper's tables."""
    picture = Picture("Film and friction of three rings from synthetic measurements and from the paper's tables", 480)
    picture.text(WIDTH - RIGHT, 20, "SYNTHETIC", anchor="end", size=12, colour="#a00")
    legend(
        picture,
        LEFT,
        20,
        [(LINES[name], f"{name} ring") for name in RINGS] + [("#bbb", "paper's tables")],
        [130, 130, 155, 0],
    )
    shown = (
        ("min_film_thickness", 1e6, "minimum film thickness h_{m} [µm]", 4, range(0, 5)),
        ("total_friction", 1, "total friction [N]", 500, range(0, 501, 100)),
    )
    for k, (name, factor, title, highest, ticks) in enumerate(shown):
        panel = cycle_panel(picture, 60 + 205 * k, 150, 0, highest)
        panel.title(title)
        panel.y_axis("", ticks)
        panel.crank(last=k == 1)
        for life in RINGS:
            angle, values = curves(ring(life), name)
            panel.curve(angle, [factor * value for value in values], Style("#bbb", width=5))
        for life in RINGS:
            angle, values = curves(case(f"measured/{life.replace('-', '_')}.toml").run(), name)
            panel.curve(angle, [factor * value for value in values], LINES[life])
    return picture


PICTURES = {
    "measured-cycle": measured_cycle,
    "surface-steps": surface_steps,
    "material-ratio": material_ratio,
    "cutoff": cutoff,
    "pair-contact": pair_contact,
    "friction-loop": friction_loop,
}
