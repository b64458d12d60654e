#!/usr/bin/env python3
"""What it costs to call from Python: import, one case, a batch; each beside the same work in C++.

usage: PYTHONPATH=build-ci/python benchmarks/python_speed.py [--cases N] [--threads N] [--program
    build-ci/benchmarks/case_speed]

The C++ side is `case_speed`, which runs the same cases by the same calls of the library; both sides take the best of
several turns, one after the other, so that another load on the machine meets both.
"""

import argparse
import pathlib
import subprocess
import sys
import time

SOURCES = pathlib.Path(__file__).resolve().parent.parent
CASE = SOURCES / "cases" / "styles2014" / "new.toml"


def seconds_of_import():
    script = "import time; a = time.perf_counter(); import ringfilm; print(time.perf_counter() - a)"
    return min(float(subprocess.check_output([sys.executable, "-c", script])) for _ in range(5))


def speeds(case, n):
    import ringfilm

    for i in range(n):
        one = case.copy()
        one["operating.speed"] = ringfilm.SI(150.0 + 100.0 * i / n)
        yield one


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    arguments.add_argument("--cases", type=int, default=1000)
    arguments.add_argument("--threads", type=int, default=2)
    arguments.add_argument("--turns", type=int, default=5)
    arguments.add_argument("--program", default=str(SOURCES / "build-ci" / "benchmarks" / "case_speed"))
    chosen = arguments.parse_args()
    print(f"import: {seconds_of_import():.3f} s (requested: below 0.3)")

    import ringfilm

    case = ringfilm.Case.read(CASE)

    def native(what, *words):
        return float(subprocess.check_output([chosen.program, what, str(CASE), *map(str, words)]))

    def reported(name, own, other):
        print(
            f"{name}: {own:.4f} s from Python, {other:.4f} s in C++, "
            f"{100 * (own / other - 1):+.1f} % (requested: below +5 %)"
        )

    runs = 20
    own, other = [], []
    for _ in range(chosen.turns):
        other.append(native("run", runs))
        begin = time.perf_counter()
        for _ in range(runs):
            case.run()
        own.append((time.perf_counter() - begin) / runs)
    reported("one case", min(own), min(other))

    own, other = [], []
    for _ in range(min(chosen.turns, 3)):
        other.append(native("batch", chosen.cases, chosen.threads))
        begin = time.perf_counter()
        ringfilm.simulate_many(speeds(case, chosen.cases), threads=chosen.threads, curves="none")
        own.append(time.perf_counter() - begin)
    reported(f"{chosen.cases} cases on {chosen.threads} threads", min(own), min(other))


if __name__ == "__main__":
    main()
