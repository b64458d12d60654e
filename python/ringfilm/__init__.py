"""Mixed lubrication of piston rings: friction, film and oil flow over an engine cycle, from measured surfaces.

    import ringfilm
    case = ringfilm.Case.read("cases/styles2014/new.toml")
    case["operating.speed"] = "2000 rpm"
    result = case.run()
    result.fmep, result.min_film_thickness, result.to_xarray(), result.plot()

All numbers that are read are in SI; a key of a case takes a text with its unit, or ringfilm.SI(number). Crank angles
are in degrees, those of results from 0 = firing TDC to 720. The names are those of the case files, of the result files
and of the C++ library; docs/manual/python.md has examples.
"""

from . import face, lateral_force, laws, surface
from ._batch import BatchResult, simulate_many
from ._documents import GasPathResult, LifeResult, gas_path, run_life
from ._ringfilm import (
    Case,
    Field,
    PackResult,
    PadResult,
    Quantity,
    Result,
    Study,
    StudyResult,
    compare_faces,
    conform,
    fields,
    fit,
    note_topics,
    oils,
    optimise,
    pairs,
    quantities,
    starting_case,
    surface_classes,
    version,
)
from ._values import SI
from .errors import ConvergenceError, Fault, InputError, OutputError, UnknownKeyError

__version__ = version().split()[1]

__all__ = [
    "BatchResult",
    "Case",
    "ConvergenceError",
    "Fault",
    "Field",
    "GasPathResult",
    "InputError",
    "LifeResult",
    "OutputError",
    "PackResult",
    "PadResult",
    "Quantity",
    "Result",
    "SI",
    "Study",
    "StudyResult",
    "UnknownKeyError",
    "compare_faces",
    "conform",
    "face",
    "fields",
    "fit",
    "gas_path",
    "lateral_force",
    "laws",
    "note_topics",
    "oils",
    "optimise",
    "pairs",
    "quantities",
    "run_life",
    "simulate_many",
    "starting_case",
    "surface",
    "surface_classes",
    "version",
]
