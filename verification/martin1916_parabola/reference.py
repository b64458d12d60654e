"""Parabolic gap h = h0 + x^2/(2R), exit where pressure and its slope vanish (README.md). Prints JSON, SI."""

import json
from math import atan, cos, sin, sqrt

ETA, SPEED, R, H0 = 0.01, 6.0, 0.05, 2e-6
INLET = 12.0  # distance from the inlet to the thinnest place, in sqrt(2 R h0)
S = sqrt(2 * R * H0)


def integral_2(a):
    """int cos^2 = int dX/(1 + X^2)^2 with X = tan a."""
    return a / 2 + sin(2 * a) / 4


def integral_3(a):
    """int cos^4 = int dX/(1 + X^2)^3."""
    return 3 * a / 8 + sin(2 * a) / 4 + sin(4 * a) / 32


A_IN = -atan(INLET)


def pressure(a, a_exit):
    """With X = x/S, H = 1 + X^2: dP/dX = (H - H_exit)/H^3, P = p h0^2/(6 eta U S)."""
    h_exit = 1 / cos(a_exit) ** 2
    return integral_2(a) - integral_2(A_IN) - h_exit * (integral_3(a) - integral_3(A_IN))


low, high = 0.0, 1.0
for _ in range(200):
    middle = (low + high) / 2
    low, high = (middle, high) if pressure(middle, middle) > 0 else (low, middle)
exit_angle = (low + high) / 2


def simpson(f, a, b, n):
    step = (b - a) / n
    return step / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * step) for i in range(n + 1))


unit = 6 * ETA * SPEED * S / H0**2
load = unit * S * simpson(lambda a: pressure(a, exit_angle) / cos(a) ** 2, A_IN, exit_angle, 200000)
exit_place = sin(exit_angle) / cos(exit_angle)
expected = {
    "load": load,
    "peak pressure": unit * pressure(-exit_angle, exit_angle),
    "place of the peak": S * (INLET - exit_place),
    "rupture": S * (INLET + exit_place),
}
print(json.dumps(expected, indent=1))
