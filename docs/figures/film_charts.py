"""Charts of films: states of the film, the ring, the end of the unrolled ring, pads, convergence."""

import math

import ringfilm
from shipped import case
from chart import LEFT, RIGHT, Panel, Style, from_firing, legend, mark_synthetic, shown
from svg import BLACK, BLUE, GREEN, GREY, METAL, OIL, ORANGE, RED, WIDTH, Picture, number

ACROSS = WIDTH - LEFT - RIGHT
KEEPING, EXIT = Style(BLUE), Style(RED, "7 3")
MODELS = (("mass-conserving", KEEPING), ("reynolds-exit", EXIT))


def cavity(film):
    """Beginning and end of the one cavity of a pad [mm]."""
    inside = [1e3 * x for x, p in zip(film.x, film.pressure[-1]) if p <= 1e-6 * film.pressure[-1].max()]
    return inside[0], inside[-1]


def film_states():
    """The pad with one pocket: where the film is full, where it has ruptured, where it forms again."""
    films = {model: case("pad/pocket.toml", film__cavitation=model).run() for model, _ in MODELS}
    keeping = films["mass-conserving"]
    x, gap = 1e3 * keeping.x, 1e6 * keeping.film_thickness[-1]
    content = keeping.film_content[-1]
    end = float(x[-1])
    ticks = [end * i / 4 for i in range(5)]
    picture = Picture(
        "States of the film in a pad with one pocket, with mass conservation and with Reynolds' exit", 610
    )
    top = Panel(picture, LEFT, 44, ACROSS, 120, (0, end), (0, 40))
    top.title("film thickness [µm] and what fills it; the lower surface moves to the right")
    top.y_axis("", range(0, 41, 10))
    shape = [top.at(a, b) for a, b in zip(x, gap)]
    picture.polyline([(top.left, top.top)] + shape + [(top.left + top.width, top.top)], close=True, fill=METAL)
    for fill, share in ((("white"), None), ((OIL), content)):
        level = gap if share is None else gap * share
        outline = [top.at(a, b) for a, b in zip(x, level)]
        picture.polyline(outline + [top.at(end, 0), top.at(0, 0)], close=True, fill=fill, stroke="none")
    picture.polyline(shape, width=1.2)
    top.x_axis("", ticks)
    ends = {model: cavity(film) for model, film in films.items()}
    rupture, again = ends["mass-conserving"]
    spans = [(0, rupture, "full film"), (rupture, again, "cavity, θ < 1"), (again, end, "full film")]
    for begin, until, words in spans:
        px, py = top.at((begin + until) / 2, 5)
        picture.text(px, py, words, anchor="middle", size=12, bold=True)
    low = Panel(picture, LEFT, 230, ACROSS, 150, (0, end), (0, 6))
    low.title("film pressure, absolute [bar]")
    low.y_axis("", range(0, 7, 2))
    low.x_axis("", ticks)
    for model, style in MODELS:
        low.curve(1e3 * films[model].x, 1e-5 * films[model].pressure[-1], style)
    share = Panel(picture, LEFT, 432, ACROSS, 100, (0, end), (0, 1.2))
    share.title("film content θ (share of oil), mass-conserving")
    share.y_axis("", [0, 0.5, 1])
    share.x_axis("x in the direction of motion [mm]", ticks)
    share.curve(x, content, KEEPING)
    for place, words in ((rupture, "rupture"), (again, "re-formation, mass conserved")):
        for panel in (top, low, share):
            anchor = "end" if words == "rupture" else "start"
            panel.upright(
                place, Style(GREEN, "3 3", 1.3), words if panel is share else "", y=panel.top + 80, anchor=anchor
            )
    early = ends["reynolds-exit"][1]
    low.upright(early, Style(RED, "3 3", 1.1))
    picture.text(low.at(early, 0)[0] + 6, low.top + 16, "begins too early", size=12, colour=RED)
    legend(
        picture,
        LEFT + 120,
        602,
        [(style, model.replace("reynolds-exit", "Reynolds' exit")) for model, style in MODELS],
        190,
    )
    return picture


def ring_film():
    """Pressure under the face of the new ring at three crank angles, with both models of cavitation."""
    angles = (20, 120, -90)
    films = {
        model: case("styles2014/new.toml", film__cavitation=model, output__fields=list(angles)).run()
        for model, _ in MODELS
    }
    picture = Picture("Film and asperity pressure under the face of the new ring at three crank angles", 600)
    mark_synthetic(picture)
    names = {"mass-conserving": "film, mass-conserving", "reynolds-exit": "film, Reynolds' exit"}
    entries = [(style, names[model]) for model, style in MODELS] + [(Style(ORANGE, "2 3"), "asperities")]
    legend(picture, LEFT, 20, entries, [200, 180, 0])
    limits = {20: 450, 120: 36, -90: 15}
    for k, angle in enumerate(angles):
        panel = Panel(picture, LEFT, 62 + 180 * k, ACROSS, 122, (0, 1.2), (0, limits[angle]))
        gas = {20: "power stroke, peak of the gas pressure", 120: "power stroke, late", -90: "compression"}[angle]
        panel.title(f"pressure [bar] at {angle} degree: {gas}".replace("-", "−"))
        panel.y_axis("", [limits[angle] * i / 3 for i in range(4)])
        panel.x_axis("x from the chamber edge [mm]" if k == 2 else "", [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2])
        for model, style in MODELS:
            result = films[model]
            panel.curve(1e3 * result["x"], 1e-5 * result["film_pressure"][k], style)
        panel.curve(1e3 * result["x"], 1e-5 * result["asperity_pressure"][k], Style(ORANGE, "2 3"))
    return picture


def unrolled_case():
    """The new ring with an end gap, on the coarse grid of the tutorial."""
    return case(
        "styles2014/new.toml",
        solver__cells=60,
        solver__crank_step="4 degree",
        solver__step_error=None,
        solver__crank_step_control="fixed",
        output__crank_angles="4 degree",
        film__dimension="unrolled",
        ring__end_gap="0.3 mm",
        solver__cells_y=80,
        output__fields=[20],
    )


# Colours of pressure from low to high, even in lightness (after viridis).
SCALE = ("#440154", "#472d7b", "#3b528b", "#2c728e", "#21918c", "#28ae80", "#5ec962", "#addc30", "#fde725")


def field(picture, panel, x, y, values, highest):
    """Values on nodes as rectangles in the colours of SCALE; equal neighbours are joined."""
    sides = [[(a + b) / 2 for a, b in zip(row, row[1:])] for row in (x, y)]
    sides = [[row[0], *middle, row[-1]] for row, middle in zip((x, y), sides)]
    paths = {}
    for i in range(len(x)):
        begin = 0
        colours = [min(len(SCALE) - 1, int(len(SCALE) * max(0.0, v) / highest)) for v in values[i]]
        for j in range(1, len(y) + 1):
            if j == len(y) or colours[j] != colours[begin]:
                left, low = panel.at(sides[1][begin], sides[0][i])
                right, high = panel.at(sides[1][j], sides[0][i + 1])
                d = f"M{number(left)} {number(low)}H{number(right)}V{number(high)}H{number(left)}Z"
                paths.setdefault(colours[begin], []).append(d)
                begin = j
    for colour in sorted(paths):
        picture.path("".join(paths[colour]), fill=SCALE[colour], stroke=SCALE[colour], width=0.8)


def unrolled_film():
    """Film pressure next to an end of the ring, and the leakage into the end gap over the cycle."""
    whole = unrolled_case().run()
    picture = Picture("Film pressure next to the end of the ring, and leakage into the end gap", 470)
    mark_synthetic(picture)
    data = whole.to_xarray().isel(field_crank_angle=0).sel(y=slice(0, 3e-3))
    x, y = 1e3 * data.x.values, 1e3 * data.y.values
    pressure = 1e-5 * data.unrolled_film_pressure.transpose("x", "y").values
    panel = Panel(picture, LEFT, 44, ACROSS - 90, 150, (0, float(y[-1])), (1.2, 0))
    panel.title("film pressure at 20 degree [bar]; chamber edge on top")
    field(picture, panel, x, y, pressure, 63)
    panel.frame()
    for tick in (0, 0.4, 0.8, 1.2):
        py = panel.at(0, tick)[1]
        picture.text(LEFT - 7, py + 4, shown(tick), anchor="end", size=12)
    picture.text(LEFT - 54, panel.top + 75, "x [mm]", anchor="middle", turn=-90)
    panel.x_axis("y, distance from the end of the ring [mm]", [0, 0.5, 1, 1.5, 2], grid=False)
    for i, colour in enumerate(SCALE):
        top = panel.top + panel.height * (1 - (i + 1) / len(SCALE))
        picture.rect(WIDTH - 96, top, 20, panel.height / len(SCALE), fill=colour, stroke="none")
    for value in (0, 21, 42, 63):
        picture.text(WIDTH - 70, panel.top + panel.height * (1 - value / 63) + 4, str(value), size=12)
    low = Panel(picture, LEFT, 282, ACROSS, 140, (-360, 360), (-1000, 500))
    low.title("oil that leaves the film into the end gap [mg/s]; negative: into the film")
    low.y_axis("", range(-1000, 501, 500), zero=True)
    low.crank()
    angle, leakage = from_firing(whole.crank_angle, whole.gap_leakage)
    low.curve(angle, [1e6 * value for value in leakage], Style(BLACK))
    return picture


def bent_ring():
    """Film thickness and load around a ring that bends, and where it is lifted off over the cycle."""
    angles = ("0 degree", "90 degree", "180 degree")
    bore = case("distorted-bore/not-followed.toml", solver__cells=60, output__fields=list(angles))
    whole, closed = bore.run(), ringfilm.conform(bore)
    picture = Picture("Film thickness and load around a ring that bends, and open area over the cycle", 640)
    mark_synthetic(picture)
    data = whole.to_xarray()
    around = 360 * (data.y.values + 0.5 * 0.35e-3) / (math.pi * 89e-3)
    styles = (Style(RED), Style(BLUE), Style(GREEN))
    without = Style("#999", "5 3")
    entries = [(style, angle) for style, angle in zip(styles, angles)] + [(without, "clearance without film")]
    legend(picture, LEFT, 20, entries, [120, 130, 140, 0])
    ticks = range(0, 361, 45)
    film = Panel(picture, LEFT, 60, ACROSS, 140, (0, 360), (0, 6))
    film.title("film thickness at the lowest place of each strip [µm]")
    film.y_axis("", range(0, 7, 2))
    film.x_axis("", ticks)
    film.curve(closed["angle"], 1e6 * closed["clearance"], without, cut=True)
    load = Panel(picture, LEFT, 252, ACROSS, 120, (0, 360), (0, 2))
    load.title("load carried by film and asperities beyond the gas, over its mean")
    load.y_axis("", [0, 0.5, 1, 1.5, 2])
    load.x_axis("angle from the middle of the end gap [degree]", ticks)
    for k, style in enumerate(styles):
        at = data.isel(field_crank_angle=k)
        film.curve(around, 1e6 * at.strip_min_film_thickness.values, style)
        carried = at.strip_hydrodynamic_load.values + at.strip_asperity_load.values
        instant = data.sel(crank_angle=90 * k, method="nearest")
        gas = 0.5 * float(instant.gas_pressure + instant.crankcase_pressure) * 1.2e-3
        applied = float(instant.applied_load) / (math.pi * 89e-3 - 0.35e-3)
        load.curve(around, (carried - gas) / (applied - gas), style, cut=True)
    low = Panel(picture, LEFT, 460, ACROSS, 110, (-360, 360), (0, 0.6))
    low.title("open area where the ring is lifted off [mm²]")
    low.y_axis("", [0, 0.2, 0.4, 0.6], zero=True)
    low.crank()
    angle, area = from_firing(whole.crank_angle, whole.open_area)
    low.curve(angle, [1e6 * value for value in area], Style(BLACK))
    return picture


def pads():
    """Film and pressure of the inclined slider and of Rayleigh's step."""
    picture = Picture("Film thickness and pressure of an inclined slider and of Rayleigh's step", 420)
    shown_pads = (("inclined_slider", "inclined slider"), ("rayleigh_step", "Rayleigh's step, best proportions"))
    for k, (name, title) in enumerate(shown_pads):
        result = case(f"pad/{name}.toml").run()
        left, x = LEFT + 362 * k, 1e3 * result.x
        gap = Panel(picture, left, 40, 290, 100, (0, 10), (0, 24))
        gap.title(title)
        gap.y_axis("film thickness [µm]" if k == 0 else "", range(0, 25, 8))
        gap.x_axis("", range(0, 11, 2))
        outline = [gap.at(a, b) for a, b in zip(x, 1e6 * result.film_thickness[-1])]
        picture.polyline(outline + [gap.at(10, 0), gap.at(0, 0)], close=True, fill=OIL, stroke="none")
        picture.polyline(outline, stroke=BLACK)
        low = Panel(picture, left, 196, 290, 160, (0, 10), (0, 50))
        low.y_axis("pressure [bar]" if k == 0 else "", range(0, 51, 10))
        low.x_axis("x in the direction of motion [mm]", range(0, 11, 2))
        low.curve(x, 1e-5 * result.pressure[-1], Style(BLUE))
        load = result.values["load"]
        picture.text(left + 8, 214, f"load {load / 1000:.2f} kN/m", size=12)
    return picture


def pocket_pad():
    """Pressure of the pad with one closed pocket."""
    result = case("pad/closed_pocket.toml", solver__cells=50, solver__cells_y=50).run()
    data = result.to_xarray().isel(time=-1)
    x, y = 1e3 * data.x.values, 1e3 * data.y.values
    pressure = 1e-5 * data.pressure.transpose("x", "y").values
    picture = Picture("Film pressure of a square pad with one pocket", 400)
    panel = Panel(picture, 150, 44, 290, 290, (0, 20), (0, 20))
    panel.title("film pressure [bar]; the surface moves to the right")
    field(picture, Turned(panel), x, y, pressure, 1.8)
    panel.frame()
    panel.x_axis("x [mm]", range(0, 21, 5), grid=False)
    for tick in range(0, 21, 5):
        picture.text(143, panel.at(0, tick)[1] + 4, str(tick), anchor="end", size=12)
    picture.text(106, 189, "y [mm]", anchor="middle", turn=-90)
    corners = [panel.at(a, b) for a, b in ((4, 5), (10, 5), (10, 15), (4, 15))]
    picture.polyline(corners, close=True, stroke="white", width=1.6, dashes="5 3")
    for i, colour in enumerate(SCALE):
        picture.rect(480, 334 - 290 * (i + 1) / len(SCALE), 20, 290 / len(SCALE), fill=colour, stroke="none")
    for value in (0, 0.6, 1.2, 1.8):
        picture.text(506, 334 - 290 * value / 1.8 + 4, f"{value:g}", size=12)
    picture.lines(560, 150, ["dashed: walls", "of the pocket,", "20 µm deep"], size=12)
    return picture


class Turned:
    """A panel of which field() takes x to the right."""

    def __init__(self, panel):
        self.panel = panel

    def at(self, y, x):
        return self.panel.at(x, y)


def convergence():
    """Order of convergence on cases with a closed form."""
    picture = Picture("Error against closed forms over the number of cells", 350)
    cells = (20, 40, 80, 160, 320)
    length, low, ratio = 10e-3, 10e-6, 1.0
    exact = 0.02 * 5 * length**2 / low**2 * 6 * (math.log(1 + ratio) / ratio**2 - 2 / (ratio * (2 + ratio)))
    slider = [abs(case("pad/inclined_slider.toml", solver__cells=n).run().values["load"] / exact - 1) for n in cells]
    panel = Panel(picture, LEFT, 44, ACROSS, 240, (15, 420), (1e-6, 1e-2), "xy")
    panel.y_axis("relative error [-]", [1e-6, 1e-5, 1e-4, 1e-3, 1e-2])
    panel.x_axis("cells", cells)
    panel.frame()
    panel.curve(cells, slider, KEEPING)
    panel.points(cells, slider, BLUE, 3.5)
    reference = [slider[0] * (cells[0] / n) ** 2 * 2.2 for n in cells]
    panel.curve(cells, reference, Style(BLACK, "2 3", 1.2))
    legend(
        picture,
        LEFT,
        24,
        ((KEEPING, "load of the inclined slider (rayleigh1918)"), (Style(BLACK, "2 3", 1.2), "second order")),
        [330, 0],
    )
    return picture


def flow_factors():
    """What the orientation of the roughness and shear thinning change in the new ring of styles2014."""

    def new_ring(**changes):
        return case("styles2014/new.toml", film__cavitation="mass-conserving", **changes).run()

    orientations = (1 / 9, 1 / 6, 1 / 3, 1, 3, 6, 9)
    factors = {"film__flow_factors": "patir-cheng", "film__stress_factors": "patir-cheng"}
    fmep = [1e-3 * new_ring(film__orientation=gamma, **factors).values["fmep"] for gamma in orientations]
    newtonian, thinned = new_ring(), new_ring(lubricant__shear_thinning="cross")
    picture = Picture("FMEP over the orientation of the roughness, and viscous friction with shear thinning", 540)
    mark_synthetic(picture)
    top = Panel(picture, LEFT, 58, ACROSS, 170, (0.1, 10), (16, 21), "x")
    top.title("FMEP [kPa] with factors of pressure flow and stress")
    top.y_axis("", range(16, 22))
    top.x_axis("orientation γ [-]", [0.1, 0.3, 1, 3, 10])
    top.level(1e-3 * newtonian.values["fmep"], Style(BLACK, "2 3", 1.2), "smooth walls", anchor="start")
    top.curve(orientations, fmep, KEEPING)
    top.points(orientations, fmep, BLUE, 3.5)
    top.frame()
    entries = ((newtonian, KEEPING, "Newtonian"), (thinned, EXIT, "Cross, HTHS 2.9 mPa s"))
    legend(picture, LEFT + 220, 312, [(style, words) for _, style, words in entries], 130)
    low = Panel(picture, LEFT, 324, ACROSS, 160, (-360, 360), (0, 8))
    low.title("viscous friction [N]")
    low.y_axis("", range(0, 9, 2))
    low.crank()
    for result, style, _ in entries:
        angle, friction = from_firing(result.crank_angle, result.viscous_friction)
        low.curve(angle, friction, style)
    return picture


def local_deformation():
    """Film, pressure and local deformation under the face of the new ring where the gas pressure is highest."""
    rigid, elastic = (
        case("styles2014/new.toml", ring__local_deformation=choice, output__fields=[20]).run()
        for choice in ("none", "half-space")
    )
    picture = Picture("Film thickness, pressure and local deformation over the face of the new ring at 20 degree", 600)
    mark_synthetic(picture)
    x = 1e3 * elastic["x"]
    entries = [(EXIT, "rigid face"), (KEEPING, "half-spaces")]
    legend(picture, LEFT, 20, entries, 130)
    rows = (
        ("film thickness [um]", 1e6, "film_thickness", (0, 2), (0, 0.5, 1, 1.5, 2)),
        ("pressure of film and asperities [bar]", 1e-5, "pressure", (0, 500), range(0, 501, 100)),
        ("local deformation δ [um]", 1e6, "local_deformation", (-0.05, 0.15), (-0.05, 0, 0.05, 0.1, 0.15)),
    )
    for k, (words, unit, name, ends, ticks) in enumerate(rows):
        panel = Panel(picture, LEFT, 62 + 180 * k, ACROSS, 122, (0, 1.2), ends)
        panel.title(words)
        panel.y_axis("", ticks)
        panel.x_axis("x from the chamber edge [mm]" if k == 2 else "", [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2])
        for result, style in ((rigid, EXIT), (elastic, KEEPING)):
            if name == "pressure":
                values = result["film_pressure"][0] + result["asperity_pressure"][0]
            elif name == "local_deformation" and result is rigid:
                continue
            else:
                values = result[name][0]
            panel.curve(x, unit * values, style, cut=True)
        panel.frame()
    return picture


def dynamic_bore():
    """What the gas pressure adds to a bore at the end gap, and the thinnest film with and without it."""
    moving, fixed = (case(f"distorted-bore/{name}.toml", solver__cells=60) for name in ("dynamic", "followed"))
    picture = Picture("Deviation of a bore that the gas pressure bulges and thinnest film over the crank angle", 420)
    mark_synthetic(picture)
    styles = (Style(BLUE), Style(GREY, "5 3"))
    legend(picture, LEFT, 20, list(zip(styles, ("with the dynamic part", "without"))), [210, 0])
    span = (-90, 120)
    ticks = range(-90, 121, 30)
    top = Panel(picture, LEFT, 60, ACROSS, 120, span, (21, 26))
    top.title("deviation of the bore's radius at the end of the ring [µm]")
    top.y_axis("", range(21, 27))
    top.x_axis("", ticks)
    low = Panel(picture, LEFT, 240, ACROSS, 120, span, (0, 0.8))
    low.title("thinnest film [µm]")
    low.y_axis("", [0, 0.2, 0.4, 0.6, 0.8], zero=True)
    low.x_axis("crank angle [degree], 0 at firing TDC", ticks)
    for one, style in zip((moving, fixed), styles):
        result = one.run()
        data = result.to_xarray()
        angle, bore = from_firing(data.field_crank_angle.values, data.strip_bore_deviation.values[:, 0])
        top.curve(angle, [1e6 * value for value in bore], style, cut=True)
        angle, film = from_firing(result.crank_angle, result.min_film_thickness)
        low.curve(angle, [1e6 * value for value in film], style, cut=True)
    for panel in (top, low):
        panel.frame()
    return picture


PICTURES = {
    "film-states": film_states,
    "ring-film": ring_film,
    "unrolled-film": unrolled_film,
    "bent-ring": bent_ring,
    "pads": pads,
    "pocket-pad": pocket_pad,
    "convergence": convergence,
    "flow-factors": flow_factors,
    "local-deformation": local_deformation,
    "dynamic-bore": dynamic_bore,
}
