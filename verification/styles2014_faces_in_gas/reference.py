"""Steady films with menisci on the ring faces of styles2014, by quadrature (README.md). Prints JSON, SI."""

import json
from math import exp, log, pi, sqrt

ETA, SPEED, LENGTH, MODULUS = 5.06e-3, 6.5, 1.2e-3, 134.8e9
CELLS = 6000  # of the quadrature

FACES = {  # coefficients in um and mm, highest power first; N [1/m2], beta, sigma [m]
    "new": ([427.9, -1455.8, 1971.4, -1354.4, 544.57, -150.49, 25.3], (0.097e12, 1.56e-6, 0.48e-6)),
    "embedded": ([-6.493, -49.845, 143.22, -98.541, 27.351, -17.338, 7.4986], (0.101e12, 1.82e-6, 0.35e-6)),
}


def bisect(f, low, high):
    """Where f changes its sign."""
    sign = f(low) > 0
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) > 0) == sign else (low, middle)
    return (low + high) / 2


def simpson(f, a, b, n=CELLS):
    step = (b - a) / n
    return step / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * step) for i in range(n + 1))


class Face:
    def __init__(self, name, runs_left):
        self.coefficients, self.asperities = FACES[name]
        self.runs_left = runs_left
        self.lowest = 0.0
        places = [LENGTH * i / 1000 for i in range(1001)]
        near = min(places, key=self.gap)
        step = LENGTH / 1000
        self.throat = bisect(lambda x: self.gap(x + 1e-9) - self.gap(x - 1e-9), near - step, near + step)
        self.lowest = self.gap(self.throat)

    def gap(self, x):
        """Above the lowest place; x from the inlet."""
        x = LENGTH - x if self.runs_left else x
        height = 0.0
        for c in self.coefficients:
            height = height * x * 1e3 + c
        return height * 1e-6 - self.lowest

    def load_of_asperities(self, h_m):
        density, radius, sigma = self.asperities
        scale = 8 * sqrt(2) / 15 * pi * (density * radius * sigma) ** 2 * sqrt(sigma / radius) * MODULUS
        table = [integral(0.02 * i) for i in range(401)]  # beyond 8 sigma nothing touches

        def share(x):
            at = (h_m + self.gap(x)) / sigma / 0.02
            i = min(int(at), 398)
            if at >= 400:
                return 0.0
            # The logarithm is all but a parabola.
            a, b, c = table[i : i + 3]
            part = at - i
            return exp(a[1] * (part - 1) * (part - 2) / 2 - b[1] * part * (part - 2) + c[1] * part * (part - 1) / 2)

        return scale * simpson(share, 0, LENGTH, 4000)


def integral(ratio):
    """F_5/2 of Greenwood and Tripp, and its logarithm."""
    # With s = ratio + t^2 the root is gone.
    value = simpson(lambda t: 2 * t**6 * exp(-((ratio + t * t) ** 2) / 2), 0, 3.4, 400) / sqrt(2 * pi)
    return value, log(value)


def film(face, h_m, supply, p_in, p_out):
    """Ends and load of the film; a supply of None floods the inlet at the edge."""
    h = lambda x: h_m + face.gap(x)
    rise = lambda a, b, h_star: 6 * ETA * SPEED * simpson(lambda x: (h(x) - h_star) / h(x) ** 3, a, b)
    crossing = lambda h_star, low, high: bisect(lambda x: h(x) - h_star, low, high)
    exit_at = lambda h_star: crossing(h_star, face.throat, LENGTH)
    if supply is None:
        begin = 0.0
        h_star = bisect(lambda q: rise(0, exit_at(q), q) - (p_out - p_in), 1.000001 * h_m, min(h(LENGTH), 2 * h_m))
    else:
        h_star = 2 * supply
        inner = crossing(h_star, 0, face.throat)
        begin = bisect(lambda x: rise(x, exit_at(h_star), h_star) - (p_out - p_in), 0, inner)
    end = exit_at(h_star)
    # By parts: the pressure at the exit times its place, less the moment of the slope.
    moment = 6 * ETA * SPEED * simpson(lambda x: x * (h(x) - h_star) / h(x) ** 3, begin, end)
    pressures = p_out * end - p_in * begin - moment
    return begin, end, p_in * begin + pressures + p_out * (LENGTH - end)


CASES = {  # face, does the surface run left, smallest film, film that comes in, pressures at inlet and exit, asperities
    "new, starved": ("new", False, 1.7e-6, 1e-6, 1e5, 1e5, False),
    "new, starved, with asperities": ("new", False, 1.7e-6, 1e-6, 1e5, 1e5, True),
    "new, against gas, with asperities": ("new", False, 0.9e-6, None, 1e5, 20e5, True),
    "embedded, starved, against gas": ("embedded", False, 1.2e-6, 0.7e-6, 1e5, 20e5, False),
    "embedded, starved, against gas, with asperities": ("embedded", False, 1.2e-6, 0.7e-6, 1e5, 20e5, True),
    "embedded, starved, running left, with asperities": ("embedded", True, 1e-6, 0.6e-6, 1e5, 1e5, True),
}


def solved(name):
    """Left and right end of the film, load of the asperities, whole load."""
    face_name, runs_left, h_m, supply, p_in, p_out, touches = CASES[name]
    face = Face(face_name, runs_left)
    begin, end, load = film(face, h_m, supply, p_in, p_out)
    asperities = face.load_of_asperities(h_m) if touches else 0.0
    left, right = (LENGTH - end, LENGTH - begin) if runs_left else (begin, end)
    return left, right, asperities, load + asperities


if __name__ == "__main__":
    expected = {}
    for name, (_, _, h_m, supply, _, _, touches) in CASES.items():
        left, right, asperities, load = solved(name)
        expected[f"{name}: smallest film"] = h_m
        expected[f"{name}: load"] = load
        if left > 0:
            expected[f"{name}: left end"] = left
        expected[f"{name}: right end"] = right
        if touches:
            expected[f"{name}: load of the asperities"] = asperities
    print(json.dumps(expected, indent=1))
