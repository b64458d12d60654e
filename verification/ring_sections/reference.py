"""Sections of rings: closed forms (README.md). Prints JSON, SI."""

import json
from math import pi, sqrt, tan, tanh

BORE, E, FORCE = 0.089, 203e9, 10.7


def rectangle_torsion(a, b, terms=200):
    """St Venant's series for the sides a >= b."""
    series = sum(tanh(n * pi * a / (2 * b)) / n**5 for n in range(1, terms, 2))
    return a * b**3 / 3 * (1 - 192 * b / (pi**5 * a) * series)


class Parts:
    """A section as a sum of rectangles and triangles, each with its own moments about its own centroid."""

    def __init__(self):
        self.parts = []

    def rectangle(self, a, rho, h, t, sign=1):
        self.parts.append((sign * h * t, a + h / 2, rho + t / 2, sign * t * h**3 / 12, sign * h * t**3 / 12, 0))
        return self

    def corner(self, a, rho, h, t, sign=-1):
        """A triangle with its right angle at (a, rho) and the legs h and t, which may point backwards."""
        area = abs(h * t) / 2
        own = abs(h * t)
        self.parts.append(
            (
                sign * area,
                a + h / 3,
                rho + t / 3,
                sign * own * h * h / 36,
                sign * own * t * t / 36,
                -sign * own * h * t / 72,
            )
        )
        return self

    def moments(self):
        area = sum(p[0] for p in self.parts)
        a = sum(p[0] * p[1] for p in self.parts) / area
        rho = sum(p[0] * p[2] for p in self.parts) / area
        axial = sum(p[3] + p[0] * (p[1] - a) ** 2 for p in self.parts)
        radial = sum(p[4] + p[0] * (p[2] - rho) ** 2 for p in self.parts)
        product = sum(p[5] + p[0] * (p[1] - a) * (p[2] - rho) for p in self.parts)
        return area, a, rho, axial, radial, product


def twist(parts):
    """Twist of a ring without a couple out of its plane: strain y kappa - z twist/r."""
    _, _, rho, axial, radial, product = parts.moments()
    r = BORE / 2 - rho
    # E (radial kappa - product twist/r) = FORCE r and product kappa = axial twist/r
    kappa = FORCE * r / E / (radial - product**2 / axial)
    return r * product * kappa / axial


H, T = 1.2e-3, 3.5e-3
BEVEL = Parts().rectangle(0, 0, H, T).corner(0, T, 0.6e-3 * tan(pi / 4), -0.6e-3)
NAPIER = Parts().rectangle(0, 0, 1.5e-3, T).rectangle(1.1e-3, 0, 0.4e-3, 0.5e-3, sign=-1)
FLANK = T * tan(pi * 7.5 / 180)
KEYSTONE = Parts().rectangle(0, 0, 1.5e-3, T).corner(0, T, FLANK, -T).corner(1.5e-3, T, -FLANK, -T)

expected = {
    "torsion constant of a square": rectangle_torsion(2e-3, 2e-3),
    "torsion constant of a rectangle": rectangle_torsion(T, H),
    "torsion constant of an equilateral triangle": sqrt(3) / 80 * 2e-3**4,
    "twist of an inner bevel": twist(BEVEL),
    "couple of an inner bevel": FORCE * BEVEL.moments()[5] / BEVEL.moments()[4],
    "twist of an inner bevel on the other side": -twist(BEVEL),
    "twist of a Napier ring": twist(NAPIER),
}
NAMES = (
    "area",
    "axial centroid",
    "radial centroid",
    "axial second moment",
    "radial second moment",
    "product of inertia",
)
for form, parts in (("an inner bevel", BEVEL), ("a Napier ring", NAPIER), ("a keystone ring", KEYSTONE)):
    for name, value in zip(NAMES, parts.moments()):
        if abs(value) > 1e-20:  # a keystone ring has no product of inertia
            expected[f"{name} of {form}"] = value
print(json.dumps(expected, indent=1))
