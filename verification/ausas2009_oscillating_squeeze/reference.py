"""Oscillating squeeze of parallel plates, the moving front as an ordinary differential equation (README.md).

2 d(theta H)/dt = d/dx(H^3 dp/dx), H = 0.125 cos(4 pi t) + 0.375, p = p0 at x = 0 and 1. Prints JSON, in SI for plates
of 10 mm with 10 um for H = 1, 1 MPa for p = 1 and 1 s for t = 1."""

import json
from math import cos, pi, sin, sqrt

P0 = 0.025
LENGTH, PRESSURE = 0.01, 1e6


def gap(t):
    return 0.375 + 0.125 * cos(4 * pi * t)


def speed(t):
    return -0.5 * pi * sin(4 * pi * t)


def film_length(t):
    """1 - Sigma while the cavity grows: p = (dH/dt) (x - Sigma)^2/H^3 reaches P0 at the edge."""
    return sqrt(P0 * gap(t) ** 3 / speed(t))


def bisected(f, low, high):
    sign = f(low) > 0
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (middle, high) if (f(middle) > 0) == sign else (low, middle)
    return (low + high) / 2


# The film at x = 1/2 ruptures when the growing cavity starts there.
rupture = bisected(lambda t: film_length(t) - 0.5, 0.2500001, 0.28)
low, high = 0.26, 0.40
for _ in range(80):
    a, b = low + (high - low) / 3, high - (high - low) / 3
    low, high = (low, b) if film_length(a) < film_length(b) else (a, high)
turn = (low + high) / 2
largest = 1 - film_length(turn)


def left_behind(sigma):
    """theta H of the oil that the cavity left at sigma when it passed: nothing moves it, as the plates do not slide."""
    return gap(bisected(lambda t: film_length(t) - (1 - sigma), 0.2500001, turn))


def front_speed(t, sigma):
    """2 (H - theta H) dSigma/dt = -H^3 dp/dx at the front, p = 0 there, P0 at the edge, H^3 p'' = 2 dH/dt between."""
    a = 1 - sigma
    flux = gap(t) ** 3 * P0 / a - speed(t) * a
    return -flux / (2 * (gap(t) - left_behind(sigma)))


def start(after):
    """Sigma a little after the turn, where both sides of its balance vanish: Sigma = largest - c after^2."""
    c = 1.0
    for _ in range(80):
        sigma = largest - c * after**2
        c = 0.5 * (c + (-front_speed(turn + after, sigma) / (2 * after)))
    return largest - c * after**2


t = turn + 1e-3
sigma = start(1e-3)
step = 2e-4
while sigma > 0.5:
    k1 = front_speed(t, sigma)
    k2 = front_speed(t + step / 2, sigma + step / 2 * k1)
    k3 = front_speed(t + step / 2, sigma + step / 2 * k2)
    k4 = front_speed(t + step, sigma + step * k3)
    t, before = t + step, sigma
    sigma += step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
    if abs(t - 0.6) <= step / 2:
        front_at_06 = sigma + (0.6 - t) * front_speed(t, sigma)
    if sigma < 0.5 + 1e-3:
        break
full_again = t + (0.5 - sigma) / front_speed(t, sigma)
# Full film: p = P0 - dH/dt x (1 - x)/H^3
load = PRESSURE * LENGTH * (P0 - speed(0.1) / (6 * gap(0.1) ** 3))
expected = {
    "first cavity": rupture,
    "front at t = 0.3 s": LENGTH * (1 - film_length(0.3)),
    "largest front": LENGTH * largest,
    "front at t = 0.315 s, where it turns": LENGTH * start(0.315 - turn),
    "front at t = 0.6 s": LENGTH * front_at_06,
    "full again": full_again,
    "load at t = 0.1 s": load,
    "load at t = 0.1 s, order in time": load,
}
print(json.dumps(expected, indent=1))
