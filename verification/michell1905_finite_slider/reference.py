"""Inclined slider of finite width: one ordinary differential equation per harmonic across the width (README.md), each
solved on two grids and extrapolated. Prints JSON, SI."""

import json
from math import pi

U, ETA, L, H_IN, H_OUT, RHO = 5.0, 0.02, 0.01, 20e-6, 10e-6, 850.0
HARMONICS, CELLS = 41, 1600


def harmonic(n, width, cells):
    """p_n at the nodes of equal cells, and the flux of p_n (without drag) through x = 0 and x = L."""
    k, dx = n * pi / width, L / cells
    h = lambda i: H_IN + (H_OUT - H_IN) * i / cells  # noqa: E731
    share = 4 / (n * pi) * (-1) ** (n // 2)
    conductance = [h(i + 0.5) ** 3 / (12 * ETA * dx) for i in range(cells)]
    drag = U / 2 * (H_OUT - H_IN) / cells * share  # of one cell
    along = [h(i) ** 3 / (12 * ETA) * k * k * dx for i in range(cells + 1)]
    # elimination upwards, substitution downwards; p = 0 at both edges
    factor, right = [0.0], [0.0]
    for i in range(1, cells):
        west, east = conductance[i - 1], conductance[i]
        pivot = west + east + along[i] - west * factor[-1]
        factor.append(east / pivot)
        right.append((-drag + west * right[-1]) / pivot)
    p = [0.0] * (cells + 1)
    for i in range(cells - 1, 0, -1):
        p[i] = right[i] + factor[i] * p[i + 1]
    flux_in = -conductance[0] * p[1] + drag / 2  # the half cell at the edge keeps its balance
    flux_out = conductance[-1] * p[-2] - drag / 2
    return p, flux_in, flux_out


def slider(width, cells):
    """Load [N], peak pressure [Pa] and its place [m], mass flows in, out and through both sides [kg/s]."""
    middle, load, flow_in, flow_out = [0.0] * (cells + 1), 0.0, 0.0, 0.0
    for n in range(1, 2 * HARMONICS, 2):
        p, first, last = harmonic(n, width, cells)
        sign = (-1) ** (n // 2)
        mean = 2 / (n * pi) * sign  # of cos(n pi y/B) over the width
        load += mean * width * sum(p) * L / cells
        flow_in, flow_out = flow_in + mean * width * first, flow_out + mean * width * last
        for i, value in enumerate(p):
            middle[i] += value
        at_edges = mean * width * first, mean * width * last
    # what is omitted falls with the third power of n
    rest = n**3 / (4 * (n + 1) ** 2)
    flow_in, flow_out = flow_in + at_edges[0] * rest, flow_out + at_edges[1] * rest
    top = max(range(cells + 1), key=middle.__getitem__)
    below, at, above = middle[top - 1 : top + 2]
    shift = 0.5 * (below - above) / (below - 2 * at + above)
    peak = at - 0.25 * (below - above) * shift
    flow_in, flow_out = U / 2 * H_IN * width + flow_in, U / 2 * H_OUT * width + flow_out
    return load, peak, (top + shift) * L / cells, RHO * flow_in, RHO * flow_out, RHO * (flow_in - flow_out)


def finite(width):
    coarse, fine = slider(width, CELLS // 2), slider(width, CELLS)
    return [f + (f - c) / 3 for c, f in zip(coarse, fine)]


def narrow(width):
    """The limit of ever narrower pads: a parabola across at every x."""
    a, b = H_IN, H_OUT
    return U * ETA * width**3 / 2 * (1 / b**2 - 1 / a**2) / 2  # = -(eta U B^3/2) int h'/h^3 dx


expected = {}
for name, width in (("B/L = 2", 0.02), ("B/L = 1", 0.01), ("B/L = 0.5", 0.005)):
    load, peak, place, flow_in, flow_out, sides = finite(width)
    expected[f"{name}, load"] = load / width
    expected[f"{name}, peak pressure"] = peak
    expected[f"{name}, flow in"] = flow_in / width
    expected[f"{name}, flow out"] = flow_out / width
    expected[f"{name}, flow through one side"] = sides / 2
    if width == L:
        expected[f"{name}, place of the peak"] = place
load, peak, *_ = finite(0.0005)
expected["B/L = 0.05, load"] = load / 0.0005
expected["B/L = 0.01, limit of narrow pads"] = narrow(0.0001) / 0.0001
expected["B/L = 1, order in cells"] = expected["B/L = 1, load"]
if __name__ == "__main__":
    print(json.dumps(expected, indent=1))
