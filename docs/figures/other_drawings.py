"""Drawings of crank, cells, unrolled ring, pad, rough surfaces and the way from scan to friction."""

import math

from svg import BLUE, GAS, GREEN, GREY, LINER, METAL, OIL, ORANGE, RED, WIDTH, Picture


def slider_crank():
    """Piston, rod and crank, lying on its side so that names have space."""
    picture = Picture("Slider-crank mechanism with crank angle, piston position and velocity", 300)
    x0, y0, r, rod = 190, 160, 92, 250
    phi = math.radians(52)
    pin = (x0 + r * math.cos(phi), y0 - r * math.sin(phi))
    piston = pin[0] + math.sqrt(rod**2 - (r * math.sin(phi)) ** 2)
    top = x0 + r + rod
    # Liner and head, crank circle.
    for y in (y0 - 62, y0 + 50):
        picture.rect(piston - 120, y, top + 76 - piston + 120, 12, fill=LINER, stroke="#444")
    picture.rect(top + 64, y0 - 62, 12, 124, fill=LINER, stroke="#444")
    picture.circle(x0, y0, r, stroke=GREY, stroke_width=1)
    picture.path(f"M{x0 - r - 16} {y0}H{top + 100}", stroke=GREY, width=0.8, dashes="9 3 2 3")
    picture.rect(piston - 34, y0 - 50, 78, 100, fill=METAL)
    picture.rect(piston + 24, y0 - 50, 9, 8, fill="#8a97a8")
    picture.rect(piston + 24, y0 + 42, 9, 8, fill="#8a97a8")
    picture.line(pin[0], pin[1], piston, y0, width=9, stroke="#a9b1bb")
    picture.line(x0, y0, pin[0], pin[1], width=9, stroke="#8a97a8")
    for x, y in ((x0, y0), pin, (piston, y0)):
        picture.circle(x, y, 7, fill="white")
    picture.text((x0 + pin[0]) / 2 - 22, (y0 + pin[1]) / 2 - 6, "r", italic=True, size=16)
    picture.text(pin[0] + 76, pin[1] + 8, "l", italic=True, size=16)
    # Angle from top dead centre, which is to the right; positive as the crank turns.
    picture.arc(x0, y0, 40, 4, 44, stroke=BLUE, width=1.6)
    picture.arrow(
        x0 + 40 * math.cos(phi * 0.9),
        y0 - 40 * math.sin(phi * 0.9),
        x0 + 39 * math.cos(phi),
        y0 - 39 * math.sin(phi),
        colour=BLUE,
        head=8,
    )
    picture.text(x0 + 46, y0 - 16, "φ", colour=BLUE, italic=True, size=16)
    picture.arc(x0, y0, r + 16, 96, 134, stroke=BLUE, width=1.6)
    end = math.radians(136)
    picture.arrow(
        x0 + (r + 16) * math.cos(end - 0.06),
        y0 - (r + 16) * math.sin(end - 0.06),
        x0 + (r + 16) * math.cos(end),
        y0 - (r + 16) * math.sin(end),
        colour=BLUE,
        head=8,
    )
    picture.text(x0 - r - 4, y0 - r - 4, "ω", colour=BLUE, italic=True, size=16, anchor="end")
    # Dead centres and position of the gudgeon pin.
    for x, words in ((top, "TDC"), (top - 2 * r, "BDC")):
        picture.line(x, y0 + 20, x, y0 + 104, dashes="3 3", width=0.9)
        picture.text(x, y0 + 120, words, anchor="middle", size=12)
    picture.line(piston, y0 + 10, piston, y0 + 92, width=0.9, stroke=RED)
    picture.arrow(top, y0 + 84, piston, y0 + 84, colour=RED)
    picture.text((top + piston) / 2, y0 + 78, "y_{p}", anchor="middle", colour=RED, italic=True, size=15)
    picture.arrow(piston - 26, y0 - 78, piston + 36, y0 - 78, colour=RED, width=2)
    picture.text(piston + 44, y0 - 74, "U_{p} > 0 towards TDC", colour=RED)
    picture.text(top + 84, y0 - 8, "bore axis", colour=GREY, size=12)
    picture.text(top + 34, y0 + 32, "chamber", colour=GREY, size=12, anchor="middle")
    picture.text(x0, y0 + r + 24, "crank, radius r = half the stroke", anchor="middle", colour=GREY, size=12)
    return picture


def cells():
    """Nodes, cells and fluxes of the film."""
    picture = Picture("Nodes and cells of the film with the fluxes through their faces", 300)
    left, step, base = 70, 104, 210
    height = [92, 72, 58, 50, 49, 55, 68]

    def at(x):
        i = min(5, int(x))
        return height[i] + (height[i + 1] - height[i]) * (x - i)

    places = [i / 10 for i in range(61)]
    profile = [(left + step * x, base - at(x)) for x in places]
    picture.polyline([(left, base - 150)] + profile + [(left + 6 * step, base - 150)], close=True, fill=METAL)
    picture.polyline(profile + [(left + 6 * step, base), (left, base)], close=True, fill=OIL, stroke="none")
    picture.rect(left, base, 6 * step, 18, fill=LINER, stroke="#444")
    picture.text(left + 10, base - 128, "ring", bold=True)
    for x in (2.5, 3.5):
        picture.line(left + step * x, base, left + step * x, base - at(x), stroke=BLUE, width=1.6, dashes="5 3")
    for x in (0.5, 1.5, 4.5, 5.5):
        picture.line(left + step * x, base, left + step * x, base - at(x), stroke="#999", width=0.9, dashes="3 3")
    for i in range(7):
        picture.circle(left + step * i, base, 5, fill=RED if i == 3 else "white")
    names = ["0", "", "i−1", "i", "i+1", "", "n"]
    for i, name in enumerate(names):
        picture.text(left + step * i, base + 38, name, anchor="middle", italic=True)
    for x, name in ((2.5, "q_{i−1/2}"), (3.5, "q_{i+1/2}")):
        picture.arrow(left + step * x - 24, base - 22, left + step * x + 24, base - 22, colour=BLUE, width=2)
        picture.text(left + step * x, base - 66, name, anchor="middle", colour=BLUE, italic=True, size=15)
    picture.text(left + 3 * step, base - 20, "ρθh", anchor="middle", italic=True, size=14)
    picture.arrow(left + 2.5 * step, base + 54, left + 3.5 * step, base + 54, both=True, width=1)
    picture.text(left + 3 * step, base + 72, "cell of node i, Δx", anchor="middle")
    picture.arrow(left + 4.2 * step, base + 9, left + 5.2 * step, base + 9, colour=RED, width=2)
    picture.text(left + 5.25 * step, base + 14, "U", colour=RED, italic=True, size=15)
    picture.text(left - 12, base - 36, "p_{g}", anchor="end", italic=True, size=15)
    picture.text(left + 6 * step + 12, base - 36, "p_{cc}", italic=True, size=15)
    picture.text(left - 12, base + 5, "x = 0", anchor="end", size=12)
    picture.text(left + 6 * step + 12, base + 5, "x = b", size=12)
    picture.text(left, 30, "At a node: p or θ, and the mass ρθh of its cell.  At a face: h exact, flux q.", colour=GREY)
    return picture


def unrolled():
    """The ring cut open at its end gap and laid flat."""
    picture = Picture("The ring, cut open at its end gap and laid flat", 290)
    middle = (112, 140)
    half = 9
    picture.arc(*middle, 70, 90 + half, 450 - half, stroke="#8a97a8", width=14)
    picture.text(112, 30, "ring in the bore", anchor="middle", bold=True)
    picture.line(101, 62, 101, 50, width=0.9)
    picture.line(123, 62, 123, 50, width=0.9)
    picture.text(129, 54, "end gap g", size=12)
    picture.arc(*middle, 50, 84, 20, stroke=BLUE, width=1.6)
    picture.arrow(
        112 + 50 * math.cos(0.42),
        140 - 50 * math.sin(0.42),
        112 + 50 * math.cos(0.32),
        140 - 50 * math.sin(0.32),
        colour=BLUE,
    )
    picture.text(140, 128, "y", colour=BLUE, italic=True, size=16, anchor="middle")
    picture.circle(112, 210, 5, fill=GREEN, stroke=GREEN)
    picture.lines(112, 240, ["strip opposite", "the end gap"], anchor="middle", size=12, colour=GREEN)
    left, top, length, b = 300, 88, 400, 110
    picture.text(left, 30, "unrolled film (x drawn some 100 times too long)", bold=True)
    picture.rect(left, top, length, b, fill=OIL)
    for share in (0.012, 0.03, 0.055, 0.095, 0.16, 0.25, 0.36, 0.5):
        for place in (share, 1 - share):
            picture.line(left + length * place, top, left + length * place, top + b, stroke="#b59a4c", width=0.8)
    picture.line(left + length / 2, top, left + length / 2, top + b, stroke=GREEN, width=2.2)
    picture.text(left + length / 2, top - 10, "p = p_{g}  (chamber edge)", anchor="middle", size=14)
    picture.text(left + length / 2, top + b + 20, "p = p_{cc}  (crankcase edge)", anchor="middle", size=14)
    for x in (left, left + length):
        picture.line(x, top, x, top + b, stroke=RED, width=3)
    picture.text(left + 20, top + b + 46, "ends of the ring: p = (p_{g} + p_{cc})/2", colour=RED)
    picture.line(left, top + b + 4, left + 16, top + b + 38, stroke=RED, width=0.9)
    picture.line(left + length, top + b + 4, left + 276, top + b + 40, stroke=RED, width=0.9)
    picture.arrow(left - 16, top, left - 16, top + b + 14, colour=BLUE)
    picture.text(left - 30, top + b / 2, "x", colour=BLUE, italic=True, size=16)
    picture.text(left - 22, top + 8, "0", colour=BLUE, anchor="end", size=12)
    picture.text(left - 22, top + b + 2, "b", colour=BLUE, anchor="end", size=12)
    bottom = top + b + 70
    picture.arrow(left, bottom, left + length + 16, bottom, colour=BLUE)
    picture.text(left, bottom + 17, "y = 0", colour=BLUE, size=12)
    picture.text(left + length - 6, bottom + 17, "L = πB − g", colour=BLUE, anchor="end", size=12)
    picture.arrow(left + 0.75 * length, top + 22, left + 0.75 * length, top + b - 22, colour=RED, width=2)
    picture.text(left + 0.75 * length + 7, top + b / 2 + 5, "U", colour=RED, italic=True, size=15)
    return picture


def pad():
    """A pad over a moving surface."""
    picture = Picture("A pad over a moving surface, with axes and signs", 300)
    left, right, base = 170, 560, 226
    shape = [(left, base - 128), (left + 150, base - 106), (left + 150, base - 138), (left + 250, base - 138)]
    shape += [(left + 250, base - 84), (right, base - 58)]
    picture.polyline([(left, base - 190)] + shape + [(right, base - 190)], close=True, fill=METAL)
    picture.polyline(shape + [(right, base), (left, base)], close=True, fill=OIL, stroke="none")
    picture.line(left, base - 50, right, base - 50, stroke=BLUE, width=0.9, dashes="5 3")
    picture.rect(60, base, 620, 16, fill=LINER, stroke="#444")
    picture.text(left + 12, base - 168, "pad, at rest", bold=True)
    picture.text(left + 158, base - 144, "pocket", colour=GREY, size=12)
    picture.arrow(left + 70, base - 50, left + 70, base - 116, both=True, colour=BLUE, width=1.1)
    picture.text(left + 78, base - 76, "gap g(x, y)", colour=BLUE, italic=True)
    picture.arrow(left + 70, base, left + 70, base - 50, both=True, colour=BLUE, width=1.1)
    picture.text(left + 78, base - 20, "separation s(t)", colour=BLUE, italic=True)
    picture.arrow(right - 60, base, right - 60, base - 70, both=True, width=1.1)
    picture.text(right - 66, base - 22, "h = g + s", anchor="end", italic=True)
    picture.arrow(600, base + 8, 668, base + 8, colour=RED, width=2)
    picture.text(672, base - 8, "U > 0", colour=RED, italic=True, anchor="end")
    picture.text(left - 12, base - 70, "pad.left_pressure", anchor="end", size=12)
    picture.text(right + 12, base - 34, "pad.right_pressure", size=12)
    picture.arrow(left, base + 36, right + 40, base + 36, colour=BLUE)
    picture.text(right + 46, base + 41, "x", colour=BLUE, italic=True, size=15)
    picture.text(left, base + 56, "0", colour=BLUE, anchor="middle", size=12)
    picture.text(right, base + 56, "L", colour=BLUE, anchor="middle", size=12, italic=True)
    picture.line(left, base + 32, left, base + 40, stroke=BLUE)
    picture.line(right, base + 32, right, base + 40, stroke=BLUE)
    picture.arrow(right + 70, base - 120, right + 110, base - 160, colour=BLUE)
    picture.text(right + 116, base - 160, "y", colour=BLUE, italic=True, size=15)
    picture.lines(right + 66, base - 96, ["from front, y = 0,", "to back, y = B"], size=12, colour=BLUE)
    picture.arrow(left + 330, 10, left + 330, 36, colour=RED, width=2)
    picture.text(left + 338, 26, "load W", colour=RED)
    return picture


def rough_surfaces():
    """Two rough surfaces that touch, with the lengths of the contact model."""
    picture = Picture("Two rough surfaces with mean planes, separation and summits", 252)

    def height(x, phase):
        return sum(
            a * math.sin(2 * math.pi * (x * f + phase * (k + 1) * 0.37))
            for k, (a, f) in enumerate(((11, 2.3), (9, 5.1), (6, 9.7), (4, 17.3), (2, 31.9)))
        )

    left, length, upper = 40, 480, 96
    # Closer to each other by what lets the highest places meet.
    apart = max(height(i / 480, 1.0) - height(i / 480, 1.9) for i in range(481))
    lower = upper + apart - 9
    top, bottom, touch = [], [], []
    for i in range(481):
        x = i / 480
        a, b = upper + height(x, 1.0), lower + height(x, 1.9)
        if a > b:
            touch.append(left + length * x)
            a = b = (a + b) / 2
        top.append((left + length * x, a))
        bottom.append((left + length * x, b))
    picture.polyline([(left, 30)] + top + [(left + length, 30)], close=True, fill="#b9c4d2")
    picture.polyline([(left, 216)] + bottom + [(left + length, 216)], close=True, fill=LINER)
    for y in (upper, lower):
        picture.line(left, y, left + length + 26, y, stroke=BLUE, width=1, dashes="9 3 2 3")
    picture.arrow(left + length + 18, upper, left + length + 18, lower, both=True, colour=BLUE)
    picture.text(left + length + 24, (upper + lower) / 2 + 5, "h", colour=BLUE, italic=True, size=16)
    groups = []
    for x in touch:
        if groups and x - groups[-1][-1] < 6:
            groups[-1].append(x)
        else:
            groups.append([x])
    for group in groups:
        x = sum(group) / len(group)
        y = min(bottom, key=lambda place: abs(place[0] - x))[1]
        picture.circle(x, y, 9, stroke=RED, stroke_width=2)
    picture.text(left + 8, 50, "ring", bold=True)
    picture.text(left + 8, 208, "liner", bold=True)
    picture.text(566, 54, "mean planes", colour=BLUE, bold=True)
    picture.lines(566, 74, ["at the distance h"], colour=BLUE, size=12)
    picture.text(566, 134, "summits in contact", colour=RED, bold=True)
    picture.lines(
        566, 152, ["N  peaks per area,", "β  mean radius of a summit,", "σ  composite roughness"], colour=RED, size=12
    )
    picture.text(40, 240, "Heights are drawn many times too large against lengths.", colour=GREY, size=12)
    return picture


def plateau():
    """A liner made in two steps under a ring, with its planes, and its material ratio curve over normal probability."""
    picture = Picture("Plateau over valleys: planes of a liner made in two steps, and its material ratio curve", 300)
    left, length, plane = 30, 330, 138

    def height(x):
        fine = sum(
            a * math.sin(2 * math.pi * (x * f + p)) for a, f, p in ((5, 7.3, 0.1), (4, 15.1, 0.4), (2, 31.7, 0.8))
        )
        grooves = ((0.13, 62, 0.045), (0.42, 84, 0.06), (0.71, 48, 0.04), (0.88, 66, 0.05))
        return plane - fine + max(max(0, depth * (1 - abs(x - at) / wide)) for at, depth, wide in grooves)

    surface = [(left + length * i / 660, height(i / 660)) for i in range(661)]
    mean = sum(y for _, y in surface) / len(surface)
    lowest = plane - 34
    ring = [(x, lowest + 3 * math.sin(x / 9) + 2 * math.sin(x / 4 + 1)) for x, _ in surface]
    picture.polyline([(left, 40)] + ring + [(left + length, 40)], close=True, fill="#b9c4d2")
    picture.polyline(ring + surface[::-1], close=True, fill=OIL, stroke="none")
    picture.polyline([(left, 256)] + surface + [(left + length, 256)], close=True, fill=LINER)
    for y, colour in ((lowest, GREY), (plane, RED), (mean, BLUE)):
        picture.line(left, y, left + length + 40, y, stroke=colour, width=1, dashes="9 3 2 3")
    picture.arrow(left + length + 12, lowest, left + length + 12, mean, both=True, colour=BLUE, head=7)
    picture.text(left + length + 18, lowest + 22, "h", colour=BLUE, italic=True, size=15)
    picture.arrow(left + length + 34, plane - 22, left + length + 34, plane, colour=RED, head=6)
    picture.arrow(left + length + 34, mean + 22, left + length + 34, mean, colour=RED, head=6)
    picture.text(left + length + 40, mean + 20, "z_{p}", colour=RED, italic=True, size=15)
    picture.text(left + 8, 58, "ring", bold=True)
    picture.text(left + 8, 248, "liner", bold=True)
    picture.text(left + 78, 274, "mean planes of the plateau and of the whole liner", colour=GREY, size=12)
    # The material ratio curve: s from -3 to 3, the lines meet at 1.
    x0, width, top, meet = 470, 250, 70, 1.0
    slope, steep = 9, 48

    def at(s, y):
        return x0 + width * (s + 3) / 6, top + y

    def line(s):
        return slope * (s + 3) + (steep - slope) * max(0, s - meet)

    picture.polyline([at(-3, -22), at(-3, 180), at(3, 180)], width=1)
    picture.polyline([at(s, line(s)) for s in (-3, meet, 3)], stroke=BLUE, width=2.4)
    picture.line(*at(meet, line(meet)), *at(3, slope * 6), stroke=RED, width=1.2, dashes="6 4")
    picture.line(*at(meet, line(meet)), *at(0.3, line(meet) - 0.7 * steep), stroke=GREEN, width=1.2, dashes="6 4")
    picture.line(*at(meet, line(meet)), *at(meet, 180), stroke=GREY, width=1, dashes="3 3")
    picture.circle(*at(meet, line(meet)), 3.5, fill="white")
    for s, words in ((-2, "2 %"), (0, "50 %"), (2, "98 %")):
        picture.line(*at(s, 180), *at(s, 184), width=0.8)
        picture.text(at(s, 0)[0], top + 200, words, anchor="middle", size=12)
    picture.text(at(meet, 0)[0], top + 200, "R_{mq}", anchor="middle")
    picture.text(x0 + width / 2, top + 222, "material ratio, over normal probability", anchor="middle")
    picture.text(x0 - 12, top + 80, "height", anchor="middle", turn=-90)
    picture.text(*at(-2.6, -8), "plateau, slope R_{pq}", colour=RED)
    picture.text(*at(1.0, 150), "valleys, slope R_{vq}", anchor="end", colour=GREEN)
    return picture


def box(picture, x, y, width, rows, colour):
    picture.rect(x, y, width, 24 + 16 * (len(rows) - 1) + 10, fill=colour, stroke="#444")
    for i, words in enumerate(rows):
        picture.text(x + width / 2, y + 21 + 16 * i, words, anchor="middle", size=12, bold=i == 0)


def chain():
    """From instrument files to the cycle."""
    picture = Picture("From instrument files by single commands to the case and its report", 330)
    rows = [
        ("height maps", "ring and liner: X3P, SUR ...", "ringfilm pair", "contact: N, β, σ"),
        ("trace over the face", "stylus: x, z", "ringfilm face", "ring.face: polynomial"),
        ("friction loops", "lateral force microscope", "ringfilm lateral-force", "shear strength: ζ"),
        ("engine, oil, pressure", "data sheets, indicated trace", "", ""),
    ]
    for i, (source, detail, command, fragment) in enumerate(rows):
        y = 34 + 72 * i
        box(picture, 12, y, 176, [source, detail], "#eaf2fb")
        if command:
            picture.arrow(188, y + 25, 384, y + 25, colour=GREY)
            picture.text(284, y + 18, command, anchor="middle", size=12, colour=BLUE, bold=True)
            box(picture, 384, y, 150, ["fragment", fragment], "#f6efe2")
            picture.arrow(534, y + 25, 588, 130 + 12 * i, colour=GREY)
        else:
            picture.line(188, y + 25, 548, y + 25, stroke=GREY, width=1.6)
            picture.arrow(548, y + 25, 588, 167, colour=GREY)
    box(picture, 588, 120, 88, ["case", "TOML"], "#e6f3ea")
    picture.arrow(632, 170, 632, 226, colour=GREY)
    picture.text(640, 202, "ringfilm run", size=12, colour=BLUE, bold=True)
    box(picture, 588, 226, 88, ["result", "NetCDF-4"], "#e6f3ea")
    picture.arrow(632, 276, 632, 304, colour=GREY)
    picture.text(640, 294, "report", size=12, colour=BLUE, bold=True)
    picture.text(632, 322, "page", anchor="middle", bold=True, size=12)
    return picture


def broken_film():
    """Gas blows through the throat against the motion; below it the film on the liner, and the pressures."""
    picture = Picture("A film that gas has broken through: what passes lies on the liner", 430)
    left, right, wall, throat, gap = 40, WIDTH - 40, 210, 400, 15

    def height(x):
        return gap + 130 * ((x - throat) / 360) ** 2

    picture.rect(left, 60, right - left, wall - 60, fill=GAS, stroke="none")
    ahead, behind, begin = 22, 6, 180
    step = [begin + 2 * i for i in range((throat - begin) // 2 + 1)]
    curve = ((0, 0), (0.06, 0.35), (0.2, 0.62), (0.5, 0.86), (1, 1))
    meniscus = [(begin - 40 + 40 * along, wall - ahead - (height(begin) - ahead) * up) for up, along in curve]
    outline = [(left, wall), (left, wall - ahead)] + meniscus
    outline += [(x, wall - height(x)) for x in step] + [
        (throat + 14, wall - behind),
        (right, wall - behind),
        (right, wall),
    ]
    picture.polyline(outline, close=True, fill=OIL, stroke="none")
    shape = [(x, wall - height(x)) for x in range(left, right + 1, 4)]
    picture.polyline([(left, 40)] + shape + [(right, 40)], close=True, fill="#b9c4d2")
    picture.text(throat, 100, "ring", anchor="middle", bold=True, size=15)
    picture.rect(left, wall, right - left, 24, fill=LINER, stroke="none")
    picture.hatch(left, wall, right - left, 24)
    picture.line(left, wall, right, wall)
    picture.arrow(left + 10, wall + 38, left + 90, wall + 38, colour=RED, width=2)
    picture.text(left + 98, wall + 43, "U", colour=RED, size=15, italic=True)
    picture.arrow(right - 24, wall - 22, throat + 44, wall - 11, colour=BLUE, width=1.6)
    picture.text(right - 16, wall - 30, "gas blows through", anchor="end", colour=BLUE, size=14)
    picture.text(throat - 190, wall - 16, "full film", size=14)
    picture.line(right - 60, wall - 3, right - 60, wall + 30, width=0.9)
    picture.text(right - 16, wall + 45, "what passes lies on the liner, ⅔ U f^{*} at the most", anchor="end", size=14)
    # Pressures.
    top, zero = 290, 400
    low, high, at_throat = zero - 12, top, zero - 52
    picture.line(left, zero, right, zero, width=0.9)
    picture.arrow(left, zero, left, top - 12, width=1.1)
    picture.text(left + 8, top - 4, "pressure", size=13)
    rise = [
        (begin - 20 + (throat - begin + 20) * t, low + (at_throat - low) * t**2.2)
        for t in (i / 20 for i in range(21))
    ]
    picture.polyline([(left, low)] + rise, stroke=ORANGE, width=2.2)
    length = 70
    gas = [
        (throat - length / 2 + length * t, at_throat + (high - at_throat) * (3 * t * t - 2 * t**3))
        for t in (i / 20 for i in range(21))
    ]
    picture.polyline(gas + [(right, high)], stroke=BLUE, width=2.2)
    picture.line(throat, wall - gap, throat, zero, width=0.9, dashes="4 4")
    picture.arrow(throat - length / 2, zero + 14, throat + length / 2, zero + 14, both=True, width=1.1)
    picture.text(throat + length / 2 + 8, zero + 19, "l, length of the throat", size=13)
    picture.text(right - 8, high - 8, "gas behind the ring", anchor="end", colour=BLUE, size=13)
    picture.text(left + 40, low - 12, "film up to the throat", colour=ORANGE, size=13)
    picture.arrow(throat + 120, at_throat, throat + 120, high, both=True, width=1.1)
    picture.line(throat, at_throat, throat + 128, at_throat, width=0.9)
    picture.text(throat + 128, (at_throat + high) / 2 + 5, "Δp", size=15, italic=True)
    return picture


def land_on_hone():
    """A flat land slides over a honed liner; w, s and where oil is dragged from a valley."""
    picture = Picture("Flat land of width w sliding over a honed liner at the distance s of the mean planes", 230)
    left, right, mean = 120, 620, 150
    picture.rect(left, 40, right - left, 44, fill=METAL)
    points = []
    for k in range(0, 501, 4):
        depth = sum(46 * math.exp(-(((k - at) / 13) ** 2)) for at in (90, 215, 330, 430))
        points.append((left + k, mean - 14 + 3 * math.sin(k / 9) + depth))
    outline = "".join(f"L{x} {y:.1f}" for x, y in points)
    picture.path(f"M{left} 84H{right}" + "".join(f"L{x} {y:.1f}" for x, y in reversed(points)) + "Z", fill=OIL)
    picture.path(f"M{left} 215" + outline + f"L{right} 215Z", fill=LINER, stroke="#444")
    picture.line(left - 30, mean, right + 30, mean, dashes="8 4", stroke=GREY)
    picture.arrow(left - 14, 84, left - 14, mean, colour=RED)
    picture.text(left - 30, 120, "s", colour=RED, italic=True, size=16)
    picture.arrow(left, 28, right, 28, colour=BLUE)
    picture.text((left + right) / 2, 20, "w", colour=BLUE, italic=True, size=16, anchor="middle")
    picture.arrow(right + 10, 62, right + 80, 62, width=2)
    picture.text(right + 40, 52, "U", italic=True, size=16)
    picture.text(left + 200, 66, "land", size=14)
    picture.text(left + 200, 208, "liner with the grooves of the hone", size=13)
    return picture


def fit_of_a_curve():
    """Measured points with their deviations, the model at the best parameters and its band."""
    picture = Picture("Measured values with their deviations, the fitted model and its band", 250)
    x0, x1, y0 = 70, 640, 200

    def model(t):
        return y0 - 120 * math.exp(-(((t - 0.3) / 0.13) ** 2)) - 30 * math.sin(3.1 * t)

    steps = [k / 60 for k in range(61)]
    upper = [(x0 + t * (x1 - x0), model(t) - 9 - 8 * t) for t in steps]
    lower = [(x0 + t * (x1 - x0), model(t) + 9 + 8 * t) for t in reversed(steps)]
    band = "L".join(f"{x:.1f} {y:.1f}" for x, y in upper + lower)
    picture.path(f"M{band}Z", fill="#cfe0f3")
    picture.path("M" + "L".join(f"{x0 + t * (x1 - x0):.1f} {model(t):.1f}" for t in steps), stroke=BLUE, width=2)
    for k in range(1, 20):
        t = k / 20
        y = model(t) + 13 * math.sin(37.0 * k)
        x = x0 + t * (x1 - x0)
        picture.line(x, y - 14, x, y + 14, stroke=GREY)
        picture.circle(x, y, 3.5, fill=RED)
    picture.line(x0, y0 + 20, x1, y0 + 20, stroke="#444")
    picture.line(x0, y0 + 20, x0, 30, stroke="#444")
    picture.text((x0 + x1) / 2, y0 + 42, "crank angle", anchor="middle", size=13)
    picture.text(x0 + 260, 60, "model m(u) with its band; measured y, deviation σ", size=13)
    return picture


PICTURES = {
    "land-on-hone": land_on_hone,
    "fit-of-a-curve": fit_of_a_curve,
    "broken-film": broken_film,
    "slider-crank": slider_crank,
    "cells": cells,
    "unrolled-ring": unrolled,
    "pad": pad,
    "rough-surfaces": rough_surfaces,
    "plateau": plateau,
    "measured-chain": chain,
}
