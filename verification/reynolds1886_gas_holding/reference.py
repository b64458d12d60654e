"""Gas that a parabolic film with a flooded inlet holds at its exit (README.md). Prints JSON, SI."""

import json
from math import atan, pi, sin, sqrt

ETA, SPEED, LENGTH, CROWN, H0 = 0.005, 6.5, 4.8e-3, 180e-6, 1e-6
R = (LENGTH / 2) ** 2 / (2 * CROWN)
S = sqrt(2 * R * H0)
UNIT = 6 * ETA * SPEED * S / H0**2
LIMIT = 3 * pi / 4 * sqrt(2) * ETA * SPEED / 2 * sqrt(R) * H0**-1.5  # of an endless parabola


def slope(g, K):
    """Integral of (h - h*)/h^3 over g, x = S tan g, in units of S/h0^2; K = h*/h0."""
    return g / 2 + sin(2 * g) / 4 - K * (3 * g / 8 + sin(2 * g) / 4 + sin(4 * g) / 32)


G_1 = -atan(LENGTH / 2 / S)


def rise(K):
    """Pressure at the exit, where the gap is h* without a slope of pressure, above that at the edge of the inlet."""
    return UNIT * (slope(atan(sqrt(K - 1)), K) - slope(G_1, K))


def end(held):
    low, high = 1.0, 2.0  # the longer the film, the less it holds
    for _ in range(200):
        K = (low + high) / 2
        low, high = (K, high) if rise(K) > held else (low, K)
    return LENGTH / 2 + S * sqrt(K - 1), K * H0 / 2


assert abs(rise(1.0) / LIMIT - 1) < 1e-3  # the inlet of the pad is nearly endless
expected = {}
for share in (0.5, 0.9):
    (
        expected[f"end of the film against {share} of the limit"],
        expected[f"film left behind, {share} of the limit"],
    ) = end(share * LIMIT)
print(json.dumps(expected, indent=1))
