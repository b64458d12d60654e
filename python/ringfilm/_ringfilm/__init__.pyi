# Written by script/python-stubs; do not edit.
"""The compiled part of ringfilm; import ringfilm instead."""

from typing import *

import numpy


class Case:
    """The input of one engine cycle or of one pad, as a table of keys (docs/manual/case-file.md, ringfilm.fields()).

    Read one with Case.read, then read and change it key by key: case["operating.speed"] is a number in SI, and
    case["operating.speed"] = "2000 rpm" or = ringfilm.SI(209.4) states another one; 209.4 alone has no unit and is refused.
    None, or del, takes a key out; update() changes keys that only fit together. A value out of its range is refused at once
    with InputError; what joins several keys is looked at by check() and run().
    Cases can be copied, compared and pickled; a pickle holds the numbers of all files that were read."""
    def __contains__(self, key: str) -> bool:
        """Does the case state this key?"""
        ...
    def __copy__(self) -> Case:
        """As copy()."""
        ...
    def __deepcopy__(self, memo: object) -> Case:
        """As copy()."""
        ...
    def __delitem__(self, key: str) -> None:
        """Takes a key out, so that its default holds again. Raises UnknownKeyError for a key that does not exist."""
        ...
    def __eq__(self, other: object) -> object:
        """Have both cases the same values, from files with the same bytes?"""
        ...
    def __getitem__(self, key: str) -> object:
        """The value of a key: a float in SI, an int, a str, a list; of values at temperatures a list of pairs
        (temperature [K], value [SI]); of crank angles [degree]; None where the case has none.
        Raises UnknownKeyError, a KeyError, for a key that does not exist."""
        ...
    def __iter__(self) -> Iterator:
        """Over keys()."""
        ...
    def __len__(self) -> int:
        """How many keys are in use."""
        ...
    def __repr__(self) -> str:
        """Title, file and number of stated keys."""
        ...
    def __setitem__(self, key: str, value: object) -> None:
        """States a key: a text as in a case file ("2000 rpm"), ringfilm.SI(209.4) for a value in SI, a list or an
        array of them. A bare number is accepted where it has no unit, or where its SI unit is the one that people write.
        Raises UnknownKeyError for a key that does not exist, InputError for a missing or wrong unit and a value out of range;
        TypeError for an object that is not a value."""
        ...
    def assumed(self) -> dict:
        """The keys in use that the case does not state, with their values as text()."""
        ...
    def assumptions(self) -> List[str]:
        """What a cycle of this case takes for granted, a sentence each. Raises InputError as check() does. Source: docs/theory/assumptions.md."""
        ...
    def check(self) -> List[str]:
        """Checks the case as a whole. Returns what the program has to say about it, a list of sentences.
        Raises InputError with everything that is wrong."""
        ...
    def copy(self) -> Case:
        """A case of its own with the same values."""
        ...
    @property
    def files(self) -> object:
        """The files that the case was read from: tuples (role, path, SHA-256)."""
        ...
    @property
    def is_pad(self) -> object:
        """Is it a film without engine and ring?"""
        ...
    def items(self) -> list:
        """The keys in use with their values, a list of tuples (key, value)."""
        ...
    def keys(self) -> List[str]:
        """The keys that are in use, stated or not, in the order of a case file."""
        ...
    @staticmethod
    def read(path: object, overrides: Optional[dict] = None) -> Case:
        """A case from a TOML file, with all files that it names.

        path: name of the file, a str or a path.
        overrides: {key: value}, as --set of the program, values as for case[key] = value; None takes a key out.
        Raises InputError with every fault of every file, in the words of the program.
        Source: docs/manual/case-file.md."""
        ...
    def resolved(self) -> str:
        """The case as a complete case file in SI, which gives the same bits again."""
        ...
    @property
    def rings(self) -> object:
        """Of a ring pack ([[ring]]) the case of each ring alone, from the chamber down, a list of Case; else empty."""
        ...
    def run(self, progress: object = None, ledger: bool = False, error_estimate: bool = False, threads: object = None) -> object:
        """Computes the cycle, or the film of a pad.

        progress: called now and then, at most every 20 ms, as progress(cycle, crank_angle) with the number of the cycle from 1
            and the crank angle [degree]; of a pad as progress(time, end_time) [s]. What it raises ends the run.
        ledger: also run the other choice for every assumption that can be lifted; see Result.ledger. Rings only.
        error_estimate: also run finer and coarser cells and crank steps, about four times the work; the errors stand beside
            their quantities: result["cycle_fmep_error"], result["min_film_thickness_error"]. Rings only.
        threads: for these others, 1 to 1024; None: as many as the machine runs at once. The numbers do not depend on it.
        Returns a Result, of a ring pack a PackResult, of a pad a PadResult. Other threads go on meanwhile; Ctrl-C ends the run with KeyboardInterrupt.
        Raises InputError, and ConvergenceError with all up to the last good crank angle in its attribute `result`.
        Source: docs/theory/film.md. The same case gives the same bits as `ringfilm run`."""
        ...
    def text(self, key: str) -> str:
        """The value of a key as a case file has it, in the unit people use: '"2000 rpm"'. Empty where there is none.
        Raises UnknownKeyError, a KeyError, for a key that does not exist."""
        ...
    @property
    def title(self) -> object:
        """Title of the case, a str."""
        ...
    def update(self, values: dict) -> None:
        """States several keys at once, for keys that only fit together: a trace file and the name of its column.

        values: {key: value}, values as for case[key] = value; None takes a key out. Files are read after all changes. Keys next
        to lubricant.file are stated on top of the oil file. Where anything is refused the case stays as it was.
        Raises as case[key] = value; InputError with the faults of all values."""
        ...

class Field:
    """One key of a case. Source: src/ringfilm/cycle/case/case_fields.hpp."""
    def __repr__(self) -> str:
        """Key and help."""
        ...
    @property
    def active_when(self) -> object:
        """When it is in use, in words; empty: always."""
        ...
    @property
    def choices(self) -> object:
        """The words that it may be; empty where it is none of a few words."""
        ...
    @property
    def default(self) -> object:
        """What holds where it is not stated, in SI; None: nothing does."""
        ...
    @property
    def display_unit(self) -> object:
        """The unit in which people write it."""
        ...
    @property
    def example(self) -> object:
        """The right-hand side as one would write it in a case file."""
        ...
    @property
    def help(self) -> object:
        """One line: what it is, symbol, source if assumed."""
        ...
    @property
    def is_required(self) -> object:
        """Must a case state it, where it is in use?"""
        ...
    @property
    def key(self) -> object:
        """Its name, for example engine.bore."""
        ...
    @property
    def range(self) -> object:
        """Smallest and largest value in SI; None: any."""
        ...
    @property
    def unit(self) -> object:
        """SI unit; 1 for a plain number, empty for words."""
        ...

class PackResult:
    """What one engine cycle of a ring pack gave: a Result for each ring, and their sums.

    pack.rings[0] is the ring next to the chamber. Every variable of the result file is an item by its name there, with the
    dimension ring in front: pack["min_film_thickness"] has the shape (ring, crank_angle). Values are SI."""
    def __getitem__(self, name: str) -> object:
        """A variable of the result file by its name: "min_film_thickness" has the shape (ring, crank_angle),
        "cycle_fmep" or "fmep" the shape (ring,). Raises KeyError."""
        ...
    def __len__(self) -> int:
        """How many rings."""
        ...
    def __repr__(self) -> str:
        """Title and number of rings."""
        ...
    @property
    def complete(self) -> object:
        """False where the integration of one ring stopped."""
        ...
    @property
    def resolved_case(self) -> object:
        """A complete case file of the pack in SI that gives the same bits again, a str."""
        ...
    @property
    def rings(self) -> object:
        """The Result of each ring, from the chamber to the crankcase, a list."""
        ...
    @property
    def title(self) -> object:
        """Title of the case, a str."""
        ...
    def to_json(self) -> str:
        """The values of the cycle as `ringfilm run --json` prints them, a str."""
        ...
    def to_xarray(self) -> object:
        """The result as an xarray.Dataset with the dimensions, variables and attributes of its file, in SI."""
        ...
    @property
    def values(self) -> object:
        """What the friction of all rings adds up to, {name: float in SI}: fmep, energy_per_cycle, mean_power_loss."""
        ...
    def write(self, path: object) -> None:
        """Writes the same NetCDF file as `ringfilm run --output`. Raises OutputError."""
        ...
    def write_csv(self, path: object) -> None:
        """Writes the curves as `ringfilm run --csv`, with the column ring. Raises OutputError."""
        ...
    def write_report(self, path: object) -> None:
        """Writes all rings as one self-contained web page, as `ringfilm report`. Raises OutputError."""
        ...

class PadResult:
    """The film between a pad of stated shape and a flat surface that moves past it.

    Numbers are arrays over time, of one instant for a steady film, per metre of width or the mean over it; forces of the
    whole pad are the total_... ones. SI; read-only, without a copy. `values` holds those of the last instant.
    Source: docs/theory/pad.md."""
    def __repr__(self) -> str:
        """Title and number of instants."""
        ...
    @property
    def cavitated_fraction(self) -> object:
        """cavitated share of the length [1], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def complete(self) -> object:
        """False where the film could not be solved to the end."""
        ...
    @property
    def film_content(self) -> object:
        """Liquid share of the gap [-], shape (time, x), with a width (time, y, x); a copy."""
        ...
    @property
    def film_thickness(self) -> object:
        """Film thickness [m], shape (time, x), with a width (time, y, x); a copy."""
        ...
    @property
    def flow_back(self) -> object:
        """volume flow through y = width, positive in +y [m3/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def flow_front(self) -> object:
        """volume flow through y = 0, positive in +y [m3/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def flow_left(self) -> object:
        """volume flow through x = 0, positive in +x [m2/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def flow_right(self) -> object:
        """volume flow through x = length, positive in +x [m2/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def friction_coefficient(self) -> object:
        """friction on the moving surface over load [1], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def friction_fixed(self) -> object:
        """friction on the fixed pad, positive along the motion [N/m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def friction_moving(self) -> object:
        """friction on the moving surface, positive against its motion [N/m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def load(self) -> object:
        """load carried by the film [N/m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mass_flow_back(self) -> object:
        """mass flow through y = width, positive in +y [kg/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mass_flow_front(self) -> object:
        """mass flow through y = 0, positive in +y [kg/s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mass_flow_left(self) -> object:
        """mass flow through x = 0, positive in +x [kg/(m s)], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mass_flow_right(self) -> object:
        """mass flow through x = length, positive in +x [kg/(m s)], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mass_residual(self) -> object:
        """balance of mass, relative to the largest flow [1], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def mean_film_pressure(self) -> object:
        """mean film pressure [Pa], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def min_film_thickness(self) -> object:
        """minimum film thickness [m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def notes(self) -> object:
        """What one must know about this result: tuples (topic, sentence, how many times)."""
        ...
    @property
    def peak_film_pressure(self) -> object:
        """peak film pressure [Pa], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def peak_position(self) -> object:
        """where the film pressure peaks [m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def peak_position_y(self) -> object:
        """where across the pad the film pressure peaks [m], shape (time,). Source: docs/theory/pad.md."""
        ...
    def plot(self, what: str = 'film', axes: object = None, label: object = None, **kwargs) -> object:
        """Draws the pad with matplotlib, in units that go by the size of the numbers.

        what: "film" (gap and pressure of the last instant), "film_thickness", "pressure", "film_content", or a number over time
            ("load").
        axes, label, style: as in Result.plot; not for "film", which is two panels.
        Returns the matplotlib.figure.Figure. Raises ValueError for what cannot be drawn."""
        ...
    @property
    def pressure(self) -> object:
        """Film pressure [Pa], counted from the zero of the case, shape (time, x), with a width (time, y, x); a copy."""
        ...
    @property
    def separation(self) -> object:
        """separation, which adds to the gap [m], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def time(self) -> object:
        """time [s], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def title(self) -> object:
        """Title of the case, a str."""
        ...
    def to_pandas(self) -> object:
        """The numbers of all instants as a pandas.DataFrame, indexed by time [s]; units in attrs."""
        ...
    def to_xarray(self) -> object:
        """The result as an xarray.Dataset over time, x and, with a width, y, as xarray reads it from the file of write(); SI."""
        ...
    @property
    def total_friction_fixed(self) -> object:
        """friction of the whole width on the fixed pad [N], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def total_friction_moving(self) -> object:
        """friction of the whole width on the moving surface [N], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def total_load(self) -> object:
        """load carried by the whole width [N], shape (time,). Source: docs/theory/pad.md."""
        ...
    @property
    def values(self) -> object:
        """The numbers of the last instant, {name: float in SI}."""
        ...
    def write(self, path: object) -> None:
        """Writes the same NetCDF file as `ringfilm run --output`. Raises OutputError."""
        ...
    def write_csv(self, path: object) -> None:
        """Writes the film along the pad as `ringfilm run --csv`. Raises OutputError."""
        ...
    @property
    def x(self) -> object:
        """Places along the pad [m], shape (x,); a step of the gap stands there twice."""
        ...
    @property
    def y(self) -> object:
        """Places across the pad [m], shape (y,); empty without a width."""
        ...

class Quantity:
    """Name, unit and meaning of a number in results."""
    def __repr__(self) -> str:
        """Name, unit and meaning."""
        ...
    @property
    def display_unit(self) -> object:
        """The unit in which people read it."""
        ...
    @property
    def equation(self) -> object:
        """Label in docs/theory; may be empty."""
        ...
    @property
    def long_name(self) -> object:
        """In plain words."""
        ...
    @property
    def name(self) -> object:
        """The word used everywhere."""
        ...
    @property
    def symbol(self) -> object:
        """As in docs/theory."""
        ...
    @property
    def unit(self) -> object:
        """SI unit; degree for crank angles, 1 for plain numbers."""
        ...

class Result:
    """What one engine cycle gave: curves over crank angle, values of the cycle, fields along the face, and all that one
    must know about them.

    Curves are attributes and items, numpy arrays of shape (crank_angle,) in SI without a copy, read-only:
    result.min_film_thickness, result["min_film_thickness"]. Values of the cycle are attributes (result.fmep), unless a
    curve has the same name, and all stand in result.values. Every variable of a result file is an item by its name there.
    Loads, friction and flow are those of the whole ring; signs: see docs/manual/result-file.md. Crank angles are in
    degrees, 0 = firing TDC, from 0 to 720. Results can be pickled."""
    def __contains__(self, name: object) -> bool:
        """Does [] give something for this name?"""
        ...
    def __getitem__(self, name: str) -> object:
        """A curve, a value of the cycle or a field, by its name in the result file (docs/manual/result-file.md):
        "film_pressure" has the shape (field_crank_angle, x). Raises KeyError."""
        ...
    def __iter__(self) -> Iterator:
        """Over keys()."""
        ...
    def __len__(self) -> int:
        """How many keys()."""
        ...
    def __repr__(self) -> str:
        """Title and number of crank angles."""
        ...
    @property
    def applied_load(self) -> object:
        """Load that presses the ring on the liner [N], shape (crank_angle,). Source: docs/theory, eq-applied-load."""
        ...
    @property
    def archard_wear_load(self) -> object:
        """Asperity load times sliding distance, per cycle [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-archard-wear-load."""
        ...
    @property
    def archard_wear_load_rate(self) -> object:
        """Asperity load times sliding speed, the Archard wear load [W], shape (crank_angle,). Source: docs/theory, eq-archard-wear-load."""
        ...
    @property
    def asperity_contact_area(self) -> object:
        """Real area of asperity contact [m2], shape (crank_angle,). Source: docs/theory, eq-asperity-area."""
        ...
    @property
    def asperity_load(self) -> object:
        """Load carried by asperities [N], shape (crank_angle,). Source: docs/theory, eq-asperity-load."""
        ...
    @property
    def assumptions(self) -> object:
        """What the cycle takes for granted: tuples (topic, statement, consequence, source)."""
        ...
    @property
    def boundary_friction(self) -> object:
        """Boundary friction [N], shape (crank_angle,). Source: docs/theory, eq-boundary-friction."""
        ...
    @property
    def cavitated_fraction(self) -> object:
        """Cavitated share of the face [1], shape (crank_angle,). Source: docs/theory, eq-complementarity."""
        ...
    @property
    def complete(self) -> object:
        """False where the integration stopped, or never began; the curves then hold what it had passed."""
        ...
    @property
    def compression_stroke_energy(self) -> object:
        """Friction energy of the compression stroke [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-energy-per-cycle."""
        ...
    @property
    def crank_angle(self) -> object:
        """Crank angle, 0 at firing TDC [degree], shape (crank_angle,)."""
        ...
    @property
    def crank_sub_steps(self) -> object:
        """Steps taken on the way to this angle [1], shape (crank_angle,). Source: docs/theory, eq-load-balance."""
        ...
    @property
    def crankcase_pressure(self) -> object:
        """Pressure under the ring, absolute [Pa], shape (crank_angle,)."""
        ...
    @property
    def cycle_min_film_thickness(self) -> object:
        """Minimum film thickness [m], a float; NaN where the cycle was not finished. Source: docs/theory, eq-film-thickness."""
        ...
    @property
    def cycle_peak_film_pressure(self) -> object:
        """Peak film pressure, absolute [Pa], a float; NaN where the cycle was not finished. Source: docs/theory, eq-reynolds."""
        ...
    @property
    def derived(self) -> object:
        """Constants that follow from the case, {name: float in SI}: composite modulus, elastic pressure and others."""
        ...
    @property
    def effort(self) -> object:
        """What the solver did, {name: number}."""
        ...
    @property
    def ends_share_absolute_flow(self) -> object:
        """Share of the gap's ends in the mean absolute oil flow at the middle section [1], a float; NaN unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def ends_share_flow(self) -> object:
        """Share of the gap's ends in the oil flow at the middle section [1], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def ends_share_friction(self) -> object:
        """Share of the gap's ends in the total friction [1], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def ends_share_friction_power(self) -> object:
        """Share of the gap's ends in the mean friction power [1], a float; NaN unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def ends_share_load(self) -> object:
        """Share of the gap's ends in the load carried [1], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def ends_share_mean_load(self) -> object:
        """Share of the gap's ends in the mean load [1], a float; NaN unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def energy_per_cycle(self) -> object:
        """Friction energy per cycle [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-energy-per-cycle."""
        ...
    @property
    def exhaust_stroke_energy(self) -> object:
        """Friction energy of the exhaust stroke [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-energy-per-cycle."""
        ...
    @property
    def fallbacks(self) -> object:
        """Steps that needed the bracketed search or a shorter step [1], shape (crank_angle,). Source: docs/theory, eq-load-balance."""
        ...
    @property
    def film_temperature(self) -> object:
        """Temperature of the oil film [K], shape (crank_angle,). Source: docs/theory, eq-film-temperature."""
        ...
    @property
    def fmep(self) -> object:
        """Friction mean effective pressure [Pa], a float; NaN where the cycle was not finished. Source: docs/theory, eq-fmep."""
        ...
    @property
    def friction_coefficient(self) -> object:
        """Friction coefficient [1], shape (crank_angle,). Source: docs/theory, eq-friction-coefficient."""
        ...
    @property
    def friction_on_liner(self) -> object:
        """Friction on the liner, positive towards TDC [N], shape (crank_angle,). Source: docs/theory, eq-friction-on-liner."""
        ...
    @property
    def gap_leakage(self) -> object:
        """Oil out of the film into the ring's gap [kg/s], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def gap_leakage_high_end(self) -> object:
        """Oil out of the film into the gap at the end y = L [kg/s], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def gap_leakage_low_end(self) -> object:
        """Oil out of the film into the gap at the end y = 0 [kg/s], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def gap_leakage_share(self) -> object:
        """Mean absolute flow between film and gap over that at the middle section [1], a float; NaN unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def gas_pressure(self) -> object:
        """Cylinder pressure, absolute [Pa], shape (crank_angle,)."""
        ...
    @property
    def hydrodynamic_load(self) -> object:
        """Load carried by the film [N], shape (crank_angle,). Source: docs/theory, eq-hydrodynamic-load."""
        ...
    @property
    def inputs(self) -> object:
        """The case as it was used: tuples (key, value as in a case file in SI, value for people, assumed)."""
        ...
    @property
    def intake_stroke_energy(self) -> object:
        """Friction energy of the intake stroke [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-energy-per-cycle."""
        ...
    def keys(self) -> list:
        """Names of all that [] gives, as in the result file, in its order."""
        ...
    @property
    def lambda_ratio(self) -> object:
        """Lambda ratio, minimum film over composite roughness [1], shape (crank_angle,). Source: docs/theory, eq-lambda-ratio."""
        ...
    @property
    def lambda_ratio_at_peak_pressure(self) -> object:
        """Lambda ratio at peak cylinder pressure [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-lambda-ratio."""
        ...
    @property
    def ledger(self) -> object:
        """What it would change to lift an assumption, if run(ledger=True) was asked to find out.

        Dicts in the order of `assumptions`, of those that were lifted: topic, statement, and variants, a list of dicts: setting
        as one would write it, values {name: float in SI} of the cycle with this setting alone changed, reason (empty; why it was
        not solved, with NaN for values). Empty where it was not asked for."""
        ...
    @property
    def load_residual(self) -> object:
        """Imbalance of the load, relative [1], shape (crank_angle,). Source: docs/theory, eq-load-balance."""
        ...
    @property
    def max_film_thickness(self) -> object:
        """Largest minimum film thickness of the cycle [m], a float; NaN where the cycle was not finished. Source: docs/theory, eq-film-thickness."""
        ...
    @property
    def mean_absolute_gap_leakage(self) -> object:
        """Mean absolute oil flow between film and gap [kg/s], a float; NaN unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def mean_absolute_oil_flow(self) -> object:
        """Mean absolute oil flow at the middle section [kg/s], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mass-flow."""
        ...
    @property
    def mean_boundary_friction(self) -> object:
        """Mean boundary friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def mean_boundary_power(self) -> object:
        """Mean boundary friction power [W], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def mean_cavitated_fraction(self) -> object:
        """Mean cavitated share of the face [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-complementarity."""
        ...
    @property
    def mean_friction_coefficient(self) -> object:
        """Mean friction coefficient, weighted with the load [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-load-mean."""
        ...
    @property
    def mean_gap_leakage(self) -> object:
        """Mean oil flow out of the film into the ring's gap [kg/s], a float; NaN unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def mean_lambda_ratio(self) -> object:
        """Mean lambda ratio, weighted with the load [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-load-mean."""
        ...
    @property
    def mean_power_loss(self) -> object:
        """Mean friction power [W], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def mean_stribeck_number(self) -> object:
        """Mean Stribeck number, weighted with the load [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-load-mean."""
        ...
    @property
    def mean_total_friction(self) -> object:
        """Mean total friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def mean_viscous_friction(self) -> object:
        """Mean viscous friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def mean_viscous_power(self) -> object:
        """Mean viscous friction power [W], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mean."""
        ...
    @property
    def min_film_thickness(self) -> object:
        """Minimum film thickness [m], shape (crank_angle,). Source: docs/theory, eq-film-thickness."""
        ...
    @property
    def min_film_thickness_angle(self) -> object:
        """Crank angle of the minimum film thickness [degree], a float; NaN where the cycle was not finished. Source: docs/theory, eq-film-thickness."""
        ...
    @property
    def min_lambda_ratio(self) -> object:
        """Lowest lambda ratio [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-lambda-ratio."""
        ...
    @property
    def mixed_share(self) -> object:
        """Share of the cycle in mixed lubrication (lambda ratio below 3) [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mixed-share."""
        ...
    @property
    def net_oil_flow(self) -> object:
        """Net oil flow at the middle section, positive to the crankcase [kg/s], a float; NaN where the cycle was not finished. Source: docs/theory, eq-mass-flow."""
        ...
    @property
    def newton_iterations(self) -> object:
        """Newton iterations spent on the way to this angle [1], shape (crank_angle,). Source: docs/theory, eq-load-balance."""
        ...
    @property
    def notes(self) -> object:
        """What one must know about this result: tuples (topic, sentence, how many times)."""
        ...
    @property
    def oil_flow_chamber_edge(self) -> object:
        """Oil flow at the chamber edge, positive to the crankcase [kg/s], shape (crank_angle,). Source: docs/theory, eq-mass-flow."""
        ...
    @property
    def oil_flow_crankcase_edge(self) -> object:
        """Oil flow at the crankcase edge, positive to the crankcase [kg/s], shape (crank_angle,). Source: docs/theory, eq-mass-flow."""
        ...
    @property
    def oil_flow_middle(self) -> object:
        """Oil flow at the middle section, positive to the crankcase [kg/s], shape (crank_angle,). Source: docs/theory, eq-mass-flow."""
        ...
    @property
    def oil_flow_without_ends(self) -> object:
        """Oil flow at the middle section if all were like the strip opposite the gap [kg/s], shape (crank_angle,); empty unless the film is unrolled. Source: docs/theory, eq-end-share."""
        ...
    @property
    def peak_boundary_friction(self) -> object:
        """Peak boundary friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-boundary-friction."""
        ...
    @property
    def peak_boundary_friction_angle(self) -> object:
        """Crank angle of the peak boundary friction [degree], a float; NaN where the cycle was not finished. Source: docs/theory, eq-boundary-friction."""
        ...
    @property
    def peak_film_pressure(self) -> object:
        """Peak film pressure, absolute [Pa], shape (crank_angle,). Source: docs/theory, eq-reynolds."""
        ...
    @property
    def peak_friction_coefficient(self) -> object:
        """Peak friction coefficient [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-friction-coefficient."""
        ...
    @property
    def peak_friction_coefficient_angle(self) -> object:
        """Crank angle of the peak friction coefficient [degree], a float; NaN where the cycle was not finished. Source: docs/theory, eq-friction-coefficient."""
        ...
    @property
    def peak_friction_coefficient_firing(self) -> object:
        """Peak friction coefficient within 60 degree of firing TDC [1], a float; NaN where the cycle was not finished. Source: docs/theory, eq-friction-coefficient."""
        ...
    @property
    def peak_gap_leakage(self) -> object:
        """Largest oil flow between film and gap, positive into the gap [kg/s], a float; NaN unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def peak_gap_leakage_angle(self) -> object:
        """Crank angle of the largest oil flow between film and gap [degree], a float; NaN unless the film is unrolled. Source: docs/theory, eq-gap-leakage."""
        ...
    @property
    def peak_gas_pressure(self) -> object:
        """Peak cylinder pressure, absolute [Pa], a float; NaN where the cycle was not finished."""
        ...
    @property
    def peak_gas_pressure_angle(self) -> object:
        """Crank angle of the peak cylinder pressure [degree], a float; NaN where the cycle was not finished."""
        ...
    @property
    def peak_total_friction(self) -> object:
        """Peak total friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-total-friction."""
        ...
    @property
    def peak_total_friction_angle(self) -> object:
        """Crank angle of the peak total friction [degree], a float; NaN where the cycle was not finished. Source: docs/theory, eq-total-friction."""
        ...
    @property
    def peak_viscous_friction(self) -> object:
        """Peak viscous friction [N], a float; NaN where the cycle was not finished. Source: docs/theory, eq-viscous-friction."""
        ...
    @property
    def peak_viscous_friction_angle(self) -> object:
        """Crank angle of the peak viscous friction [degree], a float; NaN where the cycle was not finished. Source: docs/theory, eq-viscous-friction."""
        ...
    @property
    def piston_position(self) -> object:
        """Distance of the piston below TDC [m], shape (crank_angle,). Source: docs/theory, eq-piston-position."""
        ...
    @property
    def piston_velocity(self) -> object:
        """Piston velocity, positive towards TDC [m/s], shape (crank_angle,). Source: docs/theory, eq-piston-velocity."""
        ...
    def plot(self, what: str = 'overview', axes: object = None, label: object = None, **kwargs) -> object:
        """Draws the result with matplotlib, in units of engineers, from -360 to 360 degree with firing TDC in the middle.

        what: "overview" (pressure, film, friction), "friction", "film", "stribeck", or the name of a curve or of a field
            (curves of up to 8 angles, a map of more).
        axes: a matplotlib Axes to draw into, in its next colour; a new figure without it. Not for "overview", "friction" and
            "film", which are several panels.
        label: for a legend; title and speed of the case where axes is given.
        style: words of matplotlib's plot(), of pcolormesh() for a map.
        Returns the matplotlib.figure.Figure. Raises ValueError for what cannot be drawn."""
        ...
    @property
    def power_loss(self) -> object:
        """Friction power loss [W], shape (crank_angle,). Source: docs/theory, eq-power-loss."""
        ...
    @property
    def power_stroke_energy(self) -> object:
        """Friction energy of the power stroke [J], a float; NaN where the cycle was not finished. Source: docs/theory, eq-energy-per-cycle."""
        ...
    @property
    def provenance(self) -> object:
        """What computed the result: program, commit, compiler, kernels."""
        ...
    @staticmethod
    def read(path: object) -> object:
        """A result from a NetCDF file that this module or `ringfilm run` wrote; of a ring pack a PackResult. Raises InputError."""
        ...
    @property
    def reason(self) -> object:
        """Why a scenario of a batch was not solved, on one line; empty where it was."""
        ...
    @property
    def reformation_position(self) -> object:
        """Where the cavity ends, from the chamber edge [m], shape (crank_angle,). Source: docs/theory, eq-complementarity."""
        ...
    @property
    def resolved_case(self) -> object:
        """A complete case file in SI that gives the same bits again, a str."""
        ...
    @property
    def rupture_position(self) -> object:
        """Where the cavity begins, from the chamber edge [m], shape (crank_angle,). Source: docs/theory, eq-complementarity."""
        ...
    @property
    def sliding_distance(self) -> object:
        """Sliding distance since firing TDC [m], shape (crank_angle,). Source: docs/theory, eq-sliding-distance."""
        ...
    @property
    def stribeck_number(self) -> object:
        """Stribeck number [1], shape (crank_angle,). Source: docs/theory, eq-stribeck-number."""
        ...
    @property
    def title(self) -> object:
        """Title of the case, a str."""
        ...
    def to_json(self) -> str:
        """The values of the cycle as `ringfilm run --json` prints them, a str."""
        ...
    def to_pandas(self) -> object:
        """The curves as a pandas.DataFrame, one column a quantity in SI, indexed by crank angle [degree]; units in attrs."""
        ...
    def to_xarray(self) -> object:
        """The result as an xarray.Dataset with the dimensions, coordinates, variables and attributes of its file:
        the same as xarray.open_dataset gives of what write() wrote, in SI, numbers without a copy."""
        ...
    @property
    def total_friction(self) -> object:
        """Total friction [N], shape (crank_angle,). Source: docs/theory, eq-total-friction."""
        ...
    @property
    def values(self) -> object:
        """All values of the cycle, {name: float in SI}."""
        ...
    @property
    def viscous_friction(self) -> object:
        """Viscous friction on the liner, modulus [N], shape (crank_angle,). Source: docs/theory, eq-viscous-friction."""
        ...
    @property
    def viscous_friction_liner(self) -> object:
        """Viscous friction on the liner, positive towards TDC [N], shape (crank_angle,). Source: docs/theory, eq-viscous-friction."""
        ...
    @property
    def viscous_friction_ring(self) -> object:
        """Viscous friction on the ring, signed [N], shape (crank_angle,). Source: docs/theory, eq-viscous-friction."""
        ...
    def write(self, path: object) -> None:
        """Writes the same NetCDF file as `ringfilm run --output`, byte by byte, aside first. Raises OutputError."""
        ...
    def write_csv(self, path: object) -> None:
        """Writes the curves as `ringfilm run --csv`. Raises OutputError."""
        ...
    def write_report(self, path: object) -> None:
        """Writes the result as one self-contained web page, as `ringfilm report`. Raises OutputError."""
        ...

class Study:
    """Many scenarios of one or several cases: what varies, and how it is sampled.

    A study is read from a file (docs/manual/study.md). len(study) is the number of its scenarios.
    Source: docs/theory/study.md."""
    def __len__(self) -> int:
        """How many scenarios."""
        ...
    def __repr__(self) -> str:
        """Title and number of scenarios."""
        ...
    @property
    def base_of(self) -> object:
        """Name of the base case of each scenario, a list."""
        ...
    @property
    def bases(self) -> object:
        """Names of the base cases, a list of str."""
        ...
    @property
    def factors(self) -> object:
        """What varies: dicts with name, variable (as in files), unit in SI, keys, choices, source of its scatter."""
        ...
    @property
    def notes(self) -> object:
        """What must be known about the plan, a list of str."""
        ...
    @property
    def points(self) -> object:
        """Numbers of the factors, shape (scenario, factor), in SI; of choices the index; NaN where a factor leaves its base as it is."""
        ...
    @staticmethod
    def read(path: object) -> Study:
        """A study with its bases and all that they name. Raises InputError with every fault, in the words of the program."""
        ...
    def run(self, threads: object = None, progress: object = None) -> StudyResult:
        """Computes all scenarios, in memory; a study that must survive is run by `ringfilm study`.

        threads: None, or 1 to 1024; the numbers do not depend on it. progress: called as progress(done, total) now and then.
        Returns a StudyResult. Ctrl-C ends the run with KeyboardInterrupt. A scenario that cannot be solved is a row of NaN with
        its reason. A plan with `until` goes on until it is sure enough: the result has more scenarios than this study then,
        its own `study` is the plan as it ended, and `total` grows. Raises InputError."""
        ...
    @property
    def title(self) -> object:
        """Its title, a str."""
        ...
    def to_pandas(self) -> object:
        """The plan as a pandas.DataFrame: one row a scenario, one column a factor, and the base."""
        ...

class StudyResult:
    """Values of the cycle of all scenarios of a study. Source: docs/theory/study.md."""
    def __getitem__(self, value: str) -> numpy.ndarray:
        """A value of the cycle over the scenarios, shape (scenario,), SI. Raises UnknownKeyError."""
        ...
    def __len__(self) -> int:
        """How many scenarios."""
        ...
    def __repr__(self) -> str:
        """Title and number of scenarios."""
        ...
    @property
    def crank_angle(self) -> object:
        """The axis of curves(), from -360 to below 360 [degree]; empty where no curves are kept."""
        ...
    def curves(self, quantity: str) -> numpy.ndarray:
        """A curve of all scenarios, shape (scenario, crank_angle), SI, single precision, without a copy.

        Over crank_angle; NaN where a scenario was not solved. Raises InputError unless the study keeps it ([keep] in its
        file)."""
        ...
    @property
    def notes(self) -> object:
        """The notes on single results, the most serious first, {topic: (message of the scenario where it is worst, else of the first, list of scenarios from 0)}."""
        ...
    @property
    def plan_notes(self) -> object:
        """Notes on the plan, among them the factors that change no value, a list of str."""
        ...
    def sobol_indices(self, value: str, base: Optional[str] = None) -> list:
        """Which factor decides: first and total Sobol indices with their 95 % intervals.

        value, base: as for statistics(). Returns a list of dicts, one a group of factors; empty where the value does not vary.
        Raises InputError where the plan has no points for indices. Source: docs/theory/study.md, eq-first-index."""
        ...
    def statistics(self, value: str, base: Optional[str] = None) -> dict:
        """Mean with its standard error, deviation, quantiles (5, 25, 50, 75, 95 %) with their 95 % intervals.

        value: name of a value of the cycle. base: name of the base case, None where there is one. Returns a dict in SI; of a
        plan that is no sample (a grid, a list) only its order counts. Raises InputError. Source: docs/theory/study.md."""
        ...
    @property
    def study(self) -> object:
        """The Study."""
        ...
    def to_pandas(self) -> object:
        """A pandas.DataFrame: one row a scenario, columns base, factors, values of the cycle in SI, reason."""
        ...
    def to_xarray(self) -> object:
        """An xarray.Dataset over scenario, SI: base, factors and choices (as texts) as coordinates, kept curves over scenario, crank_angle and ring."""
        ...
    @property
    def unsolved(self) -> object:
        """Why scenarios were not solved, {scenario from 0: reason}."""
        ...

def _run_program(words: List[str]) -> int:
    """The command line, its program's name first. Returns the exit code."""
    ...

def _simulate_many(cases: object, threads: object, progress: object, curves: str) -> list:
    """Results of a batch, a list; see ringfilm.simulate_many."""
    ...

def _unit_scale(display_unit: str, unit: str) -> tuple:
    """SI = value * first + second, of a value in the display unit."""
    ...

def fields() -> List[Field]:
    """All keys of a case, a list of Field in the order of a case file."""
    ...

def note_topics() -> List[str]:
    """Topics of the notes on results, the most serious first."""
    ...

def quantities() -> dict:
    """All quantities of results, {table: list of Quantity}: "curve" over crank angle, "cycle" for the cycle as
    a whole, "derived" constants of a case, "unrolled_curve", "unrolled_cycle", "pad", "pad_width", "pad_film"."""
    ...

def starting_case() -> str:
    """A commented, complete case file to start from, a str, as `ringfilm new` writes it."""
    ...

def version() -> str:
    """Name, version and commit of the program that this is."""
    ...
