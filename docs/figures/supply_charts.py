"""Pictures of the oil ahead of the ring: its account as a drawing, films and friction of one ring with each supply."""

import functools

from shipped import case
from chart import LEFT, RIGHT, Panel, Style, every, from_firing, legend, mark_synthetic
from ring_drawings import face
from svg import BLACK, BLUE, GAS, LINER, OIL, ORANGE, RED, WIDTH, Picture, number

ACROSS = WIDTH - LEFT - RIGHT
RING = "#b9c4d2"
OIL_LINE = "#b8862b"


def full_film(points, begin, until, liner, behind, ahead):
    """Outline of the full film between two heights; menisci end it at the films on the liner."""
    inside = [point for point in points if begin <= point[1] <= until]
    (upper, y1), (lower, y2) = inside[0], inside[-1]
    curve = [(0, 0), (0.35, -0.35), (0.62, -0.8), (0.84, -1.6), (1, -3)]
    top = [(upper + (liner - behind - upper) * s, y1 - 5 * c) for s, c in curve]
    low = [(lower + (liner - ahead - lower) * s, y2 + 5 * c) for s, c in curve]
    top = [(x, 2 * y1 - y) for x, y in top]
    low = [(x, 2 * y2 - y) for x, y in low]
    return [(liner, top[-1][1]), *reversed(top), *inside, *low, (liner, low[-1][1])]


def liner_wall(picture, left, top, width, height):
    picture.rect(left, top, width, height, fill=LINER, stroke="none")
    picture.hatch(left, top, width, height, step=10)
    picture.line(left, top, left, top + height)


def pass_of_ring(picture):
    """The ring near the end of its first centimetre: what it leaves, what is under it, what lies ahead."""
    liner, top, bottom = 440, 40, 492
    ring_top, b, reach = 142, 190, 414
    picture.rect(190, top, liner - 190, bottom - top, fill=GAS, stroke="none")
    liner_wall(picture, liner, top, 34, bottom - top)
    left_behind, ahead, fresh = 9, 6, 15
    for y, until, film in ((52, 214, left_behind), (252, reach, ahead), (reach, bottom, fresh)):
        picture.rect(liner - film, y, film, until - y, fill=OIL, stroke="none")
        picture.line(liner - film, y, liner - film, until, stroke=OIL_LINE, width=1)
    points = face(liner - 12, ring_top, b, 52)
    picture.polyline(full_film(points, 206, 262, liner, left_behind, ahead), close=True, fill=OIL, stroke="none")
    picture.polyline([(270, ring_top)] + points + [(270, ring_top + b)], close=True, fill=RING)
    picture.text(316, 244, "ring", bold=True, size=15)
    picture.line(liner, top, liner, bottom)
    # Chamber and crankcase.
    picture.text(206, 70, "chamber side: gas", size=14)
    picture.text(206, 470, "crankcase side: gas", size=14)
    picture.arrow(232, 200, 232, 262, colour=RED, width=2)
    picture.text(224, 226, "|U|", anchor="end", colour=RED, size=15, italic=True)
    picture.text(206, 286, "down", colour=RED, size=14)
    # Distances below TDC.
    picture.line(52, 52, liner - left_behind, 52, stroke=BLUE, width=1, dashes="6 4")
    picture.text(12, 30, "TDC position of the chamber edge", colour=BLUE, size=14)
    picture.line(150, ring_top, 270, ring_top, stroke=BLUE, width=1)
    picture.arrow(164, 52, 164, ring_top, colour=BLUE, both=True, width=1.2)
    picture.text(156, 102, "y_{p}", anchor="end", colour=BLUE, size=15, italic=True)
    picture.line(52, reach, liner - ahead, reach, stroke=BLUE, width=1, dashes="6 4")
    picture.arrow(66, 52, 66, reach, colour=BLUE, both=True, width=1.2)
    picture.lines(76, 330, ["reach of", "the oil ring"], colour=BLUE, size=14)
    picture.text(76, 368, "supply.reach", colour=BLUE, size=14, bold=True)
    # What lies along the liner.
    labels = (
        (98, liner - left_behind / 2, ("film that the ring leaves behind", "f_{out} (film_left_behind)")),
        (176, liner - 17, ("gas on the trailing part of the face,", "up to the meniscus")),
        (233, liner - 6, ("full film", "around the lowest place")),
        (300, liner - 24, ("gas on the leading part,", "where less oil comes than fills it")),
        (370, liner - ahead / 2, ("film ahead f: within the reach", "what the last pass has left")),
        (452, liner - fresh / 2, ("film ahead f: beyond the reach what", "the oil ring leaves, supply.film")),
    )
    for y, x, words in labels:
        picture.line(x, y, liner + 44, y, width=0.9)
        picture.circle(x, y, 2.2, fill=BLACK)
        picture.lines(liner + 50, y - 3, words, step=17, size=14)


def leading_edge(picture, top):
    """The leading edge where more oil comes than the inlet takes."""
    liner, upper, lower, film = 300, top + 14, top + 164, 15
    picture.text(12, top, "more oil than the inlet takes", bold=True, size=14)
    picture.rect(12, upper, liner - 12, lower - upper, fill=GAS, stroke="none")
    points = [(x, y) for x, y in face(liner - 12, upper - 80, 150, 44, n=75) if y >= upper]
    x, y = points[-1]
    surface = f"C{x + 6} {y + 30} {liner - film} {y + 26} {liner - film} {y + 74}V{lower}"
    outline = "L".join(f"{number(a)} {number(b)}" for a, b in points)
    picture.path(f"M{liner} {upper}L{outline}{surface}H{liner}Z", fill=OIL, stroke="none")
    picture.path(f"M{number(x)} {y}{surface}", stroke=OIL_LINE, width=1)
    picture.polyline([(130, upper)] + points + [(130, y)], close=True, fill=RING, stroke="none")
    picture.polyline(points + [(130, y), (130, upper)])
    picture.text(180, upper + 42, "ring", bold=True, size=15)
    liner_wall(picture, liner, upper, 34, lower - upper)
    picture.line(220, y + 22, liner - 22, y + 22, width=0.9)
    picture.circle(liner - 22, y + 22, 2.2, fill=BLACK)
    picture.lines(214, y + 26, ["bead V_{b} of scraped oil", "ahead of the leading edge"], anchor="end", size=14)


def account(picture, top):
    """The account of all oil, in the words of its equation."""
    left = 400
    picture.text(left, top, "account of all oil over a cycle", bold=True, size=14)
    rows = (
        ("Δ (M_{liner} + M_{film} + M_{bead}) =", "on the liner, under the ring, in the bead"),
        ("+ M_{replenished}", "laid by the oil ring less what it takes away"),
        ("− M_{up}", "left at TDC above the ring"),
        ("− M_{down}", "left at BDC below the ring"),
    )
    for row, (symbol, words) in enumerate(rows):
        picture.text(left, top + 28 + 40 * row, symbol, size=15, italic=True)
        picture.text(left + 16, top + 46 + 40 * row, words, size=14)


def oil_on_liner():
    picture = Picture("Oil on the liner, ahead of a ring on its downstroke, under it and behind it", 716)
    pass_of_ring(picture)
    leading_edge(picture, 530)
    account(picture, 530)
    return picture


def gas_edges(**changes):
    """The new ring with gas at both edges."""
    edges = dict(film__cavitation="mass-conserving", film__chamber_edge="gas", film__crankcase_edge="gas")
    return case("styles2014/new.toml", **edges, **changes).run()


@functools.lru_cache(maxsize=None)
def followed(film):
    """The same with the oil on the liner followed from what the oil ring leaves."""
    return gas_edges(film__supply="film-on-liner", supply__film=film, supply__reach="10 mm")


AHEAD, BEHIND = Style(ORANGE, "7 3", 2.2), Style(BLUE)
SURFACES = (("film_ahead", AHEAD, "ahead of the ring"), ("film_left_behind", BEHIND, "behind the ring"))


def oil_along_stroke():
    picture = Picture("Oil on the liner ahead of the ring and behind it, on each of the four strokes", 500)
    mark_synthetic(picture)
    legend(picture, LEFT, 20, [(style, words) for _, style, words in SURFACES], step=190)
    result = followed("2 um")
    strokes = ("power stroke, down", "exhaust stroke, up", "intake stroke, down", "compression stroke, up")
    for k, stroke in enumerate(strokes):
        panel = Panel(picture, LEFT + 350 * (k % 2), 60 + 230 * (k // 2), 300, 160, (0, 80), (0, 3))
        panel.title(stroke)
        panel.y_axis("oil on the liner [µm]" if k % 2 == 0 else "", range(4))
        panel.x_axis("distance of the ring below TDC [mm]" if k > 1 else "", range(0, 81, 20))
        panel.frame()
        angles = range(180 * k + 1, 180 * k + 180)
        place = [1e3 * float(result.piston_position[i]) for i in angles]
        for name, style, _ in SURFACES:
            panel.curve(place, [min(3.0, 1e6 * float(result[name][i])) for i in angles], style)
        if k % 2 == 0:
            x, y = panel.at(79, 2)
            picture.text(x, y - 6, "laid by the oil ring", anchor="end", size=12)
    return picture


def films_by_supply():
    ladder = (
        (gas_edges(), Style(BLUE, width=2.6), "gas edges, flooded"),
        (followed("2 um"), Style(ORANGE, "9 4"), "2 µm on the liner"),
        (followed("0.5 um"), Style(RED, "5 2"), "0.5 µm on the liner"),
        (case("styles2014/new.toml", film__cavitation="mass-conserving").run(), Style(BLACK, "2 3"), "oil edges"),
    )
    picture = Picture("Minimum film thickness and friction power of the new ring with each supply of oil", 500)
    mark_synthetic(picture)
    legend(picture, LEFT, 42, [(style, words) for _, style, words in ladder], step=[190, 180, 190, 0])
    curves = (
        ("min_film_thickness", 1e6, "minimum film thickness h_{m} [µm]", 3, range(4)),
        ("power_loss", 1, "friction power P_{l} [W]", 1500, range(0, 1501, 500)),
    )
    for k, (name, factor, title, highest, ticks) in enumerate(curves):
        panel = Panel(picture, LEFT, 80 + 205 * k, ACROSS, 150, (-360, 360), (0, highest))
        panel.title(title)
        panel.y_axis("", ticks)
        panel.crank(last=k == 1)
        for result, style, _ in ladder:
            angle, values = every(2, *from_firing(result.crank_angle, result[name]))
            panel.curve(angle, [factor * value for value in values], style)
    return picture


PICTURES = {"oil-on-liner": oil_on_liner, "oil-along-stroke": oil_along_stroke, "films-by-supply": films_by_supply}
