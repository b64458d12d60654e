"""Charts of measured accuracy and cost, from files that `script/bench` stores: times differ with each run."""

import json
import pathlib

from chart import LEFT, Panel, Style, decades, legend
from svg import BLUE, GREEN, GREY, ORANGE, RED, Picture

MEASURED = pathlib.Path(__file__).resolve().parent / "performance" / "scenario-accuracy.json"
LINES = {  # family of ways: style of its line, name in the legend
    "fixed, first order": (Style(RED, "7 3"), "fixed, 1st order"),
    "adaptive, first order": (Style(ORANGE, "2 2", 2.2), "adaptive, 1st order"),
    "adaptive, second order": (Style(GREEN, "5 2", 1.6), "adaptive, 2nd order"),
    "accuracy": (Style(BLUE, width=2), "solver.accuracy [%]"),
}
REQUESTED = Style(GREY, width=0.8)
QUANTITIES = {
    "fmep": "FMEP",
    "mean_boundary_power": "mean boundary power",
    "min_film_thickness": "minimum film thickness",
    "peak_friction_coefficient": "peak friction coefficient",
    "mean_absolute_oil_flow": "mean absolute oil flow",
    "peak_film_pressure": "peak film pressure",
}
COLUMNS, WIDE, HIGH = 3, 206, 190
TIMES, ERRORS = (0.1, 50), (1e-3, 300)  # [ms], [%]; room for machines three times as fast or as slow


def work_precision():
    """Error of six values against the processor time of a scenario."""
    measured = json.loads(MEASURED.read_text(encoding="utf-8"))
    picture = Picture("Error of six values of the cycle against processor time, by the way of choosing steps", 572)
    entries = [*LINES.values(), (REQUESTED, "error = accuracy")]
    for row, part in enumerate([entries[:3], entries[3:]]):
        legend(picture, LEFT, 22 + 20 * row, part, WIDE + 22)
    for k, (name, title) in enumerate(QUANTITIES.items()):
        row, column = divmod(k, COLUMNS)
        first, last = column == 0, k + COLUMNS >= len(QUANTITIES)
        panel = Panel(picture, LEFT + column * (WIDE + 22), 82 + row * (HIGH + 38), WIDE, HIGH, TIMES, ERRORS, "xy")
        panel.title(title)
        panel.y_axis("95 % quantile of the error [%]" if first else "", decades(-3, 2), None if first else [""] * 6)
        panel.x_axis("processor time [ms]" if last else "", decades(-1, 1), names=None if last else [""] * 3)
        panel.frame()
        draw_ways(panel, measured["ways"], name)
    picture.text(LEFT, 564, f"MEASURED: {measured['scenarios']} random engines, one thread", size=12, colour=GREY)
    return picture


def draw_ways(panel, ways, quantity):
    """Each family as a line through its ways in the order of their time."""
    for family, (style, _) in LINES.items():
        members = sorted((way for way in ways if way["family"] == family), key=lambda way: way["ms_per_scenario"])
        times = [way["ms_per_scenario"] for way in members]
        errors = [100 * way["error_quantile_95"][quantity] for way in members]
        if family == "accuracy":
            accuracies = [way["accuracy_percent"] for way in members]
            panel.curve(times, accuracies, REQUESTED)
            label(panel, times, errors, accuracies)
        panel.curve(times, errors, style)
        panel.points(times, errors, style.colour, 2.6)


def label(panel, times, errors, accuracies):
    """Accuracies at their points; points that almost coincide share one label."""
    labels = []  # [x, y, words] of the first point of each
    for time, error, accuracy in zip(times, errors, accuracies):
        x, y = panel.at(time, error)
        if labels and abs(x - labels[-1][0]) < 12 and abs(y - labels[-1][1]) < 9:
            labels[-1][2] += f", {accuracy:g}"
        else:
            labels.append([x, y, f"{accuracy:g}"])
    for i, (x, y, words) in enumerate(labels):
        below = 11 if i else 0  # the first beside its point, apart from the next
        panel.picture.text(x - 5, y + below, words, anchor="end", size=11, colour=BLUE)


PICTURES = {"work-precision": work_precision}
