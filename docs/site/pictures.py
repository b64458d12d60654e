"""Makes the pictures and example pages of the site with the program as it is now.

usage: pictures.py STAGE FOLDER      (`ringfilm` in PATH, its module in PYTHONPATH; FOLDER is copied into the site as
it is)
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]


def run(*words):
    """The output of a command is shown only if it fails."""
    done = subprocess.run(words, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode != 0:
        raise SystemExit(f"docs: {' '.join(words)} failed:\n{done.stdout}")


def main(stage, folder):
    # The pictures of the pages, drawn by the scripts that drew the stored ones.
    figures, drawn = ROOT / "docs" / "figures", stage / "docs" / "figures"
    run(sys.executable, str(figures / "overview.py"), shutil.which("ringfilm"), str(drawn / "overview.svg"))
    run(sys.executable, str(figures / "draw.py"), str(drawn))
    examples = folder / "examples"
    shutil.rmtree(examples, ignore_errors=True)
    examples.mkdir(parents=True)
    with tempfile.TemporaryDirectory() as scratch:
        scratch = pathlib.Path(scratch)
        run("ringfilm", "reproduce", "styles2014", "--output", str(scratch / "paper"))
        shutil.copyfile(next((scratch / "paper").glob("*.html")), examples / "report.html")
        run(
            "ringfilm",
            "study",
            str(ROOT / "cases" / "studies" / "new_ring_uncertainty.toml"),
            "-o",
            str(scratch / "study.nc"),
        )
        shutil.copyfile(scratch / "study.html", examples / "study.html")
        run("ringfilm", "verify", "--output", str(examples / "verification.html"))
    print(f"docs: {len(list(examples.iterdir()))} example pages")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]))
