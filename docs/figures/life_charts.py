"""Charts of lives: faces and friction power between measured states, and the law of running-in."""

import functools
import json
import math
import pathlib
import subprocess
import sys
import tempfile

from shipped import ROOT
from chart import LEFT, RIGHT, Panel, Style, legend, mark_synthetic
from svg import BLACK, BLUE, GREEN, ORANGE, RED, WIDTH, Picture

LIFE = ROOT / "cases" / "life" / "styles2014.toml"
SHOWN = "0 h 1 h 3 h 10 h 30 h 75 h 150 h"
HOURS = (0, 0.3, 0.6, 1, 2, 3, 5, 7, 10, 15, 20, 30, 50, 75, 100, 125, 150)


def computed(text):
    """What `ringfilm life` prints of a life as JSON."""
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "life.toml"
        path.write_text(text.replace('case = "../', f'case = "{ROOT}/cases/'), encoding="utf-8")
        command = [sys.executable, "-m", "ringfilm", "life", str(path), "--json"]
        return json.loads(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


@functools.lru_cache(maxsize=None)
def shipped_path():
    """The shipped life at more hours."""
    lines = LIFE.read_text(encoding="utf-8").splitlines()
    hours = ", ".join(f'"{hour} h"' for hour in HOURS)
    return computed("\n".join(f"hours = [{hours}]" if line.startswith("hours = [") else line for line in lines))


def path():
    """Faces at seven running times, and the friction power with its band."""
    picture = Picture("Faces and friction power of the ring of styles2014 over its running hours", 350)
    mark_synthetic(picture)
    life = shipped_path()
    half = (WIDTH - LEFT - RIGHT - 92) / 2
    faces = Panel(picture, LEFT, 60, half, 220, (0, 1.2), (0, 32))
    faces.title("face above its lowest point [µm]")
    faces.x_axis("place on the face x [mm]", [0, 0.3, 0.6, 0.9, 1.2])
    faces.y_axis("", range(0, 31, 10))
    faces.frame()
    x = [1e3 * value for value in life["x"]][::4]
    for state in life["states"]:
        if f"{state['hours']:g} h" not in SHOWN:
            continue
        known = state["state_origin"] == "measured"
        colour = {0: BLUE, 10: ORANGE, 150: BLACK}.get(state["hours"], RED)
        style = Style(colour, "" if known else "4 3", 2.4 if known else 1.0)
        faces.curve(x, [1e6 * value for value in state["face_height"]][::4], style)
    legend(
        picture,
        LEFT,
        340,
        [
            (Style(BLUE, width=2.4), "new"),
            (Style(ORANGE, width=2.4), "run-in, 10 h"),
            (Style(BLACK, width=2.4), "embedded, 150 h"),
            (Style(RED, "4 3", 1.0), "interpolated"),
            ("#bcd9ec", "band"),
        ],
        step=[80, 132, 152, 124, 0],
    )
    draw_power(Panel(picture, LEFT + half + 92, 60, half, 220, (0, math.log(151)), (0, 140)), life["states"])
    return picture


def draw_power(panel, states):
    place = [math.log1p(state["hours"]) for state in states]
    panel.title("friction power [W]")
    ticks = (0, 1, 3, 10, 30, 75, 150)
    panel.x_axis(
        "running time [h], as ln(1 + t/1 h)", [math.log1p(tick) for tick in ticks], names=[str(t) for t in ticks]
    )
    panel.y_axis("", range(0, 141, 20))
    bands = [state["band"]["mean_power_loss"] for state in states]
    panel.band(place, [low for low, _ in bands], [high for _, high in bands], BLUE)
    panel.curve(place, [state["mean_power_loss"] for state in states], Style(BLUE))
    measured = [state for state in states if state["state_origin"] == "measured"]
    panel.points(
        [math.log1p(state["hours"]) for state in measured], [state["mean_power_loss"] for state in measured], BLACK, 4
    )
    panel.frame()


def running_in():
    """Roughness and share of the worn volume over the worn depth, both in closed form."""
    picture = Picture("Roughness that runs in, and the share of the worn volume that peaks lose", 370)
    half = (WIDTH - LEFT - RIGHT - 92) / 2
    depths = [0.02 * k for k in range(1, 201)]  # over the depth scale
    roughness = Panel(picture, LEFT, 50, half, 220, (0, 4), (0, 1))
    roughness.title("roughness over that at the start")
    share = Panel(picture, LEFT + half + 92, 50, half, 220, (0, 4), (0, 1))
    share.title("share of the worn volume")
    for panel in (roughness, share):
        panel.x_axis("largest worn depth over the depth scale", range(5))
        panel.y_axis("", [0, 0.2, 0.4, 0.6, 0.8, 1])
    for limit, colour in ((0.35 / 0.48, BLUE), (0.4, ORANGE)):
        everywhere = [limit + (1 - limit) * math.exp(-depth) for depth in depths]
        # A depth that falls exponentially along the stroke: the mean over the worn volume in closed form.
        along = [limit + (1 - limit) * -math.expm1(-depth) / depth for depth in depths]
        roughness.curve([0, *depths], [1, *everywhere], Style(colour))
        roughness.curve([0, *depths], [1, *along], Style(colour, "7 3"))
        roughness.curve([0, 4], [limit, limit], Style(colour, "2 3", 1.0))
    for least, colour in ((1, BLACK), (0.52, BLUE), (0.2, GREEN)):
        share.curve([0, *depths], [least, *(least * -math.expm1(-depth) / depth for depth in depths)], Style(colour))
    for panel in (roughness, share):
        panel.frame()
    entries = [(Style(BLACK), "uniform depth"), (Style(BLACK, "7 3"), "depth that falls along the stroke")]
    legend(picture, LEFT, 332, [*entries, (Style(BLACK, "2 3", 1.0), "limit")], step=[160, 280, 0])
    entries = [(Style(BLACK), "least depth scale"), (Style(BLUE), "1.9 times"), (Style(GREEN), "5 times the least")]
    legend(picture, LEFT, 356, [*entries], step=[180, 120, 0])
    return picture


PICTURES = {"path": path, "running_in": running_in}
