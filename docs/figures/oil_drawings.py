"""Drawings of oil on the liner, as it leaves for the chamber, and of gas. Nothing in them is computed."""

from svg import BLACK, BLUE, GAS, GREY, LINER, METAL, OIL, RED, Picture


def oil_consumption():
    """Top piston land, first ring and liner, cut along the axis of the bore, with the four parts."""
    title = "Oil that leaves the liner for the chamber: evaporated, scraped up, carried by gas, thrown off"
    picture = Picture(title, 430)
    liner, top, bottom, crown = 470, 40, 410, 150
    piston, ring_top, ring_low = 410, 258, 300
    picture.rect(110, top, liner - 110, bottom - top, fill=GAS, stroke="none")
    picture.rect(liner, top, 40, bottom - top, fill=LINER, stroke="none")
    picture.hatch(liner, top, 40, bottom - top, step=10)
    picture.line(liner, top, liner, bottom)
    picture.rect(110, crown, piston - 110, bottom - crown, fill=METAL)
    picture.rect(340, ring_top - 5, piston - 340, ring_low - ring_top + 10, fill=GAS)
    picture.rect(352, ring_top, liner - 6 - 352, ring_low - ring_top, fill="#b9c4d2")
    picture.text(372, 284, "ring 1", bold=True)
    # Oil: film on the liner, bead ahead of the ring, film on the top piston land.
    picture.rect(liner - 6, top, 6, ring_low - top, fill=OIL, stroke="none")
    picture.rect(liner - 10, ring_low, 10, bottom - ring_low, fill=OIL, stroke="none")
    picture.path(
        f"M{liner - 6} {ring_top - 16}L{liner - 26} {ring_top}L{liner - 6} {ring_top}Z", fill=OIL, stroke="none"
    )
    picture.rect(piston, crown, 5, ring_top - 5 - crown, fill=OIL, stroke="none")
    picture.text(130, 70, "chamber", colour=GREY)
    picture.text(130, 180, "piston", colour=BLACK)
    picture.text(522, 390, "liner", colour=GREY)
    picture.text(262, 392, "second piston land", colour=GREY)
    for y in (62, 92, 122):
        picture.arrow(liner - 8, y, liner - 48, y - 8, colour=RED, width=1.6)
    picture.text(300, 82, "evaporation", colour=RED, bold=True)
    picture.arrow(piston + 3, crown + 34, piston + 3, crown - 20, colour=BLUE, width=2)
    picture.text(290, 136, "thrown off", colour=BLUE, bold=True)
    picture.arrow(liner - 18, ring_top - 8, liner - 18, ring_top - 66, colour=BLUE, width=2)
    picture.text(528, 236, "scraped up", colour=BLUE, bold=True)
    picture.line(524, 232, liner - 14, ring_top - 10, stroke=BLUE, width=0.9)
    picture.path(f"M{piston + 22} 372V330L{piston + 26} 312V232", stroke=RED, width=1.6, dashes="6 4")
    picture.arrow(piston + 26, 240, piston + 26, 196, colour=RED)
    picture.text(528, 324, "carried by gas", colour=RED, bold=True)
    picture.text(528, 342, "through the end gap", colour=RED)
    picture.line(524, 324, piston + 28, 316, stroke=RED, width=0.9)
    picture.line(330, crown, 396, crown, stroke=GREY, width=0.8)
    picture.arrow(392, crown, 392, ring_top - 5, colour=GREY, both=True, width=1)
    picture.text(384, 212, "top piston land", anchor="end", colour=GREY)
    return picture


def menisci():
    """The film between two menisci under the face of a ring, with the liner film, the bead and gas at both edges."""
    picture = Picture("A film between two menisci under the face of a ring, with what lies on the liner", 300)
    liner, lowest, middle, half = 230, 214, 360, 230

    def face(x):
        return lowest - 110 * ((x - middle) / half) ** 2

    def curve(begin, end):
        return "L".join(f"{x:.1f} {face(x):.1f}" for x in range(begin, end + 1, 10))

    left, right = middle - half, middle + half
    picture.rect(60, 40, 600, liner - 40, fill=GAS, stroke="none")
    picture.path(f"M{left} 40L{curve(left, right)}L{right} 40Z", fill=METAL)
    picture.text(middle, 90, "ring", anchor="middle", bold=True)
    film_left, film_right = middle - 130, middle + 90
    picture.rect(60, liner - 4, film_left - 60, 4, fill=OIL, stroke="none")
    left_behind = (liner - face(film_right)) / 2
    picture.rect(film_right, liner - left_behind, 660 - film_right, left_behind, fill=OIL, stroke="none")
    picture.path(f"M{film_left} {liner}L{curve(film_left, film_right)}L{film_right} {liner}Z", fill=OIL, stroke="none")
    picture.path(
        f"M{film_left} {liner}L{film_left - 26} {liner - 4}L{film_left} {liner - 18}Z", fill=OIL, stroke="none"
    )
    picture.rect(60, liner, 600, 34, fill=LINER, stroke="none")
    picture.hatch(60, liner, 600, 34, step=10)
    picture.line(60, liner, 660, liner)
    picture.arrow(260, liner + 18, 340, liner + 18, colour=BLUE, width=2)
    picture.text(350, liner + 23, "liner, U", colour=BLUE, bold=True)
    for x, name in ((film_left, "x_L"), (film_right, "x_R")):
        picture.line(x, face(x) - 34, x, liner, stroke=RED, width=1.2)
        picture.text(x, face(x) - 40, name, anchor="middle", colour=RED, bold=True)
    picture.text(film_left - 34, liner - 26, "bead", anchor="end", colour=GREY)
    picture.text(70, 62, "gas", colour=GREY)
    picture.text(650, 62, "gas", anchor="end", colour=GREY)
    return picture


def gas_composition():
    """Chamber, volumes of a pack and crankcase, with what the flows between them carry."""
    picture = Picture("Gases that the flow carries from the chamber through the volumes of a pack", 250)
    boxes = (
        (20, 150, "chamber", ("fresh, burnt", "by crank angle")),
        (210, 110, "groove 1", ("mixed",)),
        (360, 110, "land 2", ("mixed",)),
        (560, 180, "crankcase", ("mixed, constant", "over the cycle")),
    )
    tops = {"groove 1": 40}
    for x, width, name, rows in boxes:
        top = tops.get(name, 120)
        picture.rect(x, top, width, 70, fill=GAS)
        picture.text(x + width / 2, top + 22, name, anchor="middle", bold=True)
        picture.lines(x + width / 2, top + 42, rows, anchor="middle", colour=GREY)
    picture.arrow(170, 145, 360, 145, colour=RED, both=True)
    picture.text(265, 163, "end gap 1", anchor="middle", colour=RED)
    picture.arrow(120, 120, 210, 75, colour=RED, both=True)
    picture.text(118, 88, "above ring 1", anchor="middle", colour=RED)
    picture.arrow(320, 75, 400, 120, colour=RED, both=True)
    picture.text(372, 84, "below ring 1", colour=RED)
    picture.arrow(470, 155, 560, 155, colour=RED, both=True)
    picture.text(515, 143, "...", anchor="middle", colour=RED, bold=True)
    picture.arrow(600, 60, 600, 120, colour=BLUE)
    picture.text(600, 50, "air", anchor="middle", colour=BLUE, bold=True)
    picture.arrow(690, 120, 690, 60, colour=BLUE)
    picture.text(690, 50, "breather", anchor="middle", colour=BLUE, bold=True)
    picture.text(20, 225, "Each flow carries the shares of the volume that it leaves.", colour=GREY)
    return picture


PICTURES = {"oil-consumption": oil_consumption, "menisci": menisci, "gas-composition": gas_composition}
