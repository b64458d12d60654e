"""What the functions on measured data take and refuse, and in which words."""

import decimal
import os

import numpy
import pytest

import ringfilm
from conftest import SOURCES
from ringfilm import face, lateral_force, laws, surface

MEASURED = SOURCES / "cases" / "measured"
GENERATOR = numpy.random.default_rng(7)
HEIGHTS = 1e-7 * GENERATOR.standard_normal((40, 50))
STEP = 1e-6
X = numpy.linspace(0, 1.2e-3, 601)
GAP = 15e-6 * ((X - 0.6e-3) / 0.6e-3) ** 2
PLACES = numpy.linspace(0, 1e-6, 100)
SIGNAL = 0.3 + 0.01 * GENERATOR.standard_normal(100)


def masked(array, *at):
    mask = numpy.zeros(numpy.shape(array), bool)
    if at:
        mask[at] = True
    return numpy.ma.array(array, mask=mask, copy=True)


def contact():
    return laws.GreenwoodTripp(N=0.1e12, beta=1.5e-6, sigma=0.5e-6, E_prime=1.4e11)


def fitted(x=X, height=GAP, width=1.2e-3, **stated):
    return face.fit_face(x, height, width, **{"sense": "gap", "levelling": "none", **stated})


# --- two arrays come in ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "call",
    [
        lambda: laws.Walther.fit(numpy.linspace(300, 400, 3), [6e-5, 9e-6]),
        lambda: laws.Walther.fit([300, 400], [6e-5, 2e-5, 9e-6]),
        lambda: laws.Walther.fit([], [6e-5, 9e-6]),
        lambda: fitted(X, GAP[:-1]),
        lambda: lateral_force.loop_friction(PLACES, SIGNAL, SIGNAL[:-1]),
        lambda: lateral_force.loop_friction(PLACES[:-1], SIGNAL, SIGNAL),
        lambda: lateral_force.fit_line([1, 2, 3, 4], [1, 2, 3]),
        lambda: lateral_force.fit_line([1, 2, 3, 4], [1, 2, 3, 4], x_deviation=[0.1, 0.1]),
        lambda: lateral_force.fit_line([1, 2, 3, 4], [1, 2, 3, 4], y_deviation=[]),
        lambda: surface.gaussian_transmission([1e-5, 2e-5], [1e-5, 2e-5, 3e-5]),
        lambda: laws.composite_modulus([2e11, 1e11], 0.3, [2e11, 1e11, 1e11], 0.3),
    ],
)
def test_arrays_of_unlike_lengths_are_refused(call):
    with pytest.raises(ringfilm.InputError):
        call()


# --- masked points --------------------------------------------------------------------------------


def test_masked_heights_count_as_not_measured():
    hidden = masked(HEIGHTS, [3, 9], [4, 5])
    shown = HEIGHTS.copy()
    shown[[3, 9], [4, 5]] = numpy.nan
    hidden.data[3, 4] = 1.0  # what is below a mask must not come through
    assert surface.height_statistics(hidden, STEP) == surface.height_statistics(shown, STEP)
    assert surface.height_statistics(hidden, STEP).missing == 2
    numpy.testing.assert_array_equal(surface.prepare(hidden, STEP), surface.prepare(shown, STEP))
    assert surface.moments(hidden, STEP) == surface.moments(shown, STEP)
    assert len(surface.material_ratio_curve(hidden, STEP)) == HEIGHTS.size - 2
    # Rows that are masked arrays, in a list.
    assert surface.height_statistics([hidden[i] for i in range(40)], STEP).missing == 2
    # A masked array that hides nothing is an array.
    assert surface.height_statistics(masked(HEIGHTS), STEP) == surface.height_statistics(HEIGHTS, STEP)


@pytest.mark.parametrize(
    "call",
    [
        lambda: fitted(X, masked(GAP, 5)),
        lambda: fitted(masked(X, 5), GAP),
        lambda: lateral_force.loop_friction(PLACES, masked(SIGNAL, 3), SIGNAL),
        lambda: lateral_force.fit_line([1, 2, 3], masked([1, 2, 3], 1)),
        lambda: surface.core_roughness(masked(numpy.linspace(1, 0, 200), 3)),
        lambda: contact().pressure(masked([1e-6, 2e-6], 0)),
        lambda: laws.gaussian_integral(2, masked([1.0, 2.0], 0)),
        lambda: laws.Walther.fit(masked([313.15, 373.15, 393.15], 1), [6e-5, 9e-6, 5e-6]),
        lambda: surface.gaussian_transmission(masked([1e-5, 2e-5], 0), 1e-5),
        lambda: surface.height_statistics(HEIGHTS, numpy.ma.masked),
    ],
)
def test_masked_values_are_refused_elsewhere(call):
    with pytest.raises(ringfilm.InputError, match="masked"):
        call()


# --- kinds of arguments ---------------------------------------------------------------------------


@pytest.mark.parametrize(
    "step",
    [
        numpy.array(1e-6),
        numpy.float32(1e-6),
        decimal.Decimal("1e-6"),
        (1e-6, 1e-6),
        [1e-6, 1e-6],
        numpy.array([1e-6, 1e-6]),
    ],
)
def test_numbers_of_any_kind_are_numbers(step):
    got = surface.moments(HEIGHTS, step)
    # float32 has 7 digits, and the moments the fourth power of the step.
    assert got.m4_per_m2 == pytest.approx(surface.moments(HEIGHTS, STEP).m4_per_m2, rel=1e-6)


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: surface.height_statistics(HEIGHTS, "1 um"), "step must be a number or two, (x, y), in m, not '1 um'"),
        (lambda: surface.height_statistics(HEIGHTS, None), "step must be a number or two, (x, y), in m, not None"),
        (
            lambda: surface.height_statistics(HEIGHTS, (1e-6, 1e-6, 1e-6)),
            "step must be a number or two, (x, y), in m, not 3",
        ),
        (lambda: surface.height_statistics(HEIGHTS, True), "step must be a number in m, not of type bool"),
        (lambda: surface.height_statistics(HEIGHTS, 1e-6j), "step must be a number in m, not of type complex"),
        (lambda: surface.height_statistics(HEIGHTS, ("1 um", 1e-6)), "step must be a number in m, not '1 um'"),
        (lambda: surface.prepare(HEIGHTS, STEP, long_cutoff="80 um"), "long_cutoff must be a number in m, not '80 um'"),
        (
            lambda: surface.prepare(HEIGHTS, STEP, short_cutoff=[1e-5]),
            "short_cutoff must be a number in m, not of type list",
        ),
        (lambda: surface.prepare(HEIGHTS, STEP, form=None), "form must be a text such as"),
        (lambda: surface.prepare(HEIGHTS, STEP, degree=2.0), "degree must be an integer, not of type float"),
        (
            lambda: surface.height_statistics(HEIGHTS + 0j, STEP),
            "heights must be an array of real numbers, not of complex128",
        ),
        (lambda: surface.height_statistics(HEIGHTS > 0, STEP), "heights must be an array of real numbers, not of bool"),
        (
            lambda: surface.height_statistics("ring.x3p", STEP),
            "heights must be an array of real numbers, not 'ring.x3p'",
        ),
        (lambda: surface.height_statistics(None, STEP), "heights must be an array of real numbers, not None"),
        (
            lambda: surface.height_statistics([[1.0, 2.0], [3.0]], STEP),
            "heights must be an array of real numbers, not a list of unlike parts",
        ),
        (
            lambda: surface.height_statistics([1.0, None, 2.0], STEP),
            "heights must be an array of real numbers, not of objects",
        ),
        (
            lambda: surface.height_statistics(numpy.array([3, 4], "datetime64[s]"), STEP),
            "heights must be an array of real numbers",
        ),
        (lambda: surface.read(3), "path must be a str or a path, not of type int"),
        (
            lambda: surface.read(MEASURED / "ring_new.x3p", step_x=1e-6),
            'step_x must be a text such as "0.5 um", not of type float',
        ),
        (lambda: surface.read(MEASURED / "ring_new.x3p", channel=1.0), "channel must be a number from 1 or a name"),
        (lambda: fitted(tilt="2e-3"), "tilt must be a number, not '2e-3'"),
        (lambda: fitted(width=None), "width must be a number in m, not None"),
        (lambda: lateral_force.calibrate_on_silicon(line(), "V", 0.19), "reference must be two numbers"),
        (lambda: line().slope_half_width("95 %"), "confidence must be a number, not '95 %'"),
        (lambda: contact().pressure("1 um"), "h must be an array of real numbers, not '1 um'"),
        (
            lambda: laws.GreenwoodTripp(N=None, beta=1e-6, sigma=1e-6, E_prime=1e11),
            "N must be a number in 1/m2, not None",
        ),
        (lambda: surface.SpectralMoments("0", 1, 1), "m0_m2 must be a number in m2, not '0'"),
        (lambda: surface.SurfaceMeasures(0, 0, None), "moments must be a SpectralMoments, not None"),
        (lambda: surface.single_parameters(3), "surface must be a SurfaceMeasures, not of type int"),
        (lambda: surface.asperity_parameters((0, 1, 1), 1e-6), "moments must be a SpectralMoments, not of type tuple"),
        (lambda: lateral_force.calibrate_on_silicon(0.2, "V"), "silicon must be a LineFit, not of type float"),
        (lambda: lateral_force.boundary_shear_strengths([line()], None), "each of samples must be a ForceSample"),
        (lambda: lateral_force.boundary_shear_strengths([], None), "calibration must be a Calibration, not None"),
        (lambda: laws.oil("case.toml"), "case must be a Case, not 'case.toml'"),
    ],
)
def test_a_wrong_kind_is_stated_in_one_sentence(call, words):
    with pytest.raises(TypeError) as reported:
        call()
    assert words in str(reported.value)
    assert "\n" not in str(reported.value) and "pybind" not in str(reported.value).lower()


def line():
    return lateral_force.fit_line([1.0, 2.0, 3.0, 4.0], [1.1, 1.9, 3.2, 3.9])


def test_huge_integers_are_refused():
    with pytest.raises(ringfilm.InputError, match="beyond the range"):
        surface.height_statistics(HEIGHTS, 10**400)
    with pytest.raises(ringfilm.InputError, match="beyond the range"):
        surface.prepare(HEIGHTS, STEP, form="polynomial", degree=2**40)


def test_a_channel_may_be_a_number():
    path = MEASURED / "ring_new.x3p"
    assert (
        surface.read(path, channel=1) == surface.read(path) == surface.read(os.fsencode(path), channel=numpy.int64(1))
    )
    with pytest.raises(ringfilm.InputError, match="there is no channel 3"):
        surface.read(path, channel=3)


@pytest.mark.parametrize("path", ["a\udc80.x3p", "a\ud800.x3p", "a\0.x3p", b"\xff.x3p"])
@pytest.mark.parametrize("function", [surface.read, face.read_trace, lateral_force.read])
def test_paths_that_no_file_can_have(function, path):
    with pytest.raises(ringfilm.InputError, match="path = "):
        function(path)


def test_errors_of_files_name_the_arguments_of_the_function(tmp_path):
    table = tmp_path / "map.csv"
    table.write_text("\n".join(",".join(f"{v:.3f}" for v in row) for row in 1e7 * HEIGHTS))
    for stated, words in [
        ({}, 'height_unit="um"'),
        ({"height_unit": "kg"}, 'the stated unit of heights is "kg"'),
        ({"height_unit": "um"}, 'step_x="0.5 um"'),
        ({"height_unit": "um", "step_x": "5 kg"}, "the step along x"),
        ({"height_unit": "um", "step_x": "1 um", "channel": 7}, "channel=1"),
    ]:
        with pytest.raises(ringfilm.InputError) as reported:
            surface.read(table, **stated)
        assert words in str(reported.value) and "--" not in str(reported.value)
    with pytest.raises(ringfilm.InputError) as reported:
        lateral_force.read(MEASURED / "loops_silicon.csv", load_deviation="1 um")
    assert "load_deviation" in str(reported.value) and "--" not in str(reported.value)
    trace = tmp_path / "trace.csv"
    trace.write_text("\n".join(f"{v:.3f}" for v in 1e6 * GAP))
    with pytest.raises(ringfilm.InputError) as reported:
        face.read_trace(trace, height_unit="um")
    assert "step=" in str(reported.value) and "--" not in str(reported.value)


def test_a_text_is_read_as_its_reader_states(tmp_path):
    """Lines in front, a column that is not used, a number that marks a missing height."""
    heights = [0.1, -9999, 0.3, 0.2, -0.1, 0.05, 0.4, -0.2]
    rows = "".join(f"{7 * i % 5};{2 * i};{z}\n" for i, z in enumerate(heights))
    text = tmp_path / "profile.txt"
    text.write_text("Instrument: Surf\nOperator 7\n" + rows)
    stated = {"columns": "-, x [um], z [um]", "skip_lines": 2}
    for missing in (-9999, "-9999", [-9999.0, "none"]):
        found = surface.read(text, missing=missing, **stated)
        assert found.step[0] == pytest.approx(2e-6)
        assert numpy.flatnonzero(numpy.isnan(found.heights)).tolist() == [1]
        assert found.heights[2] == pytest.approx(0.3e-6)
    x, height = face.read_trace(text, missing=-9999, **stated)
    assert x.shape == height.shape == (7,)
    assert height[1] == pytest.approx(0.3e-6)
    with pytest.raises(ringfilm.InputError, match="skip_lines = -1 is not a number of lines"):
        surface.read(text, skip_lines=-1)
    with pytest.raises(TypeError, match="missing"):
        surface.read(text, missing={})


# --- values ---------------------------------------------------------------------------------------


def with_one(value):
    heights = HEIGHTS.copy()
    heights[3, 4] = value
    return heights


@pytest.mark.parametrize(
    "call, words",
    [
        (lambda: surface.height_statistics(with_one(numpy.inf), STEP), "column 5 of row 4 is not a number but inf"),
        (lambda: surface.height_statistics(numpy.zeros((0, 5)), STEP), "a map of 5 x 0 points has no heights"),
        (lambda: surface.height_statistics([], STEP), "has no heights"),
        (lambda: surface.height_statistics(3e-6, STEP), "0 dimensions"),
        (lambda: surface.moments(HEIGHTS * 1e207, STEP), "so large that"),
        (lambda: surface.row_roughness(HEIGHTS * 1e207, STEP), "so large that"),
        (lambda: surface.height_statistics(HEIGHTS / 1e-7 * 5e307, STEP), "so large that"),
        (lambda: surface.core_roughness(HEIGHTS), "curve has 2 dimensions"),
        (lambda: fitted([0.0], [0.0]), "the trace has too few points, 1"),
        (lambda: fitted(X.reshape(1, -1), GAP.reshape(1, -1)), "x has 2 dimensions"),
        (lambda: fitted(tilt=numpy.nan, levelling="stated"), "the tilt of the face is not a finite number"),
        (lambda: fitted(tilt=numpy.inf), "the tilt of the face is not a finite number"),
        (lambda: fitted(X, numpy.where(X == X[7], numpy.nan, GAP)), "point 8 has the height nan"),
        (lambda: lateral_force.loop_friction(PLACES, 1e200 * SIGNAL, SIGNAL), "so large that"),
        (lambda: lateral_force.read(), "no file is named"),
        (lambda: line().slope_half_width(1.5), "a confidence between 0 and 1 is required"),
        (lambda: line().slope_half_width(0), "a confidence between 0 and 1 is required"),
        (lambda: line().slope_half_width(numpy.nan), "a confidence between 0 and 1 is required"),
        (lambda: surface.gaussian_transmission(-1e-6, 1e-6), "not both positive lengths"),
        (lambda: surface.gaussian_transmission(1e-6, 0), "not both positive lengths"),
        (lambda: surface.SpectralMoments(numpy.nan, 1e-3, 1e8), "m0_m2 = nan"),
        (lambda: surface.SpectralMoments(0, -1e-3, 1e8), "m2 = -0.001"),
        (lambda: surface.SurfaceMeasures(-1, 1e-6, surface.SpectralMoments(0, 1e-3, 1e8)), "Sa_m = -1"),
        (lambda: laws.composite_modulus(-2e11, 0.3, 2e11, 0.3), "Young's modulus of -2e+11"),
        (lambda: laws.composite_modulus(2e11, 5, 2e11, 0.3), "Poisson's ratio of 5"),
        (lambda: laws.composite_modulus(2e11, 0.3, 2e11, numpy.nan), "Poisson's ratio of nan"),
        (lambda: laws.GreenwoodTripp(N=1e11, beta=1e-6, sigma=numpy.inf, E_prime=1e11), "sigma = inf"),
        (lambda: laws.Walther.fit([40, 100], [6e-5, 9e-6]), "temperatures are in kelvin: 313.15"),
        (
            lambda: laws.Walther.fit([313.15, 373.15], [6e-5, 9e-6]).kinematic_viscosity(40),
            "temperatures are in kelvin",
        ),
        (lambda: laws.Walther.fit([313.15, numpy.nan], [6e-5, 9e-6]), "nan K"),
    ],
)
def test_values_out_of_range_are_refused(call, words):
    with pytest.raises(ringfilm.InputError) as reported:
        call()
    assert words in str(reported.value)
    assert "boost" not in str(reported.value)


def test_contact_ends_far_away_and_continues_below_zero():
    pair = contact()
    assert pair.pressure(numpy.inf) == 0 and pair.area_share(numpy.inf) == 0 and pair.pressure_slope(numpy.inf) == 0
    assert numpy.isnan(pair.pressure(numpy.nan))
    # Along the tangent: a straight line, to rounding.
    below = pair.pressure(numpy.array([-1e-7, -2e-7]))
    assert below[0] == pytest.approx(pair.pressure(0) - 1e-7 * pair.pressure_slope(0), rel=1e-12)
    assert below[1] == pytest.approx(pair.pressure(0) - 2e-7 * pair.pressure_slope(0), rel=1e-12)


def test_a_rigid_body_leaves_the_other_alone():
    assert laws.composite_modulus(2e11, 0.3, numpy.inf, 0.3) == pytest.approx(2 * 2e11 / (1 - 0.3**2), rel=1e-14)
    assert laws.composite_modulus([2e11, 1e11], 0.3, 2e11, 0.3).shape == (2,)
