"""Drawings of the ring in its cylinder: places, axes, signs and forces. Nothing in them is computed."""

import math

from svg import BLUE, FONT, GAS, GREY, LINER, METAL, OIL, RED, Picture


def face(x_low, y_top, width, depth, n=40):
    """Points of a crowned running surface from its upper to its lower edge; `x_low` is where it reaches out most."""
    points = []
    for i in range(n + 1):
        t = i / n
        points.append((x_low - depth * ((t - 0.45) / 0.55) ** 2, y_top + width * t))
    return points


def cylinder(picture, left):
    """Piston, rings and bore, cut along the axis of the bore."""
    bore, top = 150, 62
    picture.rect(left, top, 26, 290, fill=LINER, stroke="none")
    picture.rect(left + 26 + bore, top, 26, 290, fill=LINER, stroke="none")
    for wall in (left, left + 26 + bore):
        picture.hatch(wall, top, 26, 290)
    picture.line(left + 26, top, left + 26, top + 290)
    picture.line(left + 26 + bore, top, left + 26 + bore, top + 290)
    picture.rect(left, top - 20, bore + 52, 20, fill=LINER, stroke="#444")
    picture.rect(left + 26, top, bore, 88, fill=GAS, stroke="none")
    picture.rect(left + 32, 150, bore - 12, 130, fill=METAL)
    for groove in (174, 206):
        for side in (left + 26, left + 26 + bore - 16):
            picture.rect(side, groove, 16, 9, fill="#8a97a8")
    middle = left + 26 + bore / 2
    picture.line(middle, 258, middle, 352, width=9, stroke="#a9b1bb")
    picture.circle(middle, 258, 11, fill="white")
    picture.path(f"M{middle} 50V362", stroke=GREY, width=0.8, dashes="9 3 2 3")
    picture.text(middle + 8, 92, "chamber", colour=GREY)
    picture.text(middle + 8, 114, "p_{g}", size=16, italic=True)
    picture.text(middle - 72, 312, "crankcase", colour=GREY, size=12)
    picture.text(middle - 70, 334, "p_{cc}", size=16, italic=True)
    picture.text(left + 50, 170, "piston", colour=GREY)
    picture.text(middle + 12, 330, "rod", colour=GREY)
    picture.text(left + 4, 372, "liner", colour=GREY)
    picture.arrow(left + 52, 252, left + 52, 206, colour=RED, width=2)
    picture.text(left + 57, 236, "U_{p} > 0", colour=RED, size=11)
    # The place that is drawn larger.
    picture.circle(left + 26 + bore - 6, 178, 21, stroke=BLUE)
    picture.line(left + 26 + bore + 14, 170, left + 258, 74, stroke=BLUE, width=0.9)
    picture.line(left + 26 + bore + 14, 186, left + 258, 374, stroke=BLUE, width=0.9)
    picture.line(left + 26, 392, left + 26 + bore, 392, width=0.8)
    picture.arrow(left + 26, 392, left + 26 + bore, 392, both=True, width=1)
    picture.text(middle, 408, "bore B", anchor="middle")


def enlarged(picture, left):
    """The ring in its groove and the film under its face."""
    top, height = 74, 300
    liner = left + 330
    picture.rect(left, top, liner - left, height, fill=GAS, stroke="none")
    picture.rect(liner, top, 56, height, fill=LINER, stroke="none")
    picture.hatch(liner, top, 56, height, step=10)
    picture.line(liner, top, liner, top + height)
    # Piston with its groove.
    picture.polyline(
        [(left, top), (left + 232, top), (left + 232, 128), (left + 54, 128), (left + 54, 306), (left + 232, 306)]
        + [(left + 232, top + height), (left, top + height)],
        close=True,
        fill=METAL,
    )
    picture.text(left + 8, top + 20, "piston", colour=GREY)
    # Ring and film: the face reaches out most below its middle.
    ring_top, b = 152, 148
    points = face(liner - 20, ring_top, b, 40)
    picture.polyline(points + [(liner, ring_top + b), (liner, ring_top)], close=True, fill=OIL, stroke="none")
    picture.polyline([(left + 104, ring_top)] + points + [(left + 104, ring_top + b)], close=True, fill="#b9c4d2")
    picture.text(left + 170, 236, "ring", bold=True)
    picture.text(left + 79, 226, "p_{g}", anchor="middle", size=16, italic=True)
    picture.text(left + 79, 246, "behind", anchor="middle", size=11, colour=GREY)
    picture.text(left + 272, 112, "p_{g}", size=16, italic=True)
    picture.text(left + 240, 128, "chamber side", size=11, colour=GREY)
    picture.text(left + 262, 344, "p_{cc}", size=16, italic=True)
    picture.text(left + 240, 360, "crankcase side", size=11, colour=GREY)
    # Width of the face, on the left of it.
    picture.arrow(left + 222, ring_top, left + 222, ring_top + b, both=True, width=1)
    picture.text(left + 214, 276, "b", anchor="end", italic=True)
    # Axis x, beside the liner.
    axis = liner + 74
    picture.arrow(axis, ring_top - 8, axis, ring_top + b + 34, colour=BLUE, width=2)
    for y, words in ((ring_top, "x = 0"), (ring_top + b, "x = b")):
        picture.line(liner + 56, y, axis + 4, y, stroke=BLUE, width=0.9)
        picture.text(axis + 8, y + 4, words, colour=BLUE, italic=True)
    picture.text(axis - 4, ring_top + b + 52, "x", colour=BLUE, italic=True, size=16)
    # Film thickness.
    low = ring_top + 0.45 * b
    picture.arrow(liner - 46, low, liner - 20, low, width=1, head=6)
    picture.arrow(liner + 22, low, liner, low, width=1, head=6)
    picture.text(liner + 26, low + 5, "h_{m}", italic=True, size=15)
    place = ring_top + 0.86 * b
    picture.line(liner - 42, place, liner, place, width=1, dashes="3 2")
    picture.arrow(liner + 22, place, liner, place, width=1, head=6)
    picture.text(liner + 24, place + 5, "h(x)", italic=True, size=14)
    # The liner as the ring sees it.
    picture.arrow(liner + 28, top + 18, liner + 28, top + 64, colour=RED, width=2)
    picture.text(liner + 64, top + 18, "U = +U_{p}", colour=RED, size=14, italic=True)
    picture.lines(liner + 64, top + 36, ["liner, seen", "from the ring"], step=15, colour=RED, size=12)


def geometry():
    picture = Picture("Ring, groove and liner with the axis x, pressures and the sign of the velocity", 424)
    picture.text(12, 24, "cylinder", bold=True)
    picture.text(270, 24, "compression ring, enlarged (film not to scale)", bold=True)
    cylinder(picture, 12)
    enlarged(picture, 270)
    return picture


def arrows(picture, places, begin, end, colour):
    for y in places:
        picture.arrow(begin, y, end, y, colour=colour, width=1.4, head=7)


def force_balance():
    """The ring cut free."""
    picture = Picture("Radial forces on the ring: tension and gas outwards, film and asperities inwards", 330)
    top, b = 70, 190
    left, liner = 250, 420
    points = face(liner - 14, top, b, 34)
    picture.polyline(points + [(liner, top + b), (liner, top)], close=True, fill=OIL, stroke="none")
    picture.polyline([(left, top)] + points + [(left, top + b)], close=True, fill="#b9c4d2")
    picture.text(left + 56, top + 100, "ring", bold=True)
    picture.rect(liner, top - 22, 26, b + 44, fill=LINER, stroke="none")
    picture.hatch(liner, top - 22, 26, b + 44)
    picture.line(liner, top - 22, liner, top + b + 22)
    steps = [top + b * (i + 0.5) / 8 for i in range(8)]
    arrows(picture, steps, left - 44, left, BLUE)
    picture.line(left - 44, top, left - 44, top + b, stroke=BLUE, width=1)
    arrows(picture, steps, left - 72, left - 46, RED)
    picture.line(left - 72, top, left - 72, top + b, stroke=RED, width=1)
    picture.text(16, top + 26, "gas behind the ring", colour=BLUE, bold=True)
    picture.text(16, top + 46, "k_{g} p_{g}", colour=BLUE, italic=True, size=15)
    picture.text(16, top + 90, "ring tension", colour=RED, bold=True)
    picture.text(16, top + 110, "p_{e}", colour=RED, italic=True, size=15)
    picture.lines(16, top + 146, ["load, outwards:"], bold=True)
    picture.text(16, top + 168, "W = (p_{e} + k_{g} p_{g}) πB b", italic=True, size=14)
    # Pressure of film and asperities over x, beside the liner.
    base, widest = 470, 120
    film, contact = [], []
    for i in range(81):
        t = i / 80
        p = 1.0 - 0.72 * t + 0.55 * math.exp(-(((t - 0.36) / 0.13) ** 2))
        film.append((base + 0.78 * widest * p, top + b * t))
        contact.append((base + widest * 0.62 * math.exp(-(((t - 0.45) / 0.07) ** 2)), top + b * t))
    picture.polyline([(base, top)] + film + [(base, top + b)], close=True, fill="#cfe3f3", stroke=BLUE, width=1.6)
    picture.polyline([(base, top)] + contact + [(base, top + b)], close=True, fill="#f3c9a8", stroke=RED, width=1.6)
    picture.arrow(base, top - 14, base, top + b + 34, width=1.2)
    picture.text(base + 8, top + b + 36, "x", italic=True, size=15)
    picture.text(base + 0.78 * widest + 8, top + 4, "p(0) = p_{g}", italic=True)
    picture.text(base + 0.78 * 0.3 * widest + 12, top + b + 4, "p(b) = p_{cc}", italic=True)
    picture.text(base, top - 40, "pressures on the face, inwards", bold=True)
    picture.text(614, top + 40, "film p(x)", colour=BLUE, bold=True)
    picture.text(614, top + 60, "W_{h} = πB ∫ p dx", colour=BLUE, italic=True, size=14)
    picture.text(614, top + 98, "asperities p_{a}(x)", colour=RED, bold=True)
    picture.text(614, top + 118, "W_{a} = πB ∫ p_{a} dx", colour=RED, italic=True, size=14)
    picture.text(614, top + 160, "balance:", bold=True)
    picture.text(614, top + 182, "W_{h} + W_{a} = W", italic=True, size=15)
    picture.text(16, 318, "The balance determines the one unknown clearance h_{m}.", colour=GREY, size=FONT)
    return picture


def tension():
    """Three ways to state the tension of the ring."""
    picture = Picture("Ring tension: free gap, tangential force, elastic pressure", 290)
    titles = ("free ring", "closed by a tangential force", "in the bore")
    for i, (middle, words) in enumerate(zip((130, 380, 630), titles)):
        picture.text(middle, 26, words, anchor="middle", bold=True)
        radius, half = (84, 17) if i == 0 else (80, 4)
        picture.arc(middle, 150, radius, 90 + half, 450 - half, stroke="#8a97a8", width=13)
        picture.circle(middle, 150, 2, fill="black") if i == 0 else None
    # Free gap.
    picture.line(105, 58, 105, 40, width=0.9)
    picture.line(155, 58, 155, 40, width=0.9)
    picture.arrow(105, 44, 155, 44, both=True, width=1)
    picture.text(163, 48, "free gap")
    # Tangential force.
    picture.arrow(326, 52, 372, 52, colour=RED, width=2)
    picture.arrow(434, 52, 388, 52, colour=RED, width=2)
    picture.line(373, 48, 373, 66, stroke=RED)
    picture.line(387, 48, 387, 66, stroke=RED)
    picture.text(304, 57, "F_{t}", colour=RED, italic=True, size=15)
    picture.text(440, 57, "F_{t}", colour=RED, italic=True, size=15)
    picture.text(380, 154, "radius B/2", anchor="middle", colour=GREY)
    # Elastic pressure on the bore.
    for k in range(16):
        angle = math.radians(90 + 11.25 + 22.5 * k)
        x, y = math.cos(angle), -math.sin(angle)
        picture.arrow(630 + 90 * x, 150 + 90 * y, 630 + 112 * x, 150 + 112 * y, colour=BLUE, width=1.4, head=6)
    picture.text(630, 154, "p_{e} on the bore", anchor="middle", colour=BLUE)
    for middle, words in ((130, "ring.free_gap"), (380, "ring.tangential_force"), (630, "ring.elastic_pressure")):
        picture.text(middle, 284, words, anchor="middle", colour=GREY, size=12)
    return picture


PICTURES = {"geometry": geometry, "force-balance": force_balance, "ring-tension": tension}
