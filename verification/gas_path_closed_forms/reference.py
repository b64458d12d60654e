"""Closed forms of gas through end gaps and side clearances (README.md). Prints JSON, SI."""

import json
import math

R, T, C, P_CRANKCASE = 287.0, 400.0, 0.65, 1e5
CYCLE = 0.08  # s, 720 degrees at 1500 rpm
MM2 = 1e-6


def critical_ratio(g):
    return (2 / (g + 1)) ** (g / (g - 1))


def psi(r, g):
    r = max(r, critical_ratio(g))
    return math.sqrt(max(0.0, 2 * g / (g - 1) * (r ** (2 / g) - r ** ((g + 1) / g))))


def flow(area, up, down, g):
    return C * area * up / math.sqrt(R * T) * psi(down / up, g)


def root(function, low, high):
    """Where a rising function is zero."""
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if function(middle) < 0 else (low, middle)
    return (low + high) / 2


def between_gaps(first, second, g):
    """Pressure between two end gaps in series under 20 bar, steady."""
    return root(lambda p: flow(second, p, P_CRANKCASE, g) - flow(first, 20e5, p, g), 1.0001e5, 19.999e5)


def choked_peak(g=1.33, volume=1e-6, area=0.05 * MM2, high=20e5, share=0.2):
    """p rises by s t, then falls by exp(-k t): periodic."""
    k = C * area * psi(0, g) * math.sqrt(R * T) / volume
    rise, decay = k * high * share * CYCLE, math.exp(-k * (1 - share) * CYCLE)
    lowest = rise * decay / (1 - decay)
    return lowest + rise


def passage_time(low, high, volume, area, up, g):
    """Time from low to high towards the pressure `up` by quadrature of dr/psi, r = 1 - s^2."""
    k = C * area * math.sqrt(R * T) / volume
    begin, end, n = math.sqrt(1 - high / up), math.sqrt(1 - low / up), 20000
    width = (end - begin) / n
    return sum(2 * s / psi(1 - s * s, g) for s in (begin + (i + 0.5) * width for i in range(n))) * width / k


def emptied(p, time, volume, area, low, g):
    """Pressure after `time` of a volume that empties towards `low`, Runge-Kutta of order 4."""
    k = C * area * math.sqrt(R * T) / volume
    n = 4000
    h = time / n

    def slope(q):
        return -k * q * psi(low / q, g)

    for _ in range(n):
        a = slope(p)
        b = slope(p + h / 2 * a)
        c = slope(p + h / 2 * b)
        d = slope(p + h * c)
        p += h / 6 * (a + 2 * b + 2 * c + d)
    return p


def subsonic_peak(g=1.33, volume=0.5e-6, area=0.01 * MM2, high=10e5, low=8e5):
    def too_long(peak):
        lowest = emptied(peak, CYCLE / 2, volume, area, low, g)
        return passage_time(lowest, peak, volume, area, high, g) - CYCLE / 2

    return root(too_long, 8.5e5, 9.95e5)


def channel_peak(volume=0.3e-6, clearance=2e-6, high=20e5, low=10e5, viscosity=2.5e-5):
    """Filling by tanh, emptying by coth, each half a cycle."""
    outer, inner = 0.089 - 2 * 0.2e-3, 0.089 - 2 * 3.5e-3
    length, width = math.pi * (outer + inner) / 2, (outer - inner) / 2
    k = clearance**3 * length / (24 * viscosity * width) / volume
    p = 15e5
    for _ in range(500):
        lowest = low / math.tanh(k * low * CYCLE / 2 + math.atanh(low / p))
        p = high * math.tanh(k * high * CYCLE / 2 + math.atanh(lowest / high))
    return p


expected = {}
for gamma in (1.3, 1.33, 1.4):
    expected[f"critical pressure ratio, gamma {gamma:g}"] = critical_ratio(gamma)
    expected[f"choked end gaps in series, gamma {gamma:g}"] = flow(0.01 * MM2, 20e5, 1e5, gamma) * CYCLE
between = between_gaps(0.01 * MM2, 0.05 * MM2, 1.33)
expected["pressure between choked end gaps"] = between
between = between_gaps(0.05 * MM2, 0.05 * MM2, 1.33)
expected["pressure between a subsonic and a choked end gap"] = between
expected["blow-by of a subsonic and a choked end gap"] = flow(0.05 * MM2, between, P_CRANKCASE, 1.33) * CYCLE
expected["choked filling and emptying"] = choked_peak()
expected["subsonic filling and emptying"] = subsonic_peak()
expected["filling and emptying through a side clearance"] = channel_peak()
print(json.dumps(expected, indent=1))
