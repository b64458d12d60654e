"""The exceptions of ringfilm, with the same text as the program prints."""

from typing import NamedTuple, Optional

__all__ = ["ConvergenceError", "Fault", "InputError", "OutputError", "UnknownKeyError"]


class Fault(NamedTuple):
    """One thing that is wrong with the input: where, what rule was broken with which value, what to write instead.

    `line` and `column` count from 1; 0 means the file as a whole. `file` is empty where the fault is not in a file.
    """

    file: str
    line: int
    column: int
    line_text: str
    message: str
    remedy: str


Fault.file.__doc__ = 'As the user named it; "--set" for the command line, empty where the fault is not in a file.'
Fault.line.__doc__ = "Counted from 1; 0: the file as a whole."
Fault.column.__doc__ = "Of the first character at fault, counted from 1; 0: the whole line."
Fault.line_text.__doc__ = "The line itself, without its end; empty if it is not known."
Fault.message.__doc__ = "What was found, and the rule that it breaks."
Fault.remedy.__doc__ = "What to write instead; may be empty."


class InputError(ValueError):
    """The input cannot be used (exit code 2 of the program). `faults` holds every fault that was found."""

    def __new__(cls, text: str, faults: list = ()):
        return super().__new__(cls, text, list(faults))

    def __init__(self, text: str, faults: list = ()):
        super().__init__(text, list(faults))

    @property
    def faults(self) -> list:
        """Every fault, a list of Fault."""
        return self.args[1]

    def __str__(self) -> str:
        """The text that the program prints."""
        return self.args[0]


class UnknownKeyError(InputError, KeyError):
    """Nothing has that name: no key of a case, no value of a cycle in a study."""


class ConvergenceError(ArithmeticError):
    """No film was found that balances what acts on it, all remedies spent (exit code 3 of the program)."""

    def __new__(cls, text: str, crank_angle: Optional[float] = None, result: object = None):
        return super().__new__(cls, text, crank_angle, result)

    def __init__(self, text: str, crank_angle: Optional[float] = None, result: object = None):
        super().__init__(text, crank_angle, result)

    @property
    def crank_angle(self) -> Optional[float]:
        """Where the cycle stopped [degree], 0 = firing TDC; None where no crank turns."""
        return self.args[1]

    @property
    def result(self) -> object:
        """All up to the last good instant, a Result or PadResult; None where there is none."""
        return self.args[2]

    def __str__(self) -> str:
        """The text that the program prints."""
        return self.args[0]


class OutputError(OSError):
    """A file could not be written; a previous file of that name is unchanged (exit code 5 of the program)."""
