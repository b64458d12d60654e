"""Parallel pad with one pocket that cavitates at its upstream end: straight lines of pressure (README.md). JSON, SI."""

import json

U, ETA, L, H0, DEPTH = 1.0, 0.01, 0.02, 10e-6, 5e-6
BEGIN, END, AMBIENT = 0.004, 0.012, 1e5
POCKET = H0 + DEPTH

# First land: from ambient down to zero at the pocket's edge, so that oil is sucked in.
flow = U * H0 / 2 + H0**3 * AMBIENT / (12 * ETA * BEGIN)
# Last land: what flows beyond the drag needs this pressure at the pocket's other edge.
p_end = AMBIENT + 12 * ETA * (L - END) * (flow - U * H0 / 2) / H0**3
# In the pocket the film has formed again where a straight line of this slope starts from zero.
slope = 12 * ETA * (U * POCKET / 2 - flow) / POCKET**3
reformation = END - p_end / slope
assert BEGIN < reformation < END
expected = {
    "flow in": flow,
    "flow out": flow,
    "peak pressure": p_end,
    "place of the peak": END,
    "rupture": BEGIN,
    "reformation": reformation,
    "load": AMBIENT * BEGIN / 2 + p_end * (END - reformation) / 2 + (p_end + AMBIENT) * (L - END) / 2,
}
print(json.dumps(expected, indent=1))
