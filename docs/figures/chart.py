"""Axes, curves, bands and legends on a drawing of svg.py. Values come in the unit that the axis names."""

import math

from svg import GREY

STROKES = ((-270, "intake"), (-90, "compression"), (90, "power"), (270, "exhaust"))
LEFT, RIGHT = 74, 18


class Style:
    """How a curve looks; equal in curve and legend."""

    def __init__(self, colour, dashes="", width=1.8):
        self.colour, self.dashes, self.width = colour, dashes, width


class Panel:
    """A rectangle with two axes; `x` and `y` are (lowest, highest) value, `log` the names of logarithmic axes."""

    def __init__(self, picture, left, top, width, height, x, y, log=""):
        self.picture, self.left, self.top, self.width, self.height = picture, left, top, width, height
        self.x, self.y, self.log = x, y, log

    def _share(self, value, ends, logarithmic):
        if logarithmic:
            return math.log(max(value, 1e-300) / ends[0]) / math.log(ends[1] / ends[0])
        return (value - ends[0]) / (ends[1] - ends[0])

    def at(self, x, y):
        """The place of a value; beyond the axes it is cut at their ends."""
        right = self._share(x, self.x, "x" in self.log)
        up = min(1.0, max(0.0, self._share(y, self.y, "y" in self.log)))
        return self.left + self.width * right, self.top + self.height * (1 - up)

    def title(self, words):
        self.picture.text(self.left, self.top - 9, words, bold=True)

    def x_axis(self, label, ticks, grid=True, names=None, label_gap=38):
        bottom = self.top + self.height
        for i, tick in enumerate(ticks):
            x = self.at(tick, self.y[0])[0]
            if grid:
                self.picture.line(x, self.top, x, bottom, stroke="#ddd", width=0.8)
            self.picture.line(x, bottom, x, bottom + 4, width=0.8)
            self.picture.text(x, bottom + 18, names[i] if names else shown(tick), anchor="middle", size=12)
        self.picture.text(self.left + self.width / 2, bottom + label_gap, label, anchor="middle")

    def y_axis(self, label, ticks, names=None, label_gap=54, zero=False):
        for i, tick in enumerate(ticks):
            y = self.at(self.x[0], tick)[1]
            self.picture.line(self.left, y, self.left + self.width, y, stroke="#ddd", width=0.8)
            self.picture.text(self.left - 7, y + 4, names[i] if names else shown(tick), anchor="end", size=12)
        if zero:
            y = self.at(self.x[0], 0)[1]
            self.picture.line(self.left, y, self.left + self.width, y, stroke="#555", width=1)
        middle = self.top + self.height / 2
        self.picture.text(self.left - label_gap, middle, label, anchor="middle", turn=-90)

    def frame(self):
        self.picture.rect(self.left, self.top, self.width, self.height, stroke="#555", stroke_width=1)

    def crank(self, last=True, label="crank angle [deg CA], 0 at firing TDC"):
        """Dead centres and strokes of an axis from -360 to 360; angles only below the last of several panels."""
        bottom = self.top + self.height
        for angle in range(-360, 361, 90):
            x = self.at(angle, self.y[0])[0]
            dead = angle % 180 == 0
            self.picture.line(x, self.top, x, bottom, stroke="#999" if dead else "#ddd", width=0.8)
            if last and dead:
                name = f"−{-angle}" if angle < 0 else str(angle)
                self.picture.text(x, bottom + 17, name, anchor="middle", size=12)
        if last:
            for angle, stroke in STROKES:
                self.picture.text(
                    self.at(angle, self.y[0])[0], bottom + 17, stroke, anchor="middle", size=12, colour=GREY
                )
            self.picture.text(self.left + self.width / 2, bottom + 37, label, anchor="middle")

    def curve(self, x, y, style, cut=False):
        """A curve must lie between the ends of the axes; with `cut` what lies beyond them is not drawn."""
        runs, run = [], []
        for a, b in zip(x, y):
            inside = self.x[0] <= a <= self.x[1] and self.y[0] <= b <= self.y[1]
            if not inside and not cut and b == b:
                raise ValueError(f"({a:g}, {b:g}) is beyond the axes {self.x} and {self.y}")
            if inside:
                run.append(self.at(a, b))
            elif run:
                runs.append(run)
                run = []
        for points in [*runs, run]:
            if len(points) > 1:
                self.picture.polyline(points, stroke=style.colour, width=style.width, dashes=style.dashes)

    def band(self, x, low, high, colour, opacity=0.3):
        points = [self.at(a, b) for a, b in zip(x, low)]
        points += [self.at(a, b) for a, b in reversed(list(zip(x, high)))]
        self.picture.polyline(points, close=True, stroke="none", fill=colour, opacity=opacity)

    def points(self, x, y, colour, radius=2.5, hollow=False):
        for a, b in zip(x, y):
            px, py = self.at(a, b)
            self.picture.circle(px, py, radius, fill="white" if hollow else colour, stroke=colour)

    def upright(self, x, style, words="", y=None, anchor="start"):
        """A line at one x over the whole height, with words at its top."""
        px = self.at(x, self.y[0])[0]
        self.picture.line(
            px, self.top, px, self.top + self.height, stroke=style.colour, width=style.width, dashes=style.dashes
        )
        if words:
            shift = 5 if anchor == "start" else -5
            self.picture.text(px + shift, y if y else self.top + 14, words, anchor=anchor, size=12, colour=style.colour)

    def level(self, y, style, words="", anchor="end", above=True):
        """A line at one y over the whole width."""
        px, py = self.at(self.x[0], y)
        self.picture.line(px, py, px + self.width, py, stroke=style.colour, width=style.width, dashes=style.dashes)
        if words:
            x = px + self.width - 5 if anchor == "end" else px + 5
            self.picture.text(x, py - 5 if above else py + 14, words, anchor=anchor, size=12, colour=style.colour)


def shown(tick):
    """A number of an axis."""
    if tick == 0:
        return "0"
    if abs(tick) >= 1e5 or abs(tick) < 1e-3:
        power = math.floor(math.log10(abs(tick)) + 1e-9)
        factor = tick / 10**power
        raised = str(power).replace("-", "−")
        return f"10^{{{raised}}}" if abs(factor - 1) < 1e-9 else f"{factor:g}·10^{{{raised}}}"
    return f"{tick:g}".replace("-", "−")


def decades(low, high):
    return [10.0**power for power in range(low, high + 1)]


def legend(picture, x, y, entries, step=150, sample=34):
    """Samples of curves in one row with their names; `step` is the distance of two, or a list of them."""
    for i, (style, words) in enumerate(entries):
        if isinstance(style, Style):
            picture.line(x, y - 4, x + sample, y - 4, stroke=style.colour, width=style.width + 0.2, dashes=style.dashes)
        else:
            picture.rect(x, y - 10, sample, 11, fill=style, stroke="none")
        picture.text(x + sample + 6, y, words)
        x += step[i] if isinstance(step, (list, tuple)) else step


def from_firing(angles, *curves):
    """Crank angles from -360 to 360 and curves in that order; the first angle is repeated at the end."""
    order = sorted(range(len(angles)), key=lambda i: (angles[i] + 360) % 720)
    turned = [float((angles[i] + 360) % 720 - 360) for i in order]
    rows = [[float(curve[i]) for i in order] for curve in curves]
    return [turned + [turned[0] + 720], *[row + [row[0]] for row in rows]]


def every(n, *rows):
    """Each n-th value, and the last."""
    return [row[:-1:n] + row[-1:] for row in rows]


SYNTHETIC = "SYNTHETIC cylinder pressure"


def mark_synthetic(picture, y=20):
    picture.text(760 - RIGHT, y, SYNTHETIC, anchor="end", size=12, colour="#a00")
