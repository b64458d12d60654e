"""`python3 -m ringfilm`: the command line of the program, by the very same code."""

import os
import signal
import sys

from ._ringfilm import _run_program


def main() -> int:
    """Runs the program with the arguments of the command line. Returns the exit code (docs/manual/command-line.md)."""
    # The program is ended by Ctrl-C and by a closed pipe, as it is without Python around it.
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    signal.signal(signal.SIGPIPE, signal.SIG_DFL)
    return _run_program(["ringfilm", *map(os.fsencode, sys.argv[1:])])


if __name__ == "__main__":
    sys.exit(main())
