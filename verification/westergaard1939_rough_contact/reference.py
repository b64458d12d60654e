"""Contact and flow of surfaces with closed forms (README.md). Prints JSON; all numbers are ratios."""

import json
from math import asin, cos, erf, exp, log, pi, sin, sqrt


def clausen(x, n=20000):
    return sum(sin(k * x) / (k * k) for k in range(1, n))


def plastic_wave(separation, hardness):
    """2 a of the wave whose contact is plastic all over, by bisection."""
    low, high = 0.0, 0.25
    for _ in range(60):
        a = (low + high) / 2
        residual = separation - cos(2 * pi * a) + hardness / pi * clausen(4 * pi * a)
        low, high = (a, high) if residual < 0 else (low, a)
    return 2 * low


def share_at(separation):
    """P of h/D = 1 - P + P ln P."""
    low, high = 1e-12, 1.0
    for _ in range(80):
        p = (low + high) / 2
        low, high = (p, high) if 1 - p + p * log(p) > separation else (low, p)
    return low


def persson_plastic(p, slope, hardness, n=400):
    x, decay = p / hardness, pi * pi * slope * slope / (8 * hardness * hardness)
    plastic, lost = x, 1 - x
    for k in range(1, n):
        term = 2 / (pi * k) * sin(k * pi * x) * exp(-k * k * decay)
        plastic += term if k % 2 == 0 else -term
        lost -= term
    return 1 - plastic - lost, plastic


E = 0.6
A = 0.2
P = share_at(0.4781)
elastic, plastic = persson_plastic(0.05, 1, 1)
expected = {
    "wave, pressure": P,
    "wave, area": 2 / pi * asin(sqrt(P)),
    "wave, peak": 2 * sqrt(P),
    "soft wave, pressure": 0.1 * plastic_wave(0.5, 0.1),
    "soft wave, area": plastic_wave(0.5, 0.1),
    "egg box, first contact": 2 * pi * (3 * sqrt(2) / (32 * pi)) ** (2 / 3),
    "egg box, next to full contact": 3 / (2 * pi),
    "punches, pressure in the centre": 1 / sin(pi * A),
    "punches, sinking": -2 / pi * log(sin(pi * A)),
    "sphere, peak": 1.0,
    "sphere, area": 1.0,
    "soft rough surface, pressure on the contact": 1.0,
    "Persson, elastic": erf(sqrt(2) * 0.1),
    "Persson, elastic share with a hardness": elastic,
    "Persson, plastic share": plastic,
    "gap, across": (1 - E * E) ** 2.5 / (1 + E * E / 2),
    "gap, along": 1 + 1.5 * E * E,
    "gap, sliding": (1 - E * E) / (1 + E * E / 2),
    "gap, stress by pressure": (1 - E * E) / (1 + E * E / 2),
    "rough gap, far from contact": 1.5,
    "rough surface, area at which the flow stops": 0.415,
}
print(json.dumps(expected, indent=1))
