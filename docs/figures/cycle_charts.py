"""Charts of the engine cycle: piston, gas, film, friction, power, errors and assumptions."""

import numpy

import ringfilm
from shipped import RINGS, ROOT, case, ring, starting_case
from chart import LEFT, RIGHT, Panel, Style, every, from_firing, legend, mark_synthetic
from svg import BLACK, BLUE, GREEN, GREY, ORANGE, RED, WIDTH, Picture

ACROSS = WIDTH - LEFT - RIGHT
LINES = {"new": Style(BLUE), "run-in": Style(ORANGE, "7 3"), "embedded": Style(BLACK, "2 3")}
TOTAL, BOUNDARY, VISCOUS = Style(BLACK), Style(RED, "7 3"), Style(BLUE, "2 3")


def cycle_panel(picture, top, height, lowest, highest):
    return Panel(picture, LEFT, top, ACROSS, height, (-360, 360), (lowest, highest))


def curves(result, *names):
    """Crank angles from -360 to 360 and curves, every second degree."""
    return every(2, *from_firing(result.crank_angle, *[result[name] for name in names]))


def piston_motion():
    picture = Picture("Position and velocity of the piston over the cycle", 430)
    angle, position, velocity = curves(ring("new"), "piston_position", "piston_velocity")
    top = cycle_panel(picture, 34, 140, 0, 80)
    top.title("distance below top dead centre y_{p} [mm]")
    top.y_axis("", range(0, 81, 20))
    top.crank(last=False)
    top.curve(angle, [1e3 * value for value in position], Style(BLUE))
    low = cycle_panel(picture, 214, 160, -8, 8)
    low.title("piston velocity U_{p} [m/s], positive towards TDC")
    low.y_axis("", range(-8, 9, 4), zero=True)
    low.crank()
    low.curve(angle, velocity, Style(RED))
    return picture


def gas_pressure():
    picture = Picture("Cylinder pressure of a trace and of the model after Wiebe", 340)
    panel = cycle_panel(picture, 50, 230, 0, 70)
    panel.title("cylinder pressure p_{g}, absolute [bar]")
    panel.y_axis("", range(0, 71, 10))
    panel.crank()
    trace, model = ring("new"), starting_case().run()
    for result, style in ((trace, Style(BLUE)), (model, Style(ORANGE, "7 3"))):
        angle, pressure = curves(result, "gas_pressure")
        panel.curve(angle, [value * 1e-5 for value in pressure], style)
    legend(
        picture, 330, 20, ((Style(BLUE), "trace (SYNTHETIC)"), (Style(ORANGE, "7 3"), "model after Wiebe")), step=200
    )
    return picture


def gas_between_rings():
    picture = Picture("Pressures of the cylinder and between the rings over the cycle", 366)
    mark_synthetic(picture)
    panel = cycle_panel(picture, 74, 230, 0.5, 100)
    panel.log = "y"
    panel.title("pressure, absolute [bar], logarithmic")
    panel.y_axis("", [0.5, 1, 2, 5, 10, 20, 50, 100])
    panel.crank()
    pack = ROOT / "cases" / "ring-pack" / "two_rings.toml"
    gas = ringfilm.gas_path(pack, {"gas_path.ring_motion": "axial"})["curves"]
    names = {"chamber": Style(BLACK), "land 2": Style(BLUE), "land 3": Style(ORANGE, "7 3"), "crankcase": Style(GREY)}
    for name, style in names.items():
        angle, pressure = every(2, *from_firing(gas["crank_angle"], gas["pressure"][name]))
        panel.curve(angle, [value * 1e-5 for value in pressure], style)
    words = {"chamber": "chamber", "land 2": "piston land 2", "land 3": "piston land 3", "crankcase": "crankcase"}
    legend(picture, 80, 40, tuple((style, words[name]) for name, style in names.items()), step=150)
    return picture


def pack_friction():
    """Friction of the rings of the shipped pack, one upon the other."""
    picture = Picture("Friction of a ring pack over the cycle, rings added up", 366)
    mark_synthetic(picture)
    panel = cycle_panel(picture, 74, 230, 0, 180)
    panel.title("friction, rings added up [N]")
    panel.y_axis("", range(0, 181, 30))
    panel.crank()
    rings = ringfilm.Case.read(str(ROOT / "cases" / "ring-pack" / "three_rings.toml")).run().rings
    parts = ((rings[:1], Style(BLUE), "top ring"), (rings[1:2], Style(ORANGE, "7 3"), "with second ring"))
    parts += ((rings[2:], Style(BLACK), "pack"),)
    total = 0
    for films, style, _ in parts:
        for film in films:
            angle, friction = curves(film, "total_friction")
            total = total + numpy.array(friction)
        panel.curve(angle, list(total), style)
    legend(picture, 80, 40, tuple((style, words) for _, style, words in parts), step=170)
    return picture


def friction_shares():
    """What carries the load, and what rubs, of the new ring."""
    picture = Picture("Load shares and friction of the new ring over the cycle", 564)
    mark_synthetic(picture)
    result = ring("new")
    names = ("applied_load", "asperity_load", "hydrodynamic_load", "boundary_friction", "viscous_friction")
    angle, load, asperities, film, boundary, viscous = curves(result, *names)
    top = cycle_panel(picture, 44, 150, 0, 100)
    top.title("share of the load carried by asperities [%]")
    top.y_axis("", range(0, 101, 25))
    top.crank(last=False)
    share = [100 * a / w for a, w in zip(asperities, load)]
    top.band(angle, [0] * len(angle), share, RED, 0.45)
    top.band(angle, share, [100] * len(angle), BLUE, 0.25)
    for at, words, colour in (((-90, 70), "film", BLUE), ((18, 20), "asperities", RED)):
        x, y = top.at(*at)
        picture.text(x, y, words, colour=colour, bold=True, anchor="middle")
    low = cycle_panel(picture, 250, 240, 0.01, 1000)
    low.log = "y"
    low.title("friction [N], logarithmic")
    low.y_axis("", [0.01, 0.1, 1, 10, 100, 1000])
    low.crank()
    total = [a + b for a, b in zip(boundary, viscous)]
    low.curve(angle, total, Style(BLACK, width=2.2))
    low.curve(angle, boundary, BOUNDARY, cut=True)
    low.curve(angle, viscous, VISCOUS, cut=True)
    entries = ((TOTAL, "total"), (BOUNDARY, "boundary (asperities)"), (VISCOUS, "viscous (oil)"))
    legend(picture, LEFT + 60, 552, entries, [130, 230, 0])
    return picture


def three_rings(quantities):
    """Panels of the three rings, one below the other: (name, factor, title, highest, ticks, lowest)."""
    picture = Picture(", ".join(quantity[2] for quantity in quantities), 70 + 205 * len(quantities))
    mark_synthetic(picture)
    legend(picture, LEFT, 20, [(LINES[name], f"{name} ring") for name in RINGS], step=130)
    for k, (name, factor, title, highest, ticks, lowest) in enumerate(quantities):
        panel = cycle_panel(picture, 60 + 205 * k, 150, lowest, highest)
        panel.title(title)
        panel.y_axis("", ticks, zero=lowest < 0)
        panel.crank(last=k == len(quantities) - 1)
        for life in RINGS:
            angle, values = curves(ring(life), name)
            panel.curve(angle, [factor * value for value in values], LINES[life])
    return picture


def film_and_coefficient():
    return three_rings(
        (
            ("lambda_ratio", 1, "lambda ratio h_{m}/σ [-]", 10, range(0, 11, 2), 0),
            ("friction_coefficient", 1, "friction coefficient [-]", 0.3, [0, 0.1, 0.2, 0.3], 0),
            (
                "oil_flow_middle",
                1e6,
                "oil flow through the middle of the face [mg/s]",
                4000,
                range(-4000, 4001, 2000),
                -4000,
            ),
        )
    )


def cycle_values():
    """How the numbers of a cycle follow from its curves."""
    picture = Picture("Friction power with its mean, and the regimes of lubrication, of the new ring", 470)
    mark_synthetic(picture)
    result = ring("new")
    angle, power, load_share = curves(result, "power_loss", "asperity_load_share")
    top = cycle_panel(picture, 44, 170, 0, 2000)
    top.title("friction power P_{l} [W]")
    top.y_axis("", range(0, 2001, 500))
    top.crank(last=False)
    energies = ("intake", "compression", "power", "exhaust")
    for begin, colour, stroke in zip((-360, -180, 0, 180), (GREEN, ORANGE, RED, BLUE), energies):
        part = [i for i, a in enumerate(angle) if begin <= a <= begin + 180]
        top.band([angle[i] for i in part], [0] * len(part), [power[i] for i in part], colour, 0.35)
        energy = result.values[f"{stroke}_stroke_energy"]
        x, _ = top.at(begin + 90, 0)
        picture.text(x, top.top + 20, f"{stroke}: {energy:.2f} J", anchor="middle", colour=BLACK, size=12)
    top.curve(angle, power, Style(BLACK))
    mean = result.values["mean_power_loss"]
    top.level(mean, Style(GREY, "9 3 2 3", 1.3), f"mean {mean:.0f} W")
    low = cycle_panel(picture, 262, 150, 0, 100)
    names = {"boundary_regime": "boundary", "mixed_regime": "mixed", "full_film": "full film"}
    shares = [f"{words} {100 * result.values[f'{name}_cycle_share']:.0f} %" for name, words in names.items()]
    low.title(f"load share of asperities a [%]: {', '.join(shares)} of the time")
    low.y_axis("", range(0, 101, 25))
    percent = [100 * value for value in load_share]
    low.band(angle, [0] * len(angle), [value if value > 90 else 0 for value in percent], RED, 0.5)
    low.band(angle, [0] * len(angle), [value if 1 <= value <= 90 else 0 for value in percent], ORANGE, 0.35)
    low.crank()
    low.curve(angle, percent, Style(BLUE))
    low.level(90, Style(RED, "7 3", 1.3))
    return picture


def two_speeds():
    """The two cases of the first page."""
    slow = starting_case()
    fast = slow.copy()
    fast["operating.speed"] = "3000 rpm"
    styles = ((slow.run(), Style(BLUE), "1500 rpm"), (fast.run(), Style(ORANGE, "7 3"), "3000 rpm"))
    picture = Picture("Film and friction of the starting case at two speeds", 480)
    legend(picture, LEFT, 20, [(style, words) for _, style, words in styles], step=130)
    picture.text(WIDTH - RIGHT, 20, "COMPUTED cylinder pressure (Wiebe)", anchor="end", size=12, colour="#a00")
    shown = (
        ("min_film_thickness", 1e6, "minimum film thickness h_{m} [µm]", 2, [0, 0.5, 1, 1.5, 2]),
        ("total_friction", 1, "total friction [N]", 150, range(0, 151, 50)),
    )
    for k, (name, factor, title, highest, ticks) in enumerate(shown):
        panel = cycle_panel(picture, 60 + 205 * k, 150, 0, highest)
        panel.title(title)
        panel.y_axis("", ticks)
        panel.crank(last=k == 1)
        for result, style, _ in styles:
            angle, values = curves(result, name)
            panel.curve(angle, [factor * value for value in values], style)
    return picture


def stribeck():
    """Friction coefficient over the Stribeck number within 90 degrees of firing TDC."""
    picture = Picture("Friction coefficient over the Stribeck number of three rings", 400)
    mark_synthetic(picture)
    legend(picture, LEFT, 20, [(LINES[name], f"{name} ring") for name in RINGS], step=130)
    panel = Panel(picture, LEFT, 50, ACROSS, 290, (3e-4, 0.3), (0.005, 0.5), "xy")
    panel.y_axis("friction coefficient µ [-]", [0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.5])
    panel.x_axis("Stribeck number η|U|/(pσ) [-]", [1e-3, 3e-3, 1e-2, 3e-2, 1e-1, 0.3])
    panel.frame()
    for life in RINGS:
        result = ring(life)
        angle, number, friction = from_firing(result.crank_angle, result.stribeck_number, result.friction_coefficient)
        near = [i for i, a in enumerate(angle) if -90 <= a <= 90 and number[i] >= 3e-4]
        before, after = [i for i in near if angle[i] < 0], [i for i in near if angle[i] > 0]
        for part in (before, after):
            panel.curve([number[i] for i in part], [friction[i] for i in part], LINES[life])
    return picture


SPEEDS = (("1500 rpm", Style(BLUE)), ("5500 rpm", Style(ORANGE, "7 3")))


def heat():
    """What the friction of the new ring heats: the film by shear, the liner by asperities."""
    picture = Picture("Temperature rise of the film by viscous heating, and flash temperature of the liner", 480)
    mark_synthetic(picture)
    legend(picture, LEFT, 20, [(style, speed) for speed, style in SPEEDS], step=130)
    results = [
        (case("styles2014/new.toml", film__cavitation="mass-conserving", operating__speed=speed).run(), style)
        for speed, style in SPEEDS
    ]
    shown = (
        ("viscous_heating_rise", "rise of the film above its walls ΔT [K]", 3, range(0, 4)),
        ("flash_temperature", "flash temperature of the liner ΔT_{f} [K]", 8, range(0, 9, 2)),
    )
    for k, (name, title, highest, ticks) in enumerate(shown):
        panel = cycle_panel(picture, 60 + 205 * k, 150, 0, highest)
        panel.title(title)
        panel.y_axis("", ticks)
        panel.crank(last=k == 1)
        for result, style in results:
            panel.curve(*curves(result, name), style)
    return picture


def gas_holding():
    """Which pressure difference the film of the new ring holds, and where the gas breaks through."""
    picture = Picture("Gas-holding margin of the new ring in the power stroke", 330)
    mark_synthetic(picture)
    gas = {"film__chamber_edge": "gas", "film__crankcase_edge": "gas", "film__cavitation": "mass-conserving"}
    panel = Panel(picture, LEFT, 44, ACROSS, 224, (0, 90), (0.1, 10), "y")
    panel.y_axis("gas-holding margin m_{g} [-]", [0.1, 0.2, 0.5, 1, 2, 5, 10])
    panel.x_axis("crank angle [deg CA], 0 at firing TDC", range(0, 91, 15))
    entries = [(style, speed) for speed, style in SPEEDS]
    legend(picture, LEFT, 20, [*entries, (Style(RED, width=6), "gas breaks through")], step=130)
    for speed, style in SPEEDS:
        result = case("styles2014/new.toml", operating__speed=speed, **gas).run()
        early = [k for k, angle in enumerate(result.crank_angle) if 2 <= angle <= 90]
        broken = [k for k in early if result.gas_breakthrough[k] > 0]
        for part, look in ((broken, Style(RED, width=6)), (early, style)):
            panel.curve([result.crank_angle[k] for k in part], [result.gas_holding_margin[k] for k in part], look)
    panel.level(1, Style(BLACK, "2 3", 1.2))
    panel.frame()
    return picture


def grid_error():
    """How a value converges in the cells, with the error estimate."""
    picture = Picture("Convergence of friction and film in cells, and the estimated error", 330)
    base = dict(film__cavitation="mass-conserving")
    cells = (25, 50, 100, 200)
    ladder = {n: case("styles2014/new.toml", solver__cells=n, **base).run(error_estimate=True) for n in cells}
    finest = case("styles2014/new.toml", solver__cells=1600, **base).run()
    shown = (
        ("fmep", "cycle_fmep", "FMEP"),
        ("mean_cavitated_fraction", "cycle_mean_cavitated_fraction", "mean cavitated share of the face"),
    )
    for k, (value, name, title) in enumerate(shown):
        panel = Panel(picture, LEFT + 360 * k, 52, 286, 210, (20, 250), (1e-4, 100), "xy")
        panel.title(title)
        panel.y_axis("deviation [%]" if k == 0 else "", [1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 100])
        panel.x_axis("cells across the face", cells)
        panel.frame()
        exact = finest.values[value]
        error = [100 * abs(ladder[n].values[value] / exact - 1) for n in cells]
        panel.curve(cells, error, Style(BLUE))
        panel.points(cells, error, BLUE)
        band = [100 * float(ladder[n][f"{name}_error"]) / ladder[n].values[value] for n in cells]
        panel.curve(cells, band, Style(ORANGE, "7 3"))
        panel.points(cells, band, ORANGE, hollow=True)
    entries = ((Style(BLUE), "against 1600 cells"), (Style(ORANGE, "7 3"), "error estimate, of cells and crank steps"))
    legend(picture, LEFT, 20, entries, step=190)
    return picture


def step_control():
    """The error of film thickness over the cycle with fixed and with adaptive steps."""

    def film(**steps):
        steps = {f"solver__{key}": value for key, value in steps.items()}
        changes = {"film__cavitation": "mass-conserving", "output__crank_angles": "1 degree", **steps}
        return case("styles2014/embedded.toml", **changes).run()

    fixed = {"crank_step_control": "fixed", "step_error": None}
    finest = film(crank_step="0.05 degree", **fixed)
    ladder = (
        (film(time_scheme="backward-euler", **fixed), RED, "backward Euler"),
        (film(**fixed), ORANGE, "BDF2"),
        (film(), BLUE, "BDF2, adaptive (default)"),
    )
    picture = Picture("Deviation of the minimum film thickness with fixed and adaptive crank steps", 330)
    mark_synthetic(picture)
    legend(picture, LEFT, 20, [(Style(colour), words) for _, colour, words in ladder], [150, 90, 0])
    panel = cycle_panel(picture, 44, 224, 0, 12)
    panel.y_axis("deviation of h_{m} [%]", range(0, 13, 3))
    panel.crank()
    for result, colour, _ in ladder:
        error = 100 * numpy.abs(result.min_film_thickness / finest.min_film_thickness - 1)
        panel.curve(*from_firing(result.crank_angle, error), Style(colour, width=1.4))
    return picture


def assumptions():
    """What the choices of the ledger change in friction."""
    ledger = case("styles2014/new.toml").run(ledger=True)
    bars = []
    for entry in ledger.ledger:
        for variant in entry["variants"]:
            value = variant["values"].get("fmep") if variant["values"] else None
            if value is not None and numpy.isfinite(value):
                bars.append((100 * (value / ledger.fmep - 1), variant["setting"].replace('"', "")))
    picture = Picture("Change of FMEP of the new ring with each other choice of the ledger", 74 + 21 * len(bars))
    mark_synthetic(picture)
    panel = Panel(picture, 376, 34, 340, 21 * len(bars) - 8, (-60, 60), (0, 1))
    panel.x_axis("change of FMEP [%]", range(-60, 61, 20))
    for i, (change, words) in enumerate(bars):
        y = 40 + 21 * i
        picture.text(368, y + 6, words, anchor="end", size=11)
        x0, x1 = panel.at(0, 0)[0], panel.at(max(-60, min(60, change)), 0)[0]
        picture.rect(min(x0, x1), y - 4, abs(x1 - x0), 12, fill=BLUE if change < 0 else ORANGE, stroke="none")
        picture.text(
            x1 + (5 if change >= 0 else -5),
            y + 6,
            f"{change:+.1f}".replace("-", "−") if abs(change) >= 0.05 else "0.0",
            size=11,
            anchor="start" if change >= 0 else "end",
        )
    panel.upright(0, Style("#555", width=1))
    return picture


PICTURES = {
    "piston-motion": piston_motion,
    "gas-pressure": gas_pressure,
    "gas-between-rings": gas_between_rings,
    "pack-friction": pack_friction,
    "friction-shares": friction_shares,
    "film-and-coefficient": film_and_coefficient,
    "cycle-values": cycle_values,
    "two-speeds": two_speeds,
    "stribeck": stribeck,
    "heat": heat,
    "gas-holding": gas_holding,
    "grid-error": grid_error,
    "step-control": step_control,
    "assumptions": assumptions,
}
