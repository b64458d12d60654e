"""Dry wear of a flat, a parabola, a roof and a wave (README.md). Prints JSON, SI."""

import json
from math import exp, pi, sqrt

K, LOAD, WIDTH = 1e-17, 2000.0, 1.2e-3


def area(sliding):
    return K * LOAD * sliding


def parabola(radius, sliding):
    a = (1.5 * radius * area(sliding)) ** (1 / 3)
    return a * a / (2 * radius)


def roof(slope, sliding):
    return sqrt(slope * area(sliding))


def gaussian_integral(power, ratio, n=20000, reach=12.0):
    """Simpson's rule for 1/sqrt(2 pi) int (s - ratio)^power exp(-s^2/2) ds, with s - ratio = u^2."""
    top = sqrt(reach)
    step = top / n
    total = 0.0
    for i in range(n + 1):
        u = i * step
        s = ratio + u * u
        weight = 1 if i in (0, n) else 4 if i % 2 else 2
        total += weight * 2 * u ** (2 * power + 1) * exp(-s * s / 2)
    return total * step / 3 / sqrt(2 * pi)


def pressure_and_slope(h, sigma):
    scale = 8 * sqrt(2) / 15 * pi * 0.07**2 * sqrt(1 / 3) * 130e9
    return scale * gaussian_integral(2.5, h / sigma), -2.5 * scale / sigma * gaussian_integral(1.5, h / sigma)


def wave_left(sigma, sliding):
    h = 2 * sigma
    for _ in range(60):
        p, slope = pressure_and_slope(h, sigma)
        step = (LOAD / WIDTH - p) / slope
        h += step
        if abs(step) < 1e-14 * sigma:
            break
    return exp(-K * abs(pressure_and_slope(h, sigma)[1]) * sliding)


expected = {
    "flat, depth": area(1e5) / WIDTH,
    "parabola, worn area": area(8e4),
    "parabola, depth": parabola(0.02, 8e4),
    "parabola, exponent of the sliding length": 2 / 3,
    "roof, depth": roof(0.01, 8e4),
    "wave, amplitude left": wave_left(0.5e-6, 2e4),
}
print(json.dumps(expected, indent=1))
