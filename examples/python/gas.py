"""Blow-by and pressures between the rings of a pack for two end gaps. Rings: ASSUMED, cylinder pressure: SYNTHETIC."""

import pathlib

import ringfilm

PACK = pathlib.Path(__file__).resolve().parents[2] / "cases" / "ring-pack" / "two_rings.toml"

for end_gap in ("0.25 mm", "0.5 mm"):
    gas = ringfilm.gas_path(PACK, {"ring.1.end_gap": end_gap})
    angle, pressure = gas["curves"]["crank_angle"], gas["curves"]["pressure"]["land 2"]
    print(f"end gap of the top ring {end_gap}: blow-by {60e3 * gas['blow_by_flow']:.2f} l/min per cylinder")
    print(f"  peak pressure below it {1e-5 * pressure.max():.2f} bar at {angle[pressure.argmax()]:.0f} degree")
