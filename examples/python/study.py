"""Uncertainty of friction from two inputs of a ring, and the share of each. The scatter of both is ASSUMED."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
PLAN = f"""
kind = "uncertainty"
base = [{{ name = "new", case = "{CASES.as_posix()}/styles2014/new.toml" }}]
plan = {{ method = "sobol", scenarios = 32, indices = "first-and-total" }}
[[factor]]
key = "contact.boundary_shear_strength_coefficient"
how = "scale"
range = [0.9, 1.1]
[[factor]]
key = "contact.roughness"
how = "scale"
range = [0.95, 1.05]
"""

pathlib.Path("study.toml").write_text(PLAN)
result = ringfilm.Study.read("study.toml").run()

fmep = result.statistics("fmep")
print(f"{fmep['count']} points: {fmep['mean'] / 1e3:.1f} kPa, standard deviation {fmep['deviation'] / 1e3:.1f} kPa")
for index in result.sobol_indices("fmep"):
    low, high = index["total_interval"]
    print(f"{index['factor']}: total index {index['total']:.2f} ({low:.2f} to {high:.2f})")
