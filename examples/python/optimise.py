"""The step of a pad that carries the highest load, next to the solution of Rayleigh (1918)."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

best = ringfilm.optimise(CASES / "inverse" / "rayleigh_step.toml")["best"]
depth, width = (best["variables"][f"pad.grooves.{key}"] for key in ("depth", "width"))

print(f"load {best['quantities']['load'] / 1e3:.2f} kN/m (Rayleigh: 20.63 kN/m)")
print(f"step {1e6 * depth:.2f} um high (8.66 um), {1e3 * width / 2:.2f} mm from the inlet (7.18 mm)")
