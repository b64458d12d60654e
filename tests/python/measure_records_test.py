"""What the functions on measured data give back: shown, compared, copied, pickled, and not to be written to."""

import copy
import pickle
import subprocess
import sys

import numpy
import pytest

from conftest import SOURCES
from ringfilm import face, lateral_force, laws, surface

MEASURED = SOURCES / "cases" / "measured"


def heights():
    return 1e-7 * numpy.random.default_rng(7).standard_normal((64, 64))


def two_steps():
    """A plateau of 0.1 um over valleys of 2 um in a tenth of the area."""
    generator = numpy.random.default_rng(7)
    z = 1e-7 * generator.standard_normal(40_000)
    z[:4000] = -2e-6 * numpy.abs(generator.standard_normal(4000))
    return numpy.sort(z)[::-1]


def fit():
    x = numpy.linspace(0, 1.2e-3, 601)
    # A step in the middle that no polynomial follows, so that shapes are invented.
    gap = 15e-6 * ((x - 0.6e-3) / 0.6e-3) ** 2 + 3e-6 * (x > 0.7e-3)
    return face.fit_face(x, gap, 1.2e-3, sense="gap", levelling="none")


def sample():
    return lateral_force.read(MEASURED / "loops_new.csv")[0]


def silicon():
    return lateral_force.read(MEASURED / "loops_silicon.csv")[0]


def calibration():
    return lateral_force.calibrate_on_silicon(silicon().line, silicon().load_unit)


def contact():
    return laws.GreenwoodTripp(N=0.1e12, beta=1.5e-6, sigma=0.5e-6, E_prime=1.4e11, integrals="polynomial-4-digit")


MADE = {
    "HeightStatistics": lambda: surface.height_statistics(heights(), 1e-6),
    "SampledHeights": lambda: surface.sampled_heights(heights()[0], 1e-6),
    "RowRoughness": lambda: surface.row_roughness(heights(), 1e-6),
    "CoreRoughness": lambda: surface.core_roughness(surface.material_ratio_curve(heights(), 1e-6)),
    "ProbabilityRoughness": lambda: surface.probability_roughness(two_steps()),
    "Cavities": lambda: surface.cavities(surface.material_ratio_curve(heights(), 1e-6)),
    "Summits": lambda: surface.count_summits(heights(), 1e-6),
    "SummitTheory": lambda: surface.summit_theory(1e-12, 1e-3, 1e8),
    "SpectralMoments": lambda: surface.moments(heights(), 1e-6),
    "SurfaceMeasures": lambda: surface.surface_measures(heights(), 1e-6),
    "AsperityParameters": lambda: surface.single_parameters(surface.surface_measures(heights(), 1e-6)),
    "FaceFit": fit,
    "FaceResidual": lambda: fit().spline_residual,
    "FitArtifact": lambda: fit().invented[0],
    "LoopFriction": lambda: lateral_force.loop_friction(
        numpy.linspace(0, 1e-6, 100), numpy.linspace(0.3, 0.31, 100), numpy.full(100, -0.1)
    ),
    "LoadFriction": lambda: sample().loads[0],
    "LineFit": lambda: sample().line,
    "ForceSample": sample,
    "Calibration": calibration,
    "ShearStrength": lambda: lateral_force.boundary_shear_strengths([sample()], calibration())[0][0],
    "Walther": lambda: laws.Walther.fit([313.15, 373.15], [6e-5, 9e-6]),
    "GreenwoodTripp": contact,
    "MeasuredMap": lambda: surface.read(MEASURED / "ring_new.x3p"),
}


@pytest.mark.parametrize("name", MADE)
def test_copies_and_pickles_are_the_same(name):
    one = MADE[name]()
    assert type(one).__name__ == name
    for other in [
        MADE[name](),
        *(pickle.loads(pickle.dumps(one, protocol)) for protocol in range(6)),
        copy.copy(one),
        copy.deepcopy(one),
    ]:
        assert other is not one
        assert other == one and not other != one
        assert repr(other) == repr(one)
        if hasattr(one, "to_dict"):
            numpy.testing.assert_equal(other.to_dict(), one.to_dict())
    assert one != 3 and one != "3" and one is not None
    assert "0x" not in repr(one)


@pytest.mark.parametrize("name", [name for name in MADE if hasattr(MADE[name](), "to_dict")])
def test_all_public_members_are_listed(name):
    one = MADE[name]()
    public = {member for member in vars(type(one)) if isinstance(vars(type(one))[member], property)}
    assert public == set(one.to_dict())
    for member in public:
        assert f"{member}=" in repr(one)


def test_other_values_are_not_the_same():
    assert surface.SpectralMoments(0, 1, 2) != surface.SpectralMoments(0, 1, 3)
    assert contact() != laws.GreenwoodTripp(N=0.1e12, beta=1.5e-6, sigma=0.5e-6, E_prime=1.4e11)
    assert laws.Walther.fit([313.15, 373.15], [6e-5, 9e-6]) != laws.Walther.fit([313.15, 373.15], [6e-5, 9.1e-6])
    x = numpy.linspace(0, 1.2e-3, 601)
    other = face.fit_face(x, 14e-6 * ((x - 0.6e-3) / 0.6e-3) ** 2, 1.2e-3, sense="gap", levelling="none")
    assert fit() != other
    one, two = surface.read(MEASURED / "ring_new.x3p"), surface.read(MEASURED / "liner.sur")
    assert one != two


def test_a_pickle_works_on_in_another_process(tmp_path):
    (tmp_path / "all.pickle").write_bytes(pickle.dumps([fit(), sample(), contact()]))
    reported = subprocess.run(
        [
            sys.executable,
            "-c",
            "import pickle, sys; fit, sample, contact = pickle.load(open(sys.argv[1], 'rb'));"
            "print(repr(fit.height(0.3e-3)), repr(sample.line.slope), repr(contact.pressure(1e-6)))",
            tmp_path / "all.pickle",
        ],
        capture_output=True,
        text=True,
        check=True,
    )
    assert reported.stdout.split() == [
        repr(fit().height(0.3e-3)),
        repr(sample().line.slope),
        repr(contact().pressure(1e-6)),
    ]


def test_what_is_hidden_travels_too():
    back = pickle.loads(pickle.dumps(sample()))
    given = lateral_force.boundary_shear_strengths([back], pickle.loads(pickle.dumps(calibration())))
    numpy.testing.assert_array_equal(given[1], lateral_force.boundary_shear_strengths([sample()], calibration())[1])


def test_a_pickle_of_something_else_is_refused():
    with pytest.raises(ValueError, match="another version"):
        surface.SpectralMoments.__new__(surface.SpectralMoments).__setstate__((1.0, 2.0))


@pytest.mark.parametrize(
    "array",
    [
        lambda: fit().x_m,
        lambda: fit().gap_m,
        lambda: fit().spline_m,
        lambda: fit().coefficients,
        lambda: pickle.loads(pickle.dumps(fit())).gap_m,
        lambda: surface.read(MEASURED / "ring_new.x3p").heights,
        lambda: copy.copy(surface.read(MEASURED / "ring_new.x3p")).heights,
    ],
)
def test_arrays_cannot_be_written_to(array):
    of = array()
    assert not of.flags.writeable
    with pytest.raises(ValueError):
        of[0] = 1.0
    own = of.copy()
    own[0] = 1.0


def test_an_array_outlives_what_it_belongs_to():
    expected = fit().gap_m.copy()
    kept = fit().gap_m
    numpy.testing.assert_array_equal(kept, expected)


def test_what_laws_show_of_themselves(case):
    assert repr(contact()) == (
        "GreenwoodTripp(N=100000000000.0, beta=1.5e-06, sigma=5e-07, E_prime=140000000000.0, "
        "integrals='polynomial-4-digit')"
    )
    assert eval(repr(contact()), vars(laws)) == contact()
    assert repr(laws.Walther.fit([313.15, 373.15], [6e-5, 9e-6])).startswith("Walther(A=")
    oil = laws.oil(case)
    assert repr(oil).startswith("<ringfilm.laws.Oil at ") and f"{oil.temperature - 273.15:.6g} degC" in repr(oil)
