"""Charts of the models: face, oil, contact."""

import math
import pathlib
import tempfile

import numpy
import ringfilm

from shipped import RINGS, ROOT, case, oil, ring, starting_case
from chart import LEFT, RIGHT, Panel, Style, legend
from cycle_charts import LINES
from svg import BLACK, BLUE, GAS, GREEN, GREY, LINER, METAL, ORANGE, PURPLE, RED, WIDTH, Picture

ACROSS = WIDTH - LEFT - RIGHT
HALF = 296


def faces():
    """Face profiles of the shipped rings and of the starting case."""
    picture = Picture("Face profiles: three polynomials and a parabola", 380)
    entries = [(LINES[name], f"{name} ring") for name in RINGS] + [
        (Style(GREEN, "9 3 2 3"), "parabola of the starting case")
    ]
    legend(picture, LEFT, 20, entries, [130, 130, 160, 0])
    start = starting_case()
    start["output.fields"] = [0]
    whole = Panel(picture, LEFT, 58, HALF, 254, (0, 1.2), (0, 40))
    whole.title("whole face")
    low = Panel(picture, LEFT + HALF + 76, 58, HALF, 254, (0.3, 0.9), (0, 2))
    low.title("lowest 2 µm, enlarged")
    whole.y_axis("face profile h_{s} [µm]", range(0, 41, 10))
    low.y_axis("", [0, 0.5, 1, 1.5, 2])
    for panel in (whole, low):
        ticks = [0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9] if panel is low else [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2]
        panel.x_axis("x from the chamber edge [mm]", ticks)
        for name in RINGS:
            result = case(f"styles2014/{name}.toml", output__fields=[0]).run()
            height = result["face_height"] - result["face_height"].min()
            panel.curve(1e3 * result["x"], 1e6 * height, LINES[name], cut=panel is low)
        result = start.run()
        height = result["face_height"] - result["face_height"].min()
        panel.curve(1e3 * result["x"], 1e6 * height, Style(GREEN, "9 3 2 3"), cut=panel is low)
        panel.frame()
    return picture


def oil_viscosity():
    """Viscosity over temperature of the shipped oils, and over pressure after the laws."""
    picture = Picture("Viscosity of the shipped oils over temperature, and over pressure by three laws", 400)
    hot = Panel(picture, LEFT, 50, HALF, 254, (20, 160), (2, 500), "y")
    hot.title("over temperature, at ambient pressure")
    hot.y_axis("dynamic viscosity η [mPa s]", [2, 5, 10, 20, 50, 100, 200, 500])
    hot.x_axis("temperature [°C]", range(20, 161, 20))
    base = case("styles2014/new.toml")
    grades = (("sae-0w-20", Style(BLUE)), ("sae-5w-30", Style(ORANGE, "7 3")), ("sae-10w-40", Style(GREEN, "9 3 2 3")))
    grades += (("sae-15w-40", Style(PURPLE, "4 2")), ("sae-30", Style(RED, "2 3")))
    temperatures = range(20, 161, 5)
    for grade, style in grades:
        oils = base.copy()
        oils["lubricant.file"] = str(oil(grade))
        values = []
        for temperature in temperatures:
            oils["operating.oil_temperature"] = f"{temperature} degC"
            values.append(1e3 * ringfilm.laws.oil(oils).viscosity(101325.0))
        hot.curve(temperatures, values, style)
    hot.frame()
    for y, row in ((364, grades[:3]), (384, grades[3:])):
        legend(picture, LEFT, y, [(style, grade.upper().replace("-", " ", 1)) for grade, style in row], 130)
    deep = Panel(picture, LEFT + HALF + 76, 50, HALF, 254, (0, 400), (1, 1000), "y")
    deep.title("over pressure, styles2014, 120 °C")
    deep.y_axis("", [1, 10, 100, 1000])
    deep.x_axis("pressure [MPa]", range(0, 401, 100))
    pressures = numpy.linspace(101325.0, 4e8, 81)
    laws = (("roelands", Style(BLUE)), ("barus", Style(RED, "7 3")), ("none", Style(BLACK, "2 3")))
    for law, style in laws:
        values = ringfilm.laws.oil(case("styles2014/new.toml", lubricant__viscosity_pressure=law)).viscosity(pressures)
        deep.curve(pressures * 1e-6, 1e3 * values, style, cut=True)
    deep.frame()
    legend(picture, LEFT + HALF + 76, 384, [(style, law.title()) for law, style in laws], 108)
    return picture


def surfaces_in_contact(life, integrals="exact"):
    """The contact law of a ring of styles2014."""
    stated = case(f"styles2014/{life}.toml")
    e1, e2 = stated["ring.youngs_modulus"], stated["liner.youngs_modulus"]
    modulus = 2 / ((1 - stated["ring.poissons_ratio"] ** 2) / e1 + (1 - stated["liner.poissons_ratio"] ** 2) / e2)
    numbers = [stated[f"contact.asperity_{name}"] for name in ("density", "radius")]
    return ringfilm.laws.GreenwoodTripp(*numbers, stated["contact.roughness"], modulus, integrals=integrals)


def contact_law():
    """Asperity pressure over separation."""
    picture = Picture("Asperity pressure over the separation of the mean planes", 350)
    legend(picture, LEFT, 20, [(LINES[name], f"{name} ring") for name in RINGS], step=130)
    panel = Panel(picture, LEFT, 40, ACROSS, 250, (0, 2), (1e-4, 1000), "y")
    panel.y_axis("asperity pressure p_{a} [MPa]", [1e-4, 1e-3, 1e-2, 1e-1, 1, 10, 100, 1000])
    panel.x_axis("separation of the mean planes h [µm]", [0, 0.5, 1, 1.5, 2])
    heights = numpy.linspace(0, 2e-6, 201)
    for life in RINGS:
        pressure = 1e-6 * surfaces_in_contact(life).pressure(heights)
        panel.curve(1e6 * heights, pressure, LINES[life], cut=True)
        sigma = case(f"styles2014/{life}.toml")["contact.roughness"]
        for ratio in (1, 2, 3):
            at = float(surfaces_in_contact(life).pressure(ratio * sigma))
            panel.points([1e6 * ratio * sigma], [1e-6 * at], LINES[life].colour, 3.5)
            x, y = panel.at(1e6 * ratio * sigma, 1e-6 * at)
            shift = (-20, 14) if life == "new" else (6, -4)
            picture.text(x + shift[0], y + shift[1], f"{ratio}σ", size=11, colour=LINES[life].colour)
    gas = 1e-6 * float(ring("new").peak_gas_pressure)
    panel.level(gas, Style("#555", "3 3", 1.1), f"peak of the cylinder pressure, {gas:.1f} MPa")
    panel.frame()
    return picture


def contact_fits():
    """The integral and its published fits."""
    picture = Picture("The contact integral and two fits of it", 330)
    panel = Panel(picture, LEFT, 40, ACROSS, 230, (0, 7), (1e-5, 10), "y")
    panel.y_axis("F_{5/2}(λ)", [1e-5, 1e-4, 1e-3, 1e-2, 1e-1, 1, 10])
    panel.x_axis("lambda ratio λ [-]", range(0, 8))
    ratios = numpy.linspace(0, 7, 281)
    exact = ringfilm.laws.gaussian_integral(2.5, ratios)
    lines = {
        "exact": Style(BLACK),
        "polynomial-4-digit": Style(BLUE, "7 3"),
        "polynomial-as-printed": Style(RED, "2 3"),
    }
    law = surfaces_in_contact("new")
    sigma = case("styles2014/new.toml")["contact.roughness"]
    scale = float(law.pressure(sigma)) / float(ringfilm.laws.gaussian_integral(2.5, 1.0))
    for integrals, style in lines.items():
        values = (
            exact if integrals == "exact" else surfaces_in_contact("new", integrals).pressure(ratios * sigma) / scale
        )
        panel.curve(ratios, values, style, cut=True)
    panel.frame()
    legend(picture, LEFT, 20, [(style, words) for words, style in lines.items()], [120, 190, 0])
    return picture


def face_fit():
    """Trace, polynomial and spline of the synthetic run-in face."""
    x, height = ringfilm.face.read_trace(str(ROOT / "cases" / "measured" / "face_run_in.csv"))
    fit = ringfilm.face.fit_face(x, height, width=1.2e-3, start=1e-4, levelling="stated", tilt=2e-3, zero="as-measured")
    place, gap, spline = 1e3 * fit.x_m, 1e6 * fit.gap_m, 1e6 * fit.spline_m
    polynomial = numpy.polyval(fit.coefficients, place)
    picture = Picture("A trace over a ring face with its polynomial and its spline", 470)
    curve, smooth = Style(BLUE), Style(ORANGE, "7 3")
    legend(
        picture,
        LEFT,
        20,
        ((Style("#bbb", width=4), "trace (SYNTHETIC)"), (curve, "polynomial of degree 6"), (smooth, "spline")),
        [190, 210, 0],
    )
    top = Panel(picture, LEFT, 50, ACROSS, 170, (0, 1.2), (-1, 16))
    top.title("distance to a straight liner [µm]")
    top.y_axis("", range(0, 17, 4))
    top.x_axis("", [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2])
    few = slice(None, None, 8)
    top.curve(place[few], gap[few], Style("#bbb", width=5), cut=True)
    top.curve(place[few], polynomial[few], curve, cut=True)
    top.curve(place[few], spline[few], smooth, cut=True)
    top.upright(1.14, Style(RED, "3 3", 1.1), "falls towards the edge", anchor="end")
    low = Panel(picture, LEFT, 276, ACROSS, 130, (0, 1.2), (-0.3, 0.3))
    low.title("trace less fit [µm]")
    low.y_axis("", [-0.3, -0.15, 0, 0.15, 0.3], zero=True)
    low.x_axis("x along the face [mm]", [0, 0.2, 0.4, 0.6, 0.8, 1, 1.2])
    few = slice(None, None, 3)
    low.curve(place[few], (gap - polynomial)[few], Style(BLUE, width=1), cut=True)
    low.curve(place[few], (gap - spline)[few], Style(ORANGE, width=1), cut=True)
    return picture


def closure_around(picture, middle, closure, micrometre, clearance_micrometre):
    """Bore, ring and clearance around one bore; pixels that stand for a micrometre of each."""
    x_0, y_0, radius = middle, 220, 112
    angle = numpy.radians(closure["angle"])
    bore = radius + 1e6 * micrometre * closure["bore"]
    ring = bore - 1e6 * clearance_micrometre * closure["clearance"]

    def points(r, phi):
        return [(x_0 + at * numpy.sin(a), y_0 - at * numpy.cos(a)) for at, a in zip(r, phi)]

    circle = numpy.linspace(0, 2 * numpy.pi, 181)
    picture.polyline(points([radius] * 181, circle), close=True, stroke=GREY, width=0.8, dashes="2 3")
    picture.polyline(points(bore, angle) + points(ring, angle)[::-1], close=True, stroke="none", fill=GAS)
    for first, last in closure["contact_arcs"]:
        inside = (closure["angle"] >= first) & (closure["angle"] <= last)
        picture.polyline(points(bore[inside], angle[inside]), stroke=LINER, width=9)
    picture.polyline(points(bore, angle), stroke=BLACK, width=1.2)
    picture.polyline(points(ring, angle), stroke=BLUE, width=1.6)
    for at, force in closure["point_forces"]:
        a = numpy.radians(at)
        r = numpy.interp(at, closure["angle"], bore)
        begin, end = r + 6 + 4 * force, r + 3
        picture.line(*points([begin], [a])[0], *points([end], [a])[0], stroke=RED, width=1.6)
    picture.text(x_0, y_0 - 28, "largest clearance", anchor="middle")
    picture.text(x_0, y_0 - 8, f"{1e6 * closure['max_clearance']:.2f} µm", anchor="middle")
    picture.text(x_0, y_0 + 16, f"open area {1e6 * closure['open_area']:.3f} mm^{{2}}", anchor="middle")
    for row, (length, words) in enumerate(
        ((10 * micrometre, "10 µm of the bore"), (clearance_micrometre, "1 µm of clearance"))
    ):
        y = 400 + 22 * row
        picture.line(x_0 - 90, y - 4, x_0 - 90 + length, y - 4, stroke=BLACK if row == 0 else BLUE, width=3)
        picture.text(x_0 - 90 + max(length, 40) + 8, y, words)


def closure():
    """The ring in the two bores of cases/distorted-bore."""
    picture = Picture("Bore, ring and clearance of two distorted bores, magnified", 440)
    entries = (
        (Style(BLACK), "bore"),
        (Style(BLUE), "ring"),
        (Style(GREY, "2 3"), "round"),
        (Style(RED), "point force"),
    )
    legend(picture, LEFT + 60, 20, entries, [100, 100, 100, 0])
    for name, middle, micrometre, clearance in (("followed", 200, 1.4, 14), ("not-followed", 570, 3, 7)):
        closed = ringfilm.conform(str(ROOT / f"cases/distorted-bore/{name}.toml"))
        picture.text(middle, 52, closed["title"], anchor="middle", bold=True)
        closure_around(picture, middle, closed, micrometre, clearance)
    return picture


def free_shape():
    """Target pressure of the free ring of cases/distorted-bore, by points with noise and the length of smoothing."""
    of_case = case("distorted-bore/followed.toml", ring__pressure_orders=[{"order": 2, "amplitude": 0.25}])
    ring = ringfilm.conform(of_case)
    mean = ring["tangential_force"]
    noise = numpy.random.RandomState(5).normal(0, 0.1e-6, len(ring["free_radius"]))
    picture = Picture("Target pressure around a ring by its measured free shape, smoothed over 80, 40 and 15 mm", 380)

    panel = Panel(picture, LEFT, 62, ACROSS, 262, (0, 360), (0, 2))
    panel.title("target pressure over its mean [1]; noise of the points: SYNTHETIC")
    panel.y_axis("", [0, 0.5, 1, 1.5, 2])
    panel.x_axis("angle from the middle of the gap [degree]", range(0, 361, 60))
    entries = [(Style("#bbb", width=6), "made for")]
    panel.curve(ring["angle"], ring["target_force"] / mean, Style("#bbb", width=6), cut=True)
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "free.csv"
        rows = zip(ring["free_angle"], 1e3 * (ring["free_radius"] + noise))
        path.write_text("angle [degree],radius [mm]\n" + "".join(f"{a:.9f},{r:.9f}\n" for a, r in rows))
        for smoothing, style in (
            ("80 mm", Style(BLUE)),
            ("40 mm", Style(GREEN, "9 3")),
            ("15 mm", Style(RED, "3 2", 1.2)),
        ):
            of_case.update(
                {
                    "ring.pressure_orders": None,
                    "ring.elastic_pressure": None,
                    "ring.free_shape": str(path),
                    "ring.free_shape_smoothing": smoothing,
                }
            )
            found = ringfilm.conform(of_case)
            panel.curve(found["angle"], found["target_force"] / mean, style, cut=True)
            entries.append((style, f"{smoothing}: ± {100 * found['pressure_deviation']:.2g} %"))
    legend(picture, LEFT, 20, entries, [120, 190, 180, 0])
    panel.frame()
    return picture


def ring_sections():
    """Five sections in the bore of cases/distorted-bore with centroid, principal axes and assembly twist."""
    picture = Picture("Sections of rings with centroid, principal axes and assembly twist", 250)
    h, t = 1.5, 3.5
    taper, flank = h * math.tan(math.radians(3)), t * math.tan(math.radians(7.5))
    sections = {
        "rectangular": [(0, 0), (h, 0), (h, t), (0, t)],
        "inner bevel": [(0, 0), (h, 0), (h, t), (0.7, t), (0, t - 0.7)],
        "Napier": [(0, 0), (h - 0.4, 0), (h - 0.4, 0.5), (h, 0.5), (h, t), (0, t)],
        "taper, 3 degrees": [(0, taper), (h, 0), (h, t), (0, t)],
        "keystone": [(0, 0), (h, 0), (h - flank, t), (flank, t)],
    }
    scale = 34
    for column, (name, corners) in enumerate(sections.items()):
        of_case = case("distorted-bore/followed.toml", ring__tangential_force="10.7 N", ring__elastic_pressure=None)
        of_case.update(
            {
                "ring.radial_thickness": None,
                "ring.pressure_orders": None,
                "ring.face_width": f"{h if name != 'Napier' else h - 0.4} mm",
                "ring.section": [[f"{a} mm", f"{rho} mm"] for a, rho in corners],
            }
        )
        section = ringfilm.conform(of_case)["section"]
        left, top = 18 + 148 * column, 70
        picture.line(left - 4, top - 22, left - 4, top + 92, stroke=GREY, width=2.4)
        picture.polyline(
            [(left + scale * rho, top + scale * a) for a, rho in corners], close=True, fill=METAL, width=1.4
        )
        a, rho = (1e3 * x for x in section["centroid"])
        x, y = left + scale * rho, top + scale * a
        along = section["principal_angle"]
        for turn, reach in ((along, 68), (along + math.pi / 2, 34)):
            run, fall = reach * math.cos(turn), reach * math.sin(turn)
            picture.line(x - run, y - fall, x + run, y + fall, stroke=BLUE, width=1, dashes="6 4")
        picture.circle(x, y, 3.2, fill=RED, stroke="none")
        minutes = 60 * math.degrees(section["assembly_twist"])
        picture.text(left + 60, 34, name, anchor="middle", bold=True)
        picture.text(left + 60, 196, f"twist {minutes:+.1f}\u2032".replace("-", "\u2212"), anchor="middle")
        picture.text(left + 60, 218, f"J = {1e12 * section['torsion_constant']:.3f} mm^{{4}}", anchor="middle")
    return picture


PICTURES = {
    "closure": closure,
    "ring-sections": ring_sections,
    "free-shape": free_shape,
    "faces": faces,
    "oil-viscosity": oil_viscosity,
    "contact-law": contact_law,
    "contact-fits": contact_fits,
    "face-fit": face_fit,
}
