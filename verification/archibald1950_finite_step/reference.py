"""Rayleigh's step with a finite width: closed harmonics across the width (README.md). Prints JSON, SI."""

import json
from math import exp, pi, tanh

U, ETA, L, H1, H0, RHO = 5.0, 0.02, 0.01, 18.66e-6, 10e-6, 850.0
STEP = 7.182e-3
LAST = 200001


def over_sinh(t):
    return 2 * exp(-t) / (1 - exp(-2 * t))


def step(width):
    peak = load = flow_in = flow_out = 0.0
    for n in range(1, LAST + 1, 2):
        k = n * pi / width
        share = 4 / (n * pi) * (-1) ** (n // 2)
        mean = 2 / (n * pi) * (-1) ** (n // 2)
        before, after = k * STEP, k * (L - STEP)
        stiff = k * (H1**3 / tanh(before) + H0**3 / tanh(after)) / (12 * ETA)
        top = U / 2 * (H1 - H0) * share / stiff
        peak += top
        load += mean * width * top * (tanh(before / 2) + tanh(after / 2)) / k
        if before < 500:
            flow_in -= mean * width * H1**3 / (12 * ETA) * k * top * over_sinh(before)
        if after < 500:
            flow_out += mean * width * H0**3 / (12 * ETA) * k * top * over_sinh(after)
    flow_in, flow_out = flow_in + U / 2 * H1 * width, flow_out + U / 2 * H0 * width
    return load, peak, RHO * flow_in, RHO * flow_out


expected = {}
for name, width in (("B/L = 1", 0.01), ("B/L = 2", 0.02)):
    load, peak, flow_in, flow_out = step(width)
    expected[f"{name}, load"] = load / width
    expected[f"{name}, peak pressure"] = peak
    expected[f"{name}, flow in"] = flow_in / width
    expected[f"{name}, flow out"] = flow_out / width
    expected[f"{name}, flow through one side"] = (flow_in - flow_out) / 2
if __name__ == "__main__":
    print(json.dumps(expected, indent=1))
