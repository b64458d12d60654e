"""A thin ring in a bore out of round: closed forms, and beam elements (README.md). Prints JSON, SI, degrees."""

import json
from math import cos, degrees, pi, sin

BORE, WIDTH, THICKNESS, E, FORCE = 0.089, 1.2e-3, 3.5e-3, 203e9, 10.68
R = (BORE - THICKNESS) / 2
K = E * WIDTH * THICKNESS**3 / 12 / R**2
N = 4
FACTOR = N**2 - 1
CLOSED = FORCE * R / K / FACTOR**2  # amplitude of order 4 that the ring closes just yet


def root(f, low, high):
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(low) > 0) == (f(middle) > 0) else (low, middle)
    return low


def tip_edge(amplitude, gas=0.0):
    """Where the ring with its gap in a valley, delta = -a cos 4 phi, comes off the wall."""
    return root(lambda x: R * (FORCE + gas) * (1 - cos(x)) - FACTOR * K * amplitude * cos(N * x), 1e-6, pi / 8)


def tip_clearance(amplitude):
    """c = delta - u with u'' + u = (F R/K)(1 - cos phi), c = c' = 0 at the edge."""
    edge = tip_edge(amplitude)
    scale = FORCE * R / K
    # u = scale (1 - phi sin(phi)/2) + C cos(phi) + D sin(phi)
    value = -amplitude * cos(N * edge) - scale * (1 - edge * sin(edge) / 2)
    slope = N * amplitude * sin(N * edge) + scale * (sin(edge) + edge * cos(edge)) / 2
    C = value * cos(edge) - slope * sin(edge)
    return -amplitude - scale - C


def valley_half_length(amplitude):
    """Half of the lift-off about a crest of the bore far from the gap, for an amplitude above CLOSED.

    About the crest w = F (1 - s cos 4x), s = amplitude/CLOSED, and c'''' + 2 c'' + c = -(R/K) w with
    c = c' = c'' = 0 at both ends of an even solution."""
    s = amplitude / CLOSED
    f = R * FORCE / K

    def third_condition(x):
        p = -f * (1 - s * cos(N * x) / FACTOR**2)
        p1 = -f * N * s * sin(N * x) / FACTOR**2
        p2 = -f * N**2 * s * cos(N * x) / FACTOR**2
        # even free solutions cos x and x sin x
        a, b = cos(x), x * sin(x)
        a1, b1 = -sin(x), sin(x) + x * cos(x)
        a2, b2 = -cos(x), 2 * cos(x) - x * sin(x)
        d = a * b1 - b * a1
        A, B = (-p * b1 + b * p1) / d, (-a * p1 + p * a1) / d
        return p2 + A * a2 + B * b2

    return root(third_condition, 0.02, pi / 8)


def gauss():
    a, b = (3 / 7 - 2 / 7 * (6 / 5) ** 0.5) ** 0.5, (3 / 7 + 2 / 7 * (6 / 5) ** 0.5) ** 0.5
    u, v = (18 + 30**0.5) / 72, (18 - 30**0.5) / 72
    return [((1 - b) / 2, v), ((1 - a) / 2, u), ((1 + a) / 2, u), ((1 + b) / 2, v)]


class Beam:
    """Cubic beam elements in u over the ring; nodes may not pass the bore. Shares nothing with the program."""

    def __init__(self, elements, gap, orders, bore):
        self.n, self.start = elements, gap / (2 * R)
        self.h = 2 * (pi - self.start) / elements
        self.bore = bore
        self.moments(orders)
        self.assemble()

    def place(self, i):
        return self.start + i * self.h

    def delta(self, phi):
        return sum(a * cos(n * phi) for n, a in self.bore)

    def moments(self, orders):
        """Moment of the target force at the Gauss points, by integration with Simpson's rule, projected."""
        fine = 8
        count, step = self.n * fine, self.h / fine
        force = lambda phi: FORCE * (1 + sum(a * cos(n * phi) for n, a in orders))
        samples = [(self.start + i * step / 2) for i in range(2 * count + 1)]
        share = lambda i: 1 if i in (0, 2 * count) else 4 if i % 2 else 2
        simpson = lambda f: sum(share(i) * f(x) for i, x in enumerate(samples)) * step / 6
        # all is symmetric about the gap: a cosine alone balances it
        cosine = -simpson(lambda x: force(x) * cos(x)) / simpson(lambda x: cos(x) ** 2)
        w = lambda phi: force(phi) + cosine * cos(phi)
        self.target = []
        c = s = 0.0
        last = self.start
        for i in range(self.n):
            values = []
            for x, _ in gauss():
                phi = self.place(i) + x * self.h
                for y, weight in gauss():
                    at = last + y * (phi - last)
                    c += weight * (phi - last) * w(at) * cos(at)
                    s += weight * (phi - last) * w(at) * sin(at)
                last = phi
                values.append(R * (sin(phi) * c - cos(phi) * s))
            self.target.append(values)

    def shape(self, x):
        """Cubics and their bending u + u'' at the share x of an element."""
        h = self.h
        value = [1 - 3 * x * x + 2 * x**3, h * (x - 2 * x * x + x**3), 3 * x * x - 2 * x**3, h * (x**3 - x * x)]
        second = [(-6 + 12 * x) / h**2, (-4 + 6 * x) / h, (6 - 12 * x) / h**2, (6 * x - 2) / h]
        return value, [a + b for a, b in zip(value, second)]

    def assemble(self):
        size = 2 * (self.n + 1)
        self.band = [[0.0] * 4 for _ in range(size)]  # the diagonal and three below it
        self.load = [0.0] * size
        for i in range(self.n):
            for (x, weight), moment in zip(gauss(), self.target[i]):
                _, bend = self.shape(x)
                for a in range(4):
                    self.load[2 * i + a] += weight * self.h * moment * bend[a]
                    for b in range(a + 1):
                        self.band[2 * i + b][a - b] += weight * self.h * K * bend[a] * bend[b]

    def solved(self, touches):
        """u with the nodes that touch on the bore, by Cholesky's method without roots."""
        size = len(self.load)
        fixed = [i % 2 == 0 and touches[i // 2] for i in range(size)]
        x = [self.delta(self.place(i // 2)) if fixed[i] else self.load[i] for i in range(size)]
        for i in range(size):
            for j in range(1, 4):
                if i + j < size and fixed[i] != fixed[i + j]:
                    free, held = (i + j, i) if fixed[i] else (i, i + j)
                    x[free] -= self.band[i][j] * self.delta(self.place(held // 2))
        rows = []
        for i in range(size):
            row = [1.0, 0.0, 0.0, 0.0] if fixed[i] else list(self.band[i])
            for j in range(1, 4):
                if i + j >= size or fixed[i + j]:
                    row[j] = 0.0
            rows.append(row)
        for i in range(size):
            pivot = rows[i][0]
            factor = [rows[i][j] / pivot for j in range(4)]
            for j in range(1, 4):
                if i + j >= size or rows[i][j] == 0.0:
                    continue
                x[i + j] -= factor[j] * x[i]
                for k in range(j, 4):
                    rows[i + j][k - j] -= factor[j] * rows[i][k]
            x[i] /= pivot
            rows[i] = factor
        for i in reversed(range(size)):
            for j in range(1, 4):
                if i + j < size:
                    x[i] -= rows[i][j] * x[i + j]
        return x

    def forces(self, u):
        all_forces = []
        for i in range(0, len(u), 2):
            inner = self.band[i][0] * u[i]
            for j in range(1, 4):
                if i + j < len(u):
                    inner += self.band[i][j] * u[i + j]
                if i >= j:
                    inner += self.band[i - j][j] * u[i - j]
            all_forces.append((self.load[i] - inner) / R)
        return all_forces

    def solve(self):
        touches = [True] * (self.n + 1)
        for _ in range(500):
            u = self.solved(touches)
            force = self.forces(u)
            clearance = [self.delta(self.place(i)) - u[2 * i] for i in range(self.n + 1)]
            pulled = [i for i in range(self.n + 1) if touches[i] and force[i] < -1e-9 * FORCE * self.h]
            beyond = [i for i in range(self.n + 1) if not touches[i] and clearance[i] < -1e-13]
            if not pulled and not beyond:
                break
            for i in pulled:
                touches[i] = False
            # of each row of nodes beyond the bore the farthest touches
            while beyond:
                run = [beyond.pop(0)]
                while beyond and beyond[0] == run[-1] + 1:
                    run.append(beyond.pop(0))
                touches[min(run, key=lambda i: clearance[i])] = True
        area = 0.0
        for i in range(self.n):
            for x, weight in gauss():
                value, _ = self.shape(x)
                at = sum(v * u[2 * i + a] for a, v in enumerate(value))
                area += weight * self.h * (self.delta(self.place(i) + x * self.h) - at)
        back = self.n // 2  # its end is opposite the gap
        _, bend = self.shape(0.0)
        middle = -K * sum(v * u[2 * back + a] for a, v in enumerate(bend))
        low, high = self.target[back - 1][-1], self.target[back][0]
        return {
            "largest clearance, by beam elements": max(clearance),
            "open area, by beam elements": area * BORE / 2,
            "mean force of the wall, by beam elements": sum(f for f, on in zip(force, touches) if on) / (2 * pi),
            "moment opposite the gap, by beam elements": middle + (low + high) / 2,
        }


below, above = 0.95 * CLOSED, 1.05 * CLOSED
half = degrees(valley_half_length(above))
gas = 1e5 * WIDTH * BORE / 2
expected = {
    "edge of the lifted tip": degrees(tip_edge(1e-6)),
    "edge of the lifted tip, other end": 360 - degrees(tip_edge(1e-6)),
    "clearance of the lifted tip": tip_clearance(1e-6),
    "edge of the lifted tip, gas behind the ring": degrees(tip_edge(1e-6, gas)),
    "contact angle below the order that a ring closes": 360 - 2 * degrees(tip_edge(below)),
    "edge of the lift-off above it": 135 - half,
    "end of the lift-off above it": 135 + half,
    "moment opposite the gap": R * FORCE * 2 - FACTOR * K * 1e-6,
    "mean force in a round bore": FORCE,
    "opening of the free ring": 3 * pi * R * FORCE / K,
}
beam = Beam(720, 0.35e-3, [(2, 0.25)], [(2, 15e-6), (3, 5e-6), (4, 2e-6)])
expected.update(beam.solve())
print(json.dumps(expected, indent=1))
