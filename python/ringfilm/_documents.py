"""The gas between rings and the life of a ring: what their commands print as JSON, as objects."""

import difflib
from typing import Optional

from ._ringfilm import _gas_path, _run_life, _write_text, quantities


class _Document(dict):
    """A dict of what a command prints, with its names as attributes, and a web page."""

    # By __new__, so that there is no object without its record.
    def __new__(cls, record: dict, page=None, about: Optional[dict] = None):
        self = super().__new__(cls)
        dict.update(self, record)
        self._page = page  # its text, or what makes it
        self._about = about  # title, notes, program and curves of a record that is a part of another
        return self

    def __init__(self, *_):
        """All is done by __new__."""

    def __reduce__(self):
        """For pickle and copy."""
        page = self._page() if callable(self._page) else self._page
        return type(self), (dict(self), page, self._about)

    def __getattr__(self, name):
        if name in self:
            return self[name]
        near = [] if name.startswith("_") else difflib.get_close_matches(name, self._names(), 1)
        raise AttributeError(f"this {self._kind} has no {name}" + (f"; did you mean {near[0]}?" if near else ""))

    def __dir__(self):
        return [*super().__dir__(), *self._names()]

    def _names(self):
        return list(self)

    def _of(self, name):
        """The attributes of the record, or of the document that it is a part of."""
        return (self if self._about is None else self._about).get(name, "")

    def _html_notes(self):
        return [(note["topic"], note["message"]) for note in self._of("notes")]

    def to_pandas(self, units: str = "attrs"):
        """The numbers as a pandas.DataFrame in SI, an instant each row. units: as in Result.to_pandas."""
        from . import _document_frames

        return getattr(_document_frames, f"{self._kind}_to_pandas")(self, units)

    def write_report(self, path) -> None:
        """Writes it as one self-contained web page. Raises OutputError."""
        if self._page is None:
            raise ValueError("this gas is a part of a ring pack: write_report of the PackResult has it on its page")
        _write_text(path, self._page() if callable(self._page) else self._page)

    def __repr__(self) -> str:
        """Title and what matters most, on one line."""
        return f'<ringfilm.{type(self).__name__} "{self._of("title")}": {self._summary()}>'

    def _repr_html_(self) -> str:
        from . import _notebook

        return getattr(_notebook, f"{self._kind}_html")(self)


class GasPathResult(_Document):
    """The gas between the rings of a pack over a cycle, in SI.

    What `ringfilm gas --json` prints are items, as of any dict, and attributes: gas["blow_by_flow"], gas.blow_by_flow.
    Curves are arrays over gas.crank_angle [degree], 0 = firing TDC, from 0 to 720: gas.pressure["land 2"] by region
    [Pa], gas.flow["end gap 1"] by path, positive to the crankcase [kg/s], gas.position[1] of each ring above its lower
    flank [m], gas.share["fuel"]["land 2"] by gas and region [-] where the case states gas.composition.fuel.
    """

    _kind = "gas"

    def __getattr__(self, name):
        curves = self._of("curves") if name not in self and not name.startswith("_") else ()
        return curves[name] if name in curves else super().__getattr__(name)

    def _names(self):
        return [*self, *self._of("curves")]

    @property
    def values(self) -> dict:
        """The values of the cycle, {name: float in SI}; their units are in gas["units"]."""
        names = (quantity.name for quantity in quantities()["gas"])
        return {name: float(self[name]) for name in names if self.get(name) is not None}

    def to_xarray(self, angles: str = "cycle"):
        """The values and curves as an xarray.Dataset in SI, by the names of the NetCDF file of `ringfilm gas`.

        Dimensions: crank_angle, gas_region and gas_path by name, gas_ring. angles: "cycle", from 0 to 720 degree, or
        "firing", from -360 to 360, for .sel(crank_angle=-20). Raises ValueError for another word.
        """
        from ._document_frames import gas_to_xarray

        return gas_to_xarray(self, angles)

    def plot(self, what: str = "overview", axes=None, **style):
        """Draws curves with matplotlib, in units of engineers, from -360 to 360 degree; returns the Figure.

        what: "pressure", "flow" (through the end gaps), "position", or "overview", all of them. axes: a matplotlib Axes
        to draw one of them into; a new figure without it. style: arguments of matplotlib's plot(). Raises ValueError.
        """
        from ._document_plots import plot_gas

        return plot_gas(self, what, axes, **style)

    def _summary(self):
        return f"blow-by {6e4 * self['blow_by_flow']:.3g} l/min per cylinder, {len(self['regions'])} regions"


class LifeResult(_Document):
    """Friction, oil and film of a ring over its running hours, in SI.

    What `ringfilm life --json` prints are items, as of any dict, and attributes. The values of the states are
    attributes, too, as arrays over life.hours: life.fmep, life.min_film_thickness, life.face_height of the shape
    (hours, x); NaN where a state does not have the value. life["states"] has a dict for each of the hours.
    """

    _kind = "life"

    def __getattr__(self, name):
        if not name.startswith("_") and name not in self and any(name in state for state in self["states"]):
            return _over_hours([state.get(name) for state in self["states"]])
        value = super().__getattr__(name)
        return _over_hours(value) if name in ("x", "liner_position") else value

    def _names(self):
        return list(dict.fromkeys([*self, *(name for state in self["states"] for name in state)]))

    @property
    def values(self) -> dict:
        """The values over the hours, {name: array in SI}; their units are in life["units"]."""
        names = (name for name in self._names() if name not in self and name != "hours" and name in self["units"])
        arrays = {name: getattr(self, name) for name in names}
        return {name: array for name, array in arrays.items() if array.ndim == 1 and (array == array).any()}

    def to_xarray(self):
        """The values as an xarray.Dataset in SI, by the names of the NetCDF file of `ringfilm life`.

        Dimensions: running_time [h], and x along the face [m]. Where states are interpolated, `..._low` and
        `..._high` are the ends of the bands.
        """
        from ._document_frames import life_to_xarray

        return life_to_xarray(self)

    def plot(self, what: str = "overview", axes=None, label: Optional[str] = None, **style):
        """Draws values over the running hours with matplotlib, in units of engineers; returns the Figure.

        what: the name of a value, "overview" (power, film, oil), or "face_height". axes: a matplotlib Axes to draw one
        of them into; a new figure without it. label: for a legend. style: arguments of matplotlib's plot().
        Raises ValueError.
        """
        from ._document_plots import plot_life

        return plot_life(self, what, axes, label, **style)

    def _summary(self):
        hours = [state["hours"] for state in self["states"]]
        return f"{len(hours)} states" + (f" from {hours[0]:g} to {hours[-1]:g} h" if hours else "")


def _over_hours(column):
    """Numbers as an array, NaN for None; else the list as it is."""
    import numpy

    if all(value is None or isinstance(value, (int, float)) for value in column):
        return numpy.array([numpy.nan if value is None else value for value in column], dtype=float)
    if all(isinstance(value, str) for value in column):
        return numpy.array(column, dtype=object)
    if all(isinstance(value, list) and value and isinstance(value[0], float) for value in column):
        return numpy.array(column)
    return column


def gas_of_pack(pack, record: dict) -> GasPathResult:
    """The gas of a coupled pack, with the curves that are variables of its result."""
    record, angles = dict(record), pack["gas_crank_angle"]
    regions, paths = ([row["name"] for row in record[rows]] for rows in ("regions", "paths"))
    curves = {
        "crank_angle": angles,
        "pressure": dict(zip(regions, pack["gas_region_pressure"].T)),
        "flow": dict(zip(paths, pack["gas_path_flow"].T)),
        "position": {},
    }
    if "ring_position" in pack:
        curves["position"] = dict(zip(pack["gas_ring"].tolist(), pack["ring_position"].T))
    notes = [{"topic": topic, "message": message, "count": count} for topic, message, count in pack.notes]
    about = {"title": pack.title, "notes": notes, "curves": curves, "program": pack.provenance["program"]}
    return GasPathResult(record, None, about)


def gas_path(case, overrides: Optional[dict] = None) -> GasPathResult:
    """The gas between the rings of a pack over a cycle, as `ringfilm gas` computes it.

    case: a ringfilm.Case, or the path of a case file, in which keys of oil, contact and film may be missing.
    overrides: with a path, keys to replace as --set does, {key: text}. Raises InputError, TypeError.
    Source: docs/theory/gas-path.md.
    """
    return GasPathResult(*_gas_path(case, overrides))


def run_life(path, *, threads: Optional[int] = 0) -> LifeResult:
    """Friction, oil and film of a ring over its running hours, from a life's file, as `ringfilm life` computes them.

    threads: 1 to 1024; 0 or None for as many as the machine runs at once. Ctrl-C ends the run with KeyboardInterrupt.
    Raises InputError for a file that is not a life, ConvergenceError for a cycle without a solution.
    Source: docs/theory/life.md.
    """
    return LifeResult(*_run_life(path, threads=threads))
