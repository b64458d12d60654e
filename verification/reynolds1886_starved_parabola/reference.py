"""Starved parabolic film between gas of one pressure, and against gas of 20 bar at its exit (README.md). Prints JSON,
SI."""

import json
from math import atan, cos, sin, sqrt, tan

ETA, SPEED, LENGTH, CROWN, H0, SUPPLY = 0.005, 6.5, 2.4e-3, 45e-6, 1e-6, 0.55e-6
R = (LENGTH / 2) ** 2 / (2 * CROWN)
S = sqrt(2 * R * H0)
K = 2 * SUPPLY / H0  # h*/h0
UNIT = 6 * ETA * SPEED * S / H0**2


def slope(g):
    """Integral of (h - h*)/h^3 over g, x = S tan g, in units of S/h0^2."""
    a = g / 2 + sin(2 * g) / 4
    b = 3 * g / 8 + sin(2 * g) / 4 + sin(4 * g) / 32
    return a - K * b


def film(rise):
    """Ends and load of the film whose pressure rises by `rise` [Pa] from its inlet to its exit."""
    g_2 = atan(sqrt(K - 1))
    low, high = -1.57, -g_2  # the pressure at the exit grows with the length of the film
    for _ in range(200):
        g_1 = (low + high) / 2
        low, high = (g_1, high) if UNIT * (slope(g_2) - slope(g_1)) > rise else (low, g_1)
    moment = [sin(g) ** 2 / 2 + K * cos(g) ** 4 / 4 for g in (g_1, g_2)]  # of the slope of pressure about x = 0
    load = rise * S * tan(g_2) - UNIT * S * (moment[1] - moment[0])
    return LENGTH / 2 + S * tan(g_1), LENGTH / 2 + S * tan(g_2), load


expected = {}
for name, gas in (("equal pressures", 0.0), ("gas of 20 bar at the exit", 20e5)):
    begin, end, load = film(gas)
    expected[f"begin of the film, {name}"] = begin
    expected[f"end of the film, {name}"] = end
    expected[f"load, {name}"] = load + gas * (LENGTH - end)
print(json.dumps(expected, indent=1))
