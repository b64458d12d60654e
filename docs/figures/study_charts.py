"""Charts of studies: points of plans, distribution, band over the cycle, indices, a map."""

import functools
import pathlib
import tempfile

import numpy
import ringfilm

from shipped import ROOT
from chart import LEFT, RIGHT, Panel, Style, legend, mark_synthetic
from cycle_charts import cycle_panel
from film_charts import SCALE, Turned, field
from svg import BLACK, BLUE, GREY, ORANGE, WIDTH, Picture

ACROSS = WIDTH - LEFT - RIGHT
STUDIES = ROOT / "cases" / "studies"


def study(name, old, new):
    """A shipped study with one part of its text replaced."""
    text = (STUDIES / name).read_text(encoding="utf-8")
    if old not in text:
        raise ValueError(f"{name} has no {old}")
    text = text.replace(old, new).replace('case = "', f'case = "{STUDIES}/').replace("../../data", f"{ROOT}/data")
    return read(text)


def read(text):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "study.toml"
        path.write_text(text, encoding="utf-8")
        return ringfilm.Study.read(str(path))


@functools.lru_cache(maxsize=None)
def uncertainty():
    """The shipped study of the new ring with its curves, computed."""
    kept = 'curves = "all"\nquantities = ["total_friction"]'
    return study("new_ring_uncertainty.toml", 'curves = "none"', kept).run()


def plan_points():
    """256 points of two factors by two plans."""
    picture = Picture("256 points of two factors by two plans", 370)
    plans = (("latin-hypercube", "Latin hypercube"), ("sobol", "scrambled Sobol points"))
    for k, (method, title) in enumerate(plans):
        panel = Panel(picture, LEFT + 350 * k, 40, 270, 270, (600, 6000), (30, 90))
        panel.title(title)
        panel.x_axis("speed [rpm]", [1000, 2000, 3000, 4000, 5000, 6000])
        panel.y_axis("peak cylinder pressure [bar]" if k == 0 else "", range(30, 91, 10))
        panel.frame()
        points = drawn(method)
        panel.points([60 / 6.283185307179586 * a for a, _ in points], [1e-5 * b for _, b in points], BLUE, 1.6)
    return picture


def drawn(method):
    """Points of a plan with the two numbers of the shipped map as factors, in SI."""
    text = f"""title = "points"
kind = "uncertainty"
seed = 1
[[base]]
name = "new"
case = "{STUDIES}/bases/fired_new_ring.toml"
[[factor]]
key = "operating.speed"
distribution = "uniform"
lower = "600 rpm"
upper = "6000 rpm"
[[factor]]
key = "gas.peak_pressure"
distribution = "uniform"
lower = "30 bar"
upper = "90 bar"
[plan]
method = "{method}"
scenarios = 256
"""
    return read(text).points


def study_band():
    """Friction of the new ring over the cycle under uncertain inputs."""
    data = uncertainty().to_xarray()
    data = data.where(data["sample"] == 1, drop=True)
    angle = [float(a) for a in data.crank_angle]
    curves = data["curve_total_friction"].isel(ring=0).transpose("scenario", "crank_angle").values
    low, first, middle, third, high = numpy.quantile(curves, (0.05, 0.25, 0.5, 0.75, 0.95), 0, method="median_unbiased")
    picture = Picture("Total friction of the new ring with quantiles over the cycle", 350)
    mark_synthetic(picture)
    panel = cycle_panel(picture, 44, 240, 0, 600)
    panel.y_axis("total friction [N]", range(0, 601, 100))
    panel.crank()
    panel.band(angle, low, high, BLUE, 0.25)
    panel.band(angle, first, third, BLUE, 0.45)
    panel.curve(angle, middle, Style(BLACK, width=1.2))
    legend(
        picture,
        LEFT,
        24,
        (("#bfdbec", "5 to 95 %"), ("#7eb6d9", "25 to 75 %"), (Style(BLACK, width=1.2), "median")),
        120,
    )
    return picture


def study_indices():
    """Distribution of FMEP and what it depends on."""
    result = uncertainty()
    rows = result.sobol_indices("fmep")
    statistics = result.statistics("fmep")
    data = result.to_xarray()
    values = sorted(1e-3 * float(v) for v in data["fmep"].where(data["sample"] == 1, drop=True))
    picture = Picture("Distribution of FMEP of the new ring and its variance-based sensitivity", 330)
    mark_synthetic(picture)
    left = Panel(picture, LEFT, 44, 250, 220, (10, 30), (0, 100))
    left.title("distribution of FMEP")
    left.y_axis("share below [%]", range(0, 101, 25))
    left.x_axis("FMEP [kPa]", range(10, 31, 5))
    left.frame()
    left.curve(values, [100 * (i + 0.5) / len(values) for i in range(len(values))], Style(BLUE))
    for share in (0.05, 0.5, 0.95):
        at = 1e-3 * statistics["quantiles"][share]
        left.points([at], [100 * share], BLACK, 3.5)
        x, y = left.at(at, 100 * share)
        picture.text(x + 9, y + (16 if share > 0.9 else 4), f"{at:.1f} kPa", size=12)
    right = Panel(picture, 520, 44, 200, 220, (0, 0.8), (0, len(rows)))
    right.title("share of the variance")
    right.x_axis("index [-]", [0, 0.2, 0.4, 0.6, 0.8])
    for i, row in enumerate(sorted(rows, key=lambda one: one["total"])):
        words = row["factor"].replace(" and asperity ", ", ")
        picture.text(512, right.at(0, i + 0.5)[1] + 4, words, anchor="end", size=12)
        for shift, kind, colour in ((0.68, "first", BLUE), (0.32, "total", ORANGE)):
            y = right.at(0, i + shift)[1]
            x0, x1 = right.at(0, 0)[0], right.at(row[kind], 0)[0]
            picture.rect(x0, y - 6, max(0.0, x1 - x0), 12, fill=colour, stroke="none")
            low, high = (right.at(min(0.8, max(0.0, end)), 0)[0] for end in row[f"{kind}_interval"])
            picture.line(low, y, high, y, stroke="#222", width=1)
    legend(picture, 520, 322, ((BLUE, "first"), (ORANGE, "total")), 100)
    picture.text(LEFT, 322, "thin lines: 95 % interval", colour=GREY, size=12)
    return picture


def study_map():
    """FMEP over speed and load."""
    grades = ('"../../data/lubricants/sae-0w-20.toml", ', ', "../../data/lubricants/sae-10w-40.toml"')
    oils = '"../../data/lubricants/sae-5w-30.toml"'.join(grades)
    data = study("new_ring_map.toml", oils, '"../../data/lubricants/sae-5w-30.toml"').run().to_pandas()
    speed, peak = (next(name for name in data.columns if part in name) for part in ("speed", "peak"))
    table = data.pivot(index=peak, columns=speed, values="fmep")
    x = [float(value) for value in table.columns]
    x = [value * 60 / 6.283185307179586 for value in x] if x[-1] < 1000 else x
    y = [float(value) * 1e-5 for value in table.index]
    picture = Picture("FMEP of the new ring over speed and peak pressure", 380)
    panel = Panel(picture, LEFT, 40, ACROSS - 130, 280, (x[0], x[-1]), (y[0], y[-1]))
    panel.title("FMEP of the new ring [kPa], SAE 5W-30")
    values = 1e-3 * table.to_numpy()
    field(picture, Turned(panel), x, y, values.T, 45)
    panel.frame()
    panel.x_axis("speed [rpm]", range(1000, 6001, 1000), grid=False)
    for tick in range(30, 91, 10):
        picture.text(LEFT - 7, panel.at(x[0], tick)[1] + 4, str(tick), anchor="end", size=12)
    picture.text(20, 180, "peak cylinder pressure [bar]", anchor="middle", turn=-90)
    for i, colour in enumerate(SCALE):
        picture.rect(WIDTH - 120, 320 - 280 * (i + 1) / 9, 20, 280 / 9, fill=colour, stroke="none")
        picture.text(WIDTH - 94, 320 - 280 * i / 9 + 4, str(5 * i), size=12)
    return picture


def accuracy_study(solver, sample):
    """64 speeds, loads and cavitation models of the new ring; `solver` are lines of its case."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder)
        base = f"{STUDIES}/bases/fired_new_ring.toml"
        (path / "case.toml").write_text(f'include = ["{base}"]\n[solver]\n{solver}', encoding="utf-8")
        text = f"""kind = "uncertainty"
[[base]]
case = "case.toml"
[[factor]]
key = "operating.speed"
range = ["1000 rpm", "6000 rpm"]
[[factor]]
key = "gas.peak_pressure"
range = ["30 bar", "90 bar"]
[[factor]]
key = "film.cavitation"
values = ["reynolds-exit", "mass-conserving"]
[plan]
method = "sobol"
scenarios = 64
[accuracy]
sample = {sample}
"""
        (path / "study.toml").write_text(text, encoding="utf-8")
        return ringfilm.Study.read(str(path / "study.toml")).run()


def study_accuracy():
    """The error that a study estimates on 16 of its scenarios, against the true one of all."""
    picture = Picture("Estimated and true 95 % quantile of the relative error of all values of a study", 400)
    fine = 'cells = 1024\ncell_lengths = "by-gap"\ncrank_step = "0.5 degree"\ntime_scheme = "bdf2"\nstep_error = 1e-6\n'
    finest = accuracy_study(fine, 0)
    ends = (1e-3, 100)
    ticks = [1e-3, 1e-2, 1e-1, 1, 10, 100]
    panel = Panel(picture, LEFT, 44, 300, 300, ends, ends, "xy")
    panel.title("relative error of each value, 95 % quantile")
    panel.y_axis("estimated on 16 scenarios [%]", ticks)
    panel.x_axis("of all 64 scenarios, against 1024 cells [%]", ticks)
    panel.frame()
    panel.curve(ends, ends, Style(GREY, width=1))
    for k, (asked, colour) in enumerate((("5 %", ORANGE), ("0.5 %", BLUE))):
        study_ = accuracy_study(f'accuracy = "{asked}"\n', 16)
        estimate = study_.accuracy["relative_error"]
        true = {name: _true_error(name, study_, finest) for name in estimate}
        shown = [
            name for name in estimate if ends[0] < true[name] < ends[1] and ends[0] < 100 * estimate[name] < ends[1]
        ]
        panel.points([true[name] for name in shown], [100 * estimate[name] for name in shown], colour, 3)
        within = 100 * study_.accuracy["coverage"]
        picture.circle(430, 80 + 46 * k, 4, fill=colour, stroke=colour)
        picture.text(444, 84 + 46 * k, f"accuracy asked for: {asked}")
        picture.text(444, 102 + 46 * k, f"coverage on the sample: {within:.0f} %", size=12, colour=GREY)
    picture.text(444, 192, "line: estimate and truth are equal", size=12, colour=GREY)
    return picture


def _true_error(name, study_, finest):
    """95 % quantile [%] over all scenarios."""
    exact = finest["mean_absolute_oil_flow" if name == "net_oil_flow" else name]
    errors = numpy.abs(study_[name] - finest[name]) / numpy.where(exact == 0, numpy.nan, numpy.abs(exact))
    errors = errors[numpy.isfinite(errors)]
    return 100 * numpy.quantile(errors, 0.95, method="median_unbiased") if len(errors) else numpy.nan


PICTURES = {
    "study-accuracy": study_accuracy,
    "plan-points": plan_points,
    "study-band": study_band,
    "study-indices": study_indices,
    "study-map": study_map,
}
