"""Starved parabolic film between gas of one pressure, against gas of 20 bar at its exit, and with asperity contact
(README.md). Prints JSON, SI."""

import json
from math import atan, cos, erfc, exp, pi, sin, sqrt, tan

ETA, SPEED, LENGTH, CROWN, H0, SUPPLY = 0.005, 6.5, 2.4e-3, 45e-6, 1e-6, 0.55e-6
DENSITY, RADIUS, SIGMA, MODULUS = 0.1e12, 1.5e-6, 0.5e-6, 130e9  # of the asperities
R = (LENGTH / 2) ** 2 / (2 * CROWN)
S = sqrt(2 * R * H0)
UNIT = 6 * ETA * SPEED * S / H0**2


def slope(g, K):
    """Integral of (h - h*)/h^3 over g, x = S tan g, in units of S/h0^2; K = h*/h0."""
    a = g / 2 + sin(2 * g) / 4
    b = 3 * g / 8 + sin(2 * g) / 4 + sin(4 * g) / 32
    return a - K * b


def film(rise, supply=SUPPLY):
    """Ends, load and peak of the film whose pressure rises by `rise` [Pa] from its inlet to its exit."""
    K = 2 * supply / H0
    g_2 = atan(sqrt(K - 1))
    low, high = -1.57, -g_2  # the pressure at the exit grows with the length of the film
    for _ in range(200):
        g_1 = (low + high) / 2
        low, high = (g_1, high) if UNIT * (slope(g_2, K) - slope(g_1, K)) > rise else (low, g_1)
    moment = [sin(g) ** 2 / 2 + K * cos(g) ** 4 / 4 for g in (g_1, g_2)]  # of the slope of pressure about x = 0
    load = rise * S * tan(g_2) - UNIT * S * (moment[1] - moment[0])
    peak = UNIT * (slope(-g_2, K) - slope(g_1, K))
    return LENGTH / 2 + S * tan(g_1), LENGTH / 2 + S * tan(g_2), load, peak


def asperities(h):
    """Load of the asperities on the whole parabola at the smallest gap h."""
    ratio = h / SIGMA
    third = (ratio**2 + 2) * exp(-(ratio**2) / 2) / sqrt(2 * pi) - (ratio**3 + 3 * ratio) * erfc(
        ratio / sqrt(2)
    ) / 2
    pressure = 8 * sqrt(2) / 15 * pi * (DENSITY * RADIUS * SIGMA) ** 2 * sqrt(SIGMA / RADIUS) * MODULUS
    return pressure * sqrt(2 * R * SIGMA) * 5 * pi / 16 * third


expected = {}
for name, gas in (("equal pressures", 0.0), ("gas of 20 bar at the exit", 20e5)):
    begin, end, load, _ = film(gas)
    expected[f"begin of the film, {name}"] = begin
    expected[f"end of the film, {name}"] = end
    expected[f"load, {name}"] = load + gas * (LENGTH - end)
for supply in (0.61, 0.6, 0.575, 0.525, 0.51):
    begin, end, load, peak = film(0.0, supply * H0)
    expected[f"begin of the film, f/h0 = {supply}"] = begin
    expected[f"end of the film, f/h0 = {supply}"] = end
    expected[f"load, f/h0 = {supply}"] = load
    expected[f"peak pressure, f/h0 = {supply}"] = peak
expected["load of the asperities"] = asperities(H0)
expected["load with asperities"] = film(0.0)[2] + asperities(H0)
expected["smallest film under the load with asperities"] = H0
expected["smallest film without enough oil"] = 0.9e-6
print(json.dumps(expected, indent=1))
