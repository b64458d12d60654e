"""Flow between parallel plates, driven by a pressure difference and by the moving one (README.md). Prints JSON, SI."""

import json

U, ETA, L, H, P_LEFT, P_RIGHT = 2.0, 0.03, 0.02, 15e-6, 3e6, 0.5e6

by_pressure = H**3 * (P_LEFT - P_RIGHT) / (12 * ETA * L)
couette = ETA * U * L / H
poiseuille = H / 2 * (P_RIGHT - P_LEFT)
expected = {
    "load, driven along": (P_LEFT + P_RIGHT) / 2 * L,
    "flow, driven along": U * H / 2 + by_pressure,
    "friction on the moving side, driven along": couette + poiseuille,
    "friction on the fixed side, driven along": couette - poiseuille,
    "flow, driven against": -U * H / 2 + by_pressure,
    "friction on the moving side, driven against": couette - poiseuille,
    "flow of pressure alone": by_pressure,
}
print(json.dumps(expected, indent=1))
