"""Inclined slider with eta = eta_0 exp(alpha p) through the reduced pressure (README.md). Prints JSON, SI."""

import json
from math import log1p

U, ETA, ALPHA, L, H0, K = 5.0, 0.02, 20e-9, 0.01, 3e-6, 1.2


def gap(x):
    return H0 * (1 + K * (1 - x / L))


def reduced(x):
    """Pressure of the same slider with the viscosity eta_0 all along."""
    thick, thin = H0 * (1 + K), H0
    factor = 6 * ETA * U * L / (thick - thin)
    return factor * (1 / gap(x) - thick * thin / ((thick + thin) * gap(x) ** 2) - 1 / (thick + thin))


def pressure(x):
    """(1 - exp(-alpha p))/alpha = reduced."""
    return -log1p(-ALPHA * reduced(x)) / ALPHA


def simpson(f, a, b, n=20000):
    step = (b - a) / n
    return step / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * step) for i in range(n + 1))


at_peak = 2 * (1 + K) / (2 + K) * H0
place = L * (H0 * (1 + K) - at_peak) / (K * H0)
expected = {
    "load": simpson(pressure, 0, L),
    "peak pressure": pressure(place),
    "place of the peak": place,
    "flow": U * at_peak / 2,
    "order in cells": simpson(pressure, 0, L),
}
print(json.dumps(expected, indent=1))
