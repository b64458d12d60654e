"""Inclined slider with a compressible oil whose viscosity follows Roelands, by shooting (README.md). Prints JSON, SI.

rho/rho_0 = 1 + a p/(1 + b p), eta = eta_0 exp((ln eta_0 + 9.67)((1 + p/1.98e8)^Z - 1)), and
m = rho (U h/2 - h^3/(12 eta) dp/dx) is the same all along."""

import json
from math import exp, log

U, ETA, RHO, L, H0, K = 5.0, 0.02, 850.0, 0.01, 3e-6, 1.2
ALPHA = 20e-9
Z = ALPHA / (5.1e-9 * (log(ETA) + 9.67))
A, B = 6.0e-10, 1.7e-9


def gap(x):
    return H0 * (1 + K * (1 - x / L))


def density(p):
    return RHO * (1 + A * p / (1 + B * p))


def viscosity(p):
    return ETA * exp((log(ETA) + 9.67) * ((1 + p / 1.98e8) ** Z - 1))


def slope(x, p, m):
    return 12 * viscosity(p) / gap(x) ** 3 * (U * gap(x) / 2 - m / density(p))


def shot(m, n=4000):
    """Runge-Kutta from the left edge: pressure at the right edge, its integral and its peak."""
    p, load, peak, step = 0.0, 0.0, 0.0, L / n
    for i in range(n):
        x = i * step
        k1 = slope(x, p, m)
        k2 = slope(x + step / 2, p + step / 2 * k1, m)
        k3 = slope(x + step / 2, p + step / 2 * k2, m)
        k4 = slope(x + step, p + step * k3, m)
        after = p + step / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        # Hermite's rule for the integral: fourth order, as the steps are
        load += step / 2 * (p + after) + step**2 / 12 * (k1 - slope(x + step, after, m))
        if k1 > 0 >= slope(x + step, after, m):
            fraction = k1 / (k1 - slope(x + step, after, m))
            peak = p + fraction * step * k1 / 2
        p = after
    return p, load, peak


low, high = 0.5 * RHO * U * H0, 1.0 * RHO * U * H0
for _ in range(60):
    m = (low + high) / 2
    low, high = (m, high) if shot(m, 1000)[0] > 0 else (low, m)
end, load, peak = shot(m)
expected = {"load": load, "peak pressure": peak, "mass flow": m, "order in cells": load}
print(json.dumps(expected, indent=1))
