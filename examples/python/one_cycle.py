"""One engine cycle of one ring: friction, film, a result file and a page. Cylinder pressure: SYNTHETIC."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

case = ringfilm.Case.read(CASES / "styles2014" / "new.toml")
case["operating.speed"] = "2000 rpm"
result = case.run()

print(f"friction mean effective pressure: {result.fmep / 1e3:.2f} kPa")
print(f"mean power loss: {result.mean_power_loss:.1f} W")
film, angle = result.cycle_min_film_thickness, result.min_film_thickness_angle
print(f"minimum film thickness: {1e6 * film:.3f} um at {angle:.0f} degree")
topic, sentence, count = result.notes[0]
print(f"the first of {len(result.notes)} notes: {sentence}")

result.write("one_cycle.nc")
result.write_report("one_cycle.html")
