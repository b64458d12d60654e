"""The wheel: unpacked somewhere else, it is module, program and shipped data."""

import os
import pathlib
import subprocess
import sys
import zipfile

import pytest

SOURCES = pathlib.Path(__file__).resolve().parents[2]


@pytest.fixture(scope="module")
def unpacked(tmp_path_factory):
    """Packed of the module as it is built, and unpacked as pip does."""
    folder = tmp_path_factory.mktemp("wheel")
    subprocess.run(
        [sys.executable, "-m", "build", "--wheel", "--no-isolation", "--outdir", folder, SOURCES],
        check=True,
        stdout=subprocess.DEVNULL,
    )
    (wheel,) = folder.glob("ringfilm-*.whl")
    assert f"cp{sys.version_info.major}{sys.version_info.minor}" in wheel.name
    with zipfile.ZipFile(wheel) as packed:
        packed.extractall(folder / "site")
        for info in packed.infolist():  # pip sets the mode, zipfile does not
            if info.external_attr >> 16 & 0o111:
                (folder / "site" / info.filename).chmod(0o755)
    return folder / "site"


def python(site, *words, folder):
    """What Python prints with the wheel, but without checkout and build."""
    environment = {name: value for name, value in os.environ.items() if name not in ("RINGFILM_DATA", "PYTHONPATH")}
    done = subprocess.run(
        [sys.executable, *words],
        env={**environment, "PYTHONPATH": str(site)},
        cwd=folder,
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_program_finds_its_data(unpacked, tmp_path):
    python(unpacked, "-m", "ringfilm", "new", "my.toml", folder=tmp_path)
    assert "no errors" in python(unpacked, "-m", "ringfilm", "check", "my.toml", folder=tmp_path)
    case = unpacked / "ringfilm" / "share" / "cases" / "styles2014" / "new.toml"
    assert "no errors" in python(unpacked, "-m", "ringfilm", "check", str(case), folder=tmp_path)


def test_the_module_runs_a_case(unpacked, tmp_path):
    (tmp_path / "my.py").write_text(
        f"""
import pathlib, ringfilm
assert ringfilm.__file__.startswith({str(unpacked)!r})
pathlib.Path("my.toml").write_text(ringfilm.starting_case())
print(ringfilm.Case.read("my.toml").run().values["fmep"])
"""
    )
    assert float(python(unpacked, "my.py", folder=tmp_path)) > 0


def test_what_types_need_is_in_it(unpacked):
    package = unpacked / "ringfilm"
    assert (package / "py.typed").is_file()
    assert list(package.rglob("*.pyi"))
    (information,) = unpacked.glob("ringfilm-*.dist-info")
    assert "Requires-Dist: numpy" in (information / "METADATA").read_text()
