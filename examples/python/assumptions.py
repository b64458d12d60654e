"""Assumptions and default inputs of a case, and the effect of other choices: the assumption ledger."""

import pathlib

import ringfilm

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"

case = ringfilm.Case.read(CASES / "ring-pack" / "three_rings.toml")
print(f"ring pack: {len(case.assumptions())} assumptions, {len(case.assumed())} default inputs")

case = ringfilm.Case.read(CASES / "styles2014" / "new.toml")
result = case.run(ledger=True)
print(f"one ring: friction mean effective pressure {result.fmep / 1e3:.1f} kPa")
variants = [variant for entry in result.ledger for variant in entry["variants"] if variant["solved"]]
variants.sort(key=lambda variant: abs(variant["values"]["fmep"] - result.fmep), reverse=True)
for variant in variants[:3]:
    print(f"  {variant['values']['fmep'] / 1e3:.1f} kPa with {variant['setting']}")
