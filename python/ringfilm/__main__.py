"""`python3 -m ringfilm`: the program `ringfilm` in place of this process."""

import os
import pathlib
import shutil
import signal
import sys


def _program() -> "str | None":
    """Path of the program: inside a wheel, of the same build folder, else in PATH; None if there is none."""
    here = pathlib.Path(__file__).resolve().parent
    for path in (here / "share" / "bin" / "ringfilm", here.parent.parent / "ringfilm"):
        if path.is_file() and os.access(path, os.X_OK):
            return str(path)
    return shutil.which("ringfilm")


def main() -> int:
    """Runs the program with the arguments of the command line. Returns 1 if it is not found, and else not at all."""
    program = _program()
    if program is None:
        print("ringfilm: the program is not installed beside the Python module nor found in PATH", file=sys.stderr)
        return 1
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)  # Python ignores it, and a program inherits that
    os.execv(program, ["ringfilm", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
