"""Rayleigh's step: two parallel gaps, pressure a straight line in each (README.md). Prints JSON, SI."""

import json
from math import sqrt

U, ETA, RHO, L, H0 = 5.0, 0.02, 850.0, 0.01, 10e-6


def factor(ratio, share):
    """W h0^2/(eta U L^2) for h1/h0 = ratio over the first `share` of the length."""
    return 3 * share * (1 - share) * (ratio - 1) / ((1 - share) * ratio**3 + share)


def peak(ratio, share):
    return 2 * factor(ratio, share) * ETA * U * L / H0**2


# d factor/d share = 0 gives ratio^3 = (share/(1 - share))^2, d factor/d ratio = 0 then ratio = (2 + sqrt(3))/2.
best_ratio = 1 + sqrt(3) / 2
best_share = best_ratio**1.5 / (1 + best_ratio**1.5)
ratio, share = 1.866, 0.7182
scale = ETA * U * L**2 / H0**2
p_step = peak(ratio, share)
# Mass: q = U h0/2 + h0^3 p/(12 eta (1 - share) L), from the outlet land.
flow = RHO * (U * H0 / 2 + H0**3 * p_step / (12 * ETA * (1 - share) * L))
couette = ETA * U * L * (share / (ratio * H0) + (1 - share) / H0)
poiseuille = p_step * (ratio - 1) * H0 / 2  # int h/2 dp/dx over both lands
expected = {
    "load of the best step": factor(ratio, share) * scale,
    "peak pressure": p_step,
    "place of the peak": share * L,
    "friction on the moving side": couette + poiseuille,
    "mass flow": flow,
    "load at h1/h0 = 3, L1/L = 0.4": factor(3.0, 0.4) * scale,
    "h1/h0 of the largest load": best_ratio,
    "L1/L of the largest load": best_share,
}
print(json.dumps(expected, indent=1))
