"""Viscosity and film of a slider from its measured load and friction. The measurement is SYNTHETIC."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

fit = ringfilm.fit(CASES / "inverse" / "fit_slider.toml")
viscosity, film = fit["parameters"]

print("values with their 95 % intervals; the measurement was made with 13 mPa s and 12 um")
print(f"viscosity {1e3 * viscosity['value']:.2f} mPa s ({1e3 * viscosity['low']:.2f} to {1e3 * viscosity['high']:.2f})")
print(f"film thickness {1e6 * film['value']:.2f} um ({1e6 * film['low']:.2f} to {1e6 * film['high']:.2f})")
