"""Parallel plates that approach each other: p = p0 + 6 eta V x (L - x)/h^3 (README.md). Prints JSON, SI."""

import json
from math import cos, pi, sin

ETA, L = 0.03, 0.01

# steady approach: 20 um at t = 0, 10 um at t = 10 ms
V = 10e-6 / 10e-3


def load(h, approach):
    return ETA * approach * L**3 / h**3


# oscillating plates under 20 MPa all around, h = 10 + 2 cos(2 pi t/T) um, T = 10 ms
AMBIENT, PERIOD = 20e6, 10e-3


def oscillating(t):
    angle = 2 * pi * t / PERIOD
    return load(10e-6 + 2e-6 * cos(angle), 2e-6 * 2 * pi / PERIOD * sin(angle)) + AMBIENT * L


h = 15e-6
expected = {
    "load at h = 15 um": load(h, V),
    "peak pressure at h = 15 um": 1.5 * ETA * V * L**2 / h**3,
    "flow out on the right at h = 15 um": V * L / 2,
    "flow out on the left at h = 15 um": -V * L / 2,
    "load at h = 10 um": load(10e-6, V),
    "load of oscillating plates, closing": oscillating(2e-3),
    "load of oscillating plates, opening": oscillating(7e-3),
    "order in time, closing": oscillating(2e-3),
    "order in time, opening": oscillating(7e-3),
}
print(json.dumps(expected, indent=1))
