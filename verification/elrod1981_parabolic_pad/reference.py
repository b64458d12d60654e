"""Parabolic pad with rupture, mass-conserving, by quadrature (README.md). Prints JSON, SI."""

import json

U, ETA, RHO, L, THIN, RISE = 4.57, 0.039, 850.0, 0.0762, 25.4e-6, 25.4e-6


def gap(x):
    return THIN + RISE * (2 * x / L - 1) ** 2


def simpson(f, a, b, n=20000):
    step = (b - a) / n
    return step / 3 * sum((1 if i in (0, n) else 4 if i % 2 else 2) * f(a + i * step) for i in range(n + 1))


def slope(x, h_rupture):
    """dp/dx of a film that passes U h_rupture/2."""
    return 6 * ETA * U * (gap(x) - h_rupture) / gap(x) ** 3


low, high = L / 2, L
for _ in range(100):
    rupture = (low + high) / 2
    low, high = (rupture, high) if simpson(lambda x: slope(x, gap(rupture)), 0, rupture, 2000) > 0 else (low, rupture)
h_rupture = gap(rupture)
place = L - rupture  # the gap is symmetric: the other place with dp/dx = 0
peak = simpson(lambda x: slope(x, h_rupture), 0, place)
expected = {
    "rupture": rupture,
    "place of the peak": place,
    "peak pressure": peak,
    # int p dx = -int x dp/dx dx as p vanishes at both ends
    "load": -simpson(lambda x: x * slope(x, h_rupture), 0, rupture),
    "mass flow in": RHO * U * h_rupture / 2,
    "mass flow out": RHO * U * h_rupture / 2,
}
print(json.dumps(expected, indent=1))
