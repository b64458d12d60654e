"""Many cases at once."""

import operator
from collections.abc import Sequence
from typing import Callable, Iterable, Optional

from ._ringfilm import Case, Result, _simulate_many, note_topics, quantities


class BatchResult(Sequence):
    """What became of many cases: a sequence of Result in the order of the cases.

    A case that could not be solved is there too, with `complete` False, its `reason`, and NaN for every value. Beside
    numbers it takes what numpy takes, and the names of values: batch[batch["fmep"] > 2e4], batch[[0, 2]].
    """

    # By __new__, so that there is no BatchResult without its results.
    def __new__(cls, results: list):
        self = super().__new__(cls)
        self._results = list(results)
        return self

    def __reduce__(self):
        """For pickle and copy."""
        return type(self), (self._results,)

    def __len__(self) -> int:
        """How many cases there were."""
        return len(self._results)

    def __getitem__(self, index):
        """The result of one case; a BatchResult of a slice, of a list of numbers or of booleans; a value of all cases.

        A name gives the value of the cycle [SI] of all cases, shape (case,), NaN where one was not solved, or "reason".
        `min_film_thickness` is the value here, and may be written `cycle_min_film_thickness`, too. Raises IndexError,
        KeyError.
        """
        if isinstance(index, str):
            from ._frames import batch_column

            return batch_column(self, index)
        if isinstance(index, slice):
            return BatchResult(self._results[index])
        if hasattr(index, "__index__") and not getattr(index, "ndim", 0):
            return self._results[operator.index(index)]
        import numpy

        chosen = numpy.arange(len(self))[index if isinstance(index, list) else numpy.asarray(index)]
        if chosen.ndim != 1:
            raise IndexError("a batch has one dimension, its cases")
        return BatchResult(self._results[i] for i in chosen)

    @property
    def unsolved(self) -> dict:
        """Why cases were not solved, {number of the case from 0: reason}; empty if all were."""
        return {i: result.reason for i, result in enumerate(self._results) if result.reason}

    @property
    def notes(self) -> dict:
        """The notes on single results, {topic: (message of the first of them, list of cases from 0)}.

        Those of cases that were not solved are not among them. The most serious first, in the order of
        `ringfilm.note_topics()`.
        """
        notes = {}
        for i, result in enumerate(self._results):
            if result.reason:
                continue
            for topic, message, _ in result.notes:
                if topic == "input":
                    continue
                cases = notes.setdefault(topic, (message, []))[1]
                if not cases or cases[-1] != i:
                    cases.append(i)
        rank = {topic: i for i, topic in enumerate(note_topics())}
        return dict(sorted(notes.items(), key=lambda item: (rank.get(item[0], len(rank)), item[0])))

    def to_pandas(self, units: str = "attrs"):
        """Values of the cycle as a pandas.DataFrame: one row a case, one column a value in SI, and `reason`.

        NaN where a case was not solved. `attrs["units"]` has the unit of each column; units="columns" writes it into
        the name of the column as well.
        """
        from ._frames import batch_to_pandas

        return batch_to_pandas(self, units)

    def to_xarray(self, curves: Optional[Iterable[str]] = None):
        """An xarray.Dataset in SI: values over `case`, and the curves that were kept over `case` and `crank_angle`.

        curves: names of those to take, None for all; they are copied.

        Where a curve and a value share their name the value is `cycle_...`. Cases of different crank angles share an
        axis of all of them, NaN where one has none, as for a case that was not solved: see `solved` and `reason`.
        Raises KeyError.
        """
        from ._frames import batch_to_xarray

        return batch_to_xarray(self, curves)

    def __repr__(self) -> str:
        """Number of results, and how many of them are not solved."""
        return f"<ringfilm.BatchResult: {len(self)} cases, {len(self.unsolved)} not solved>"


def simulate_many(
    cases: Iterable[Case],
    threads: Optional[int] = None,
    progress: Optional[Callable[[int, Optional[int]], None]] = None,
    curves: str = "all",
) -> BatchResult:
    """Computes the cycles of many cases, films side by side in vector registers, on several threads.

    cases: any iterable; of a generator only some are asked for ahead of time. Each is copied when it is taken.
    threads: 1 to 1024; None: as many as the machine runs at once. The numbers do not depend on it.
    progress: called as progress(done, total) when a case ends, not in order; total is None for a generator. What it
        raises ends the batch.
    curves: "all" keeps the curves of each result (0.2 MB a case with its 720 crank angles), "none" its values alone.

    Returns a BatchResult in the order of the cases. Other Python threads continue meanwhile, Ctrl-C ends the batch. A
    value differs from that of Case.run by what the iteration may leave (solver.tolerance).
    Raises InputError for wrong arguments; a case that is refused or not solved is a result with its reason.
    Source: docs/theory/study.md.
    """
    return BatchResult(_simulate_many(cases, threads, progress, curves))


def cycle_units() -> dict:
    """Units of the values of a cycle, {name: unit}."""
    return {quantity.name: quantity.unit for quantity in quantities()["cycle"]}


__all__ = ["BatchResult", "simulate_many", "Result"]
