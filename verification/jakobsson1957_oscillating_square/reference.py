"""Square plates that open and close: what is known in closed form, while the film is full (README.md). JSON, SI."""

import json
from math import cos, cosh, pi, sin, tanh

SIDE, BATH, ETA = 0.01, 1e6, 1 / 6
BETA = 1 - 192 / pi**5 * sum(tanh(n * pi / 2) / n**5 for n in range(1, 200, 2))
MIDDLE = 1.5 * (1 - 32 / pi**3 * sum((-1) ** (n // 2) / (n**3 * cosh(n * pi / 2)) for n in range(1, 40, 2)))


def gap(t):
    return 1e-5 * (0.375 + 0.125 * cos(4 * pi * t))


def opening(t):
    return -1e-5 * 0.5 * pi * sin(4 * pi * t)


def load(t):
    return BATH * SIDE - BETA * ETA * opening(t) * SIDE**3 / gap(t) ** 3


def middle(t):
    return BATH - MIDDLE * ETA * opening(t) * SIDE**2 / gap(t) ** 3


# The plates part from t = 0.25 s on; the pressure in the middle falls and soon is that of cavitation, zero.
begin, end = 0.25, 0.3
for _ in range(60):
    half = 0.5 * (begin + end)
    begin, end = (half, end) if middle(half) > 0 else (begin, half)
expected = {"load at t = 0.1 s, full": load(0.1), "first cavity": begin, "load at t = 0.6 s, full again": load(0.6)}
print(json.dumps(expected, indent=1))
