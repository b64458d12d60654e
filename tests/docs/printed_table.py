"""A table of the manual against what the program prints."""

import sys


def check(shown, printed, same, command, table):
    """Ends with the first line, or row, in which the manual differs from what is printed now."""
    for i in range(max(len(shown), len(printed))):
        if i >= min(len(shown), len(printed)) or not same(shown[i], printed[i]):
            print("in the manual:", shown[i] if i < len(shown) else "nothing")
            print("printed now:  ", printed[i] if i < len(printed) else "nothing")
            print(f"the manual is not up to date: {command} > docs/manual/{table} renews it")
            sys.exit(1)
