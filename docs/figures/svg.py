"""A drawing as SVG text with the standard library alone: the same drawing gives the same bytes on every machine.

Text keeps being text, with a fallback to any sans-serif font; lower and raised letters are written p_{g} and 10^{6}.
Coordinates are pixels of a picture that is WIDTH wide, from the upper left corner.
"""

import math
import re

WIDTH = 760
FONT = 13
# Distinguishable by colour-blind readers (Okabe and Ito); dashes distinguish curves in grey print.
BLUE, ORANGE, GREEN, RED, BLACK, GREY = "#0072B2", "#E69F00", "#009E73", "#D55E00", "#000000", "#666666"
PURPLE = "#CC79A7"
METAL, OIL, GAS, LINER = "#d9dde2", "#f6dc9c", "#e8f1f9", "#c3c8ce"


def number(value):
    """A coordinate with one digit after the point, never "-0"."""
    text = f"{value:.1f}"
    text = text[:-2] if text.endswith(".0") else text
    return "0" if text == "-0" else text


def escaped(text):
    return text.replace("&", "&amp;").replace("<", "&lt;").replace(">", "&gt;")


def rich(text):
    """Text with lowered and raised parts, as tspans."""
    out, shift = [], 0.0
    for part in re.split(r"([_^]\{[^}]*\})", text):
        if not part:
            continue
        if re.match(r"[_^]\{", part):
            target = 3.5 if part[0] == "_" else -4.5
            out.append(f'<tspan dy="{number(target - shift)}" font-size="75%">{escaped(part[2:-1])}</tspan>')
            shift = target
        elif shift:
            out.append(f'<tspan dy="{number(-shift)}">{escaped(part)}</tspan>')
            shift = 0.0
        else:
            out.append(escaped(part))
    return "".join(out)


class Picture:
    """Elements in the order in which they are drawn."""

    def __init__(self, title, height):
        self.title, self.height, self.parts, self.names = title, height, [], 0

    def add(self, element):
        self.parts.append(element)

    def text(self, x, y, words, anchor="start", size=FONT, colour=BLACK, bold=False, italic=False, turn=0):
        look = f'font-size="{size}"' if size != FONT else ""
        look += f' text-anchor="{anchor}"' if anchor != "start" else ""
        look += f' fill="{colour}"' if colour != BLACK else ""
        look += ' font-weight="bold"' if bold else ""
        look += ' font-style="italic"' if italic else ""
        look += f' transform="rotate({number(turn)} {number(x)} {number(y)})"' if turn else ""
        self.add(f'<text x="{number(x)}" y="{number(y)}" {look.strip()}>{rich(words)}</text>'.replace(" >", ">"))

    def lines(self, x, y, rows, step=17, **look):
        """Several rows of text."""
        for row, words in enumerate(rows):
            self.text(x, y + step * row, words, **look)

    def path(self, d, stroke=BLACK, width=1.3, fill="none", dashes="", opacity=None):
        look = f' stroke-dasharray="{dashes}"' if dashes else ""
        look += f' fill-opacity="{opacity:g}"' if opacity is not None else ""
        self.add(f'<path d="{d}" fill="{fill}" stroke="{stroke}" stroke-width="{width:g}"{look}/>')

    def line(self, x1, y1, x2, y2, **look):
        self.path(f"M{number(x1)} {number(y1)}L{number(x2)} {number(y2)}", **look)

    def polyline(self, points, close=False, **look):
        d = "M" + "L".join(f"{number(x)} {number(y)}" for x, y in points)
        self.path(d + ("Z" if close else ""), **look)

    def rect(self, x, y, width, height, fill="none", stroke=BLACK, stroke_width=1.2):
        self.add(
            f'<rect x="{number(x)}" y="{number(y)}" width="{number(width)}" height="{number(height)}" '
            f'fill="{fill}" stroke="{stroke}" stroke-width="{stroke_width:g}"/>'
        )

    def circle(self, x, y, radius, fill="none", stroke=BLACK, stroke_width=1.2):
        self.add(
            f'<circle cx="{number(x)}" cy="{number(y)}" r="{number(radius)}" fill="{fill}" stroke="{stroke}" '
            f'stroke-width="{stroke_width:g}"/>'
        )

    def arrow(self, x1, y1, x2, y2, colour=BLACK, width=1.6, both=False, head=9):
        """A line with a head at its end, or at both."""
        angle = math.atan2(y2 - y1, x2 - x1)
        back = 0.8 * head
        self.line(
            x1 + (back * math.cos(angle) if both else 0),
            y1 + (back * math.sin(angle) if both else 0),
            x2 - back * math.cos(angle),
            y2 - back * math.sin(angle),
            stroke=colour,
            width=width,
        )
        for x, y, turn in ((x2, y2, angle), (x1, y1, angle + math.pi))[: 2 if both else 1]:
            corners = [(x, y)]
            corners += [(x - head * math.cos(turn + side), y - head * math.sin(turn + side)) for side in (0.38, -0.38)]
            self.polyline(corners, close=True, fill=colour, stroke="none", width=1)

    def arc(self, x, y, radius, begin, end, **look):
        """Part of a circle; angles in degrees, counterclockwise from the right."""
        steps = max(2, int(abs(end - begin) / 4))
        angles = [math.radians(begin + (end - begin) * i / steps) for i in range(steps + 1)]
        self.polyline([(x + radius * math.cos(a), y - radius * math.sin(a)) for a in angles], **look)

    def hatch(self, x, y, width, height, step=8, colour="#888"):
        """Slanted lines in a rectangle."""
        d = []
        offset = step
        while offset < width + height:
            x1, y1 = (x + offset, y) if offset <= width else (x + width, y + offset - width)
            x2, y2 = (x, y + offset) if offset <= height else (x + offset - height, y + height)
            d.append(f"M{number(x1)} {number(y1)}L{number(x2)} {number(y2)}")
            offset += step
        self.path("".join(d), stroke=colour, width=0.7)

    def svg(self):
        return "\n".join(
            [
                f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {number(self.height)}" role="img" '
                f'font-family="Helvetica, Arial, sans-serif" font-size="{FONT}">',
                f"<title>{escaped(self.title)}</title>",
                f'<rect width="{WIDTH}" height="{number(self.height)}" fill="white"/>',
                *self.parts,
                "</svg>",
                "",
            ]
        )
