#!/usr/bin/env python3
"""Draws docs/figures/overview.svg, the rings of styles2014, from the shipped cases.

usage: docs/figures/overview.py [path of the program, default build/ringfilm [file to write]]
"""
import csv
import pathlib
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parent.parent
# Distinguishable by colour-blind readers and in grey print (Okabe and Ito), and by their dashes.
RINGS = [("new", "#0072B2", ""), ("run-in", "#E69F00", "7 3"), ("embedded", "#000000", "2 3")]
WIDTH, LEFT, RIGHT, PANEL, GAP, TOP = 860, 66, 16, 190, 30, 52


def curves(program):
    """Crank angle from -360 to 360 and the columns of each ring."""
    found = {}
    with tempfile.TemporaryDirectory() as folder:
        for ring, _, _ in RINGS:
            table = pathlib.Path(folder) / f"{ring}.csv"
            case = ROOT / "cases" / "styles2014" / f"{ring}.toml"
            subprocess.run([program, "run", case, "--csv", table], check=True, stdout=subprocess.DEVNULL)
            with open(table, newline="") as file:
                rows = [{k.split(" [")[0]: float(v) for k, v in row.items() if v} for row in csv.DictReader(file)]
            for row in rows:
                row["angle"] = (row["crank_angle"] + 360) % 720 - 360
            found[ring] = sorted(rows, key=lambda row: row["angle"])
    return found


def x_of(angle):
    return LEFT + (angle + 360) / 720 * (WIDTH - LEFT - RIGHT)


def panel(rings, top, title, quantity, scale, highest, tick):
    def y_of(value):
        return top + PANEL * (1 - value / highest)

    out = [f'<text x="{LEFT}" y="{top - 8}" class="title">{title}</text>']
    value = 0
    while value <= highest:
        y = y_of(value)
        out.append(f'<path class="grid" d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}"/>')
        out.append(f'<text x="{LEFT - 7}" y="{y + 4:.1f}" class="y">{value:g}</text>')
        value += tick
    for angle in range(-360, 361, 90):
        kind = "dead" if angle % 180 == 0 else "grid"
        out.append(f'<path class="{kind}" d="M{x_of(angle):.1f} {top}V{top + PANEL}"/>')
    for ring, colour, dashes in RINGS:
        points = " ".join(f"{x_of(row['angle']):.1f},{y_of(row[quantity] * scale):.1f}" for row in rings[ring])
        out.append(
            f'<polyline fill="none" stroke="{colour}" stroke-width="1.7" stroke-dasharray="{dashes}" '
            f'points="{points}"/>'
        )
    return out


def drawing(rings):
    second = TOP + PANEL + GAP
    height = second + PANEL + 50
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height}" '
        'font-family="sans-serif" font-size="12">',
        "<title>Minimum film thickness and total friction of three rings over one engine cycle</title>",
        "<style>.grid{stroke:#ddd}.dead{stroke:#999}.title{font-weight:bold}"
        ".y{text-anchor:end}.x{text-anchor:middle}</style>",
        f'<rect width="{WIDTH}" height="{height}" fill="white"/>',
    ]
    for k, (ring, colour, dashes) in enumerate(RINGS):
        x = LEFT + 120 * k
        out.append(f'<path d="M{x} 14h34" stroke="{colour}" stroke-width="2" stroke-dasharray="{dashes}"/>')
        out.append(f'<text x="{x + 40}" y="18">{ring} ring</text>')
    out.append(f'<text x="{WIDTH - RIGHT}" y="18" class="y" fill="#a00">SYNTHETIC cylinder pressure</text>')
    out += panel(rings, TOP, "minimum film thickness [µm]", "min_film_thickness", 1e6, 4, 1)
    out += panel(rings, second, "total friction [N]", "total_friction", 1, 400, 100)
    bottom = second + PANEL
    for angle in range(-360, 361, 180):
        out.append(f'<text x="{x_of(angle):.1f}" y="{bottom + 17}" class="x">{angle}</text>')
    for angle, stroke in ((-270, "intake"), (-90, "compression"), (90, "power"), (270, "exhaust")):
        out.append(f'<text x="{x_of(angle):.1f}" y="{bottom + 17}" class="x" fill="#666">{stroke}</text>')
    out.append(f'<text x="{x_of(0):.1f}" y="{bottom + 38}" class="x">crank angle [deg CA], 0 at firing TDC</text>')
    return "\n".join(out + ["</svg>", ""])


if __name__ == "__main__":
    program = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "ringfilm").resolve()
    picture = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else HERE / "overview.svg"
    picture.write_text(drawing(curves(program)), encoding="utf-8")
