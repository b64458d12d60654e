"""Surfaces, faces, friction loops and laws on numpy arrays, against answers that are known otherwise."""

import pickle

import numpy
import pytest

import ringfilm
from conftest import SOURCES

MEASURED = SOURCES / "cases" / "measured"


def waves(n=256, step=1e-6, amplitude=1e-6, period=32):
    x = numpy.arange(n) * step
    return amplitude * numpy.sin(2 * numpy.pi * x / (period * step))[None, :] * numpy.ones((64, 1)), step


def test_heights_of_a_sine():
    heights, step = waves()
    reported = ringfilm.surface.height_statistics(heights, step)
    # Whole periods: the mean square of a sampled sine is exact, its mean absolute value to the square of the step.
    assert reported.Sq_m == pytest.approx(1e-6 / numpy.sqrt(2), rel=1e-12)
    assert reported.Sa_m == pytest.approx(2e-6 / numpy.pi, rel=1e-2)
    assert reported.points == heights.size and reported.missing == 0
    assert reported.Sku == pytest.approx(1.5, rel=1e-12)
    assert "Sq_m" in repr(reported) and reported.to_dict()["Sq_m"] == reported.Sq_m


def test_rz_of_a_profile_is_a_mean_over_sampling_lengths():
    profile = numpy.zeros(100)
    profile[5::20] = [1e-6, 2e-6, 3e-6, 4e-6, 5e-6]
    of = ringfilm.surface.sampled_heights(profile, 1e-6)
    assert of.Rz_m == pytest.approx(3e-6, rel=1e-12) and of.count == 5
    assert ringfilm.surface.height_statistics(profile, 1e-6).Sz_m == pytest.approx(5e-6, rel=1e-12)
    of = ringfilm.surface.sampled_heights(profile, 1e-6, sampling_length=50e-6)
    assert of.Rz_m == pytest.approx((3e-6 + 5e-6) / 2, rel=1e-12) and of.sampling_length_m == 50e-6


def test_missing_points_are_nan():
    heights, step = waves()
    heights[10, 20] = numpy.nan
    assert ringfilm.surface.height_statistics(heights, step).missing == 1
    level = ringfilm.surface.prepare(heights, step)
    assert numpy.isnan(level[10, 20]) and numpy.isnan(level).sum() == 1


def test_a_tilt_is_removed_and_the_input_is_left_alone():
    heights, step = waves()
    tilted = heights + 1e-3 * step * numpy.arange(256)
    before = tilted.copy()
    level = ringfilm.surface.prepare(tilted, step, form="polynomial", degree=1)
    numpy.testing.assert_array_equal(tilted, before)
    # A plane of least squares, by numpy.
    design = numpy.stack([numpy.ones(256), numpy.arange(256)], axis=1)
    fit = design @ numpy.linalg.lstsq(design, tilted[0], rcond=None)[0]
    numpy.testing.assert_allclose(level[0], tilted[0] - fit, atol=1e-12)


def test_half_of_a_wave_passes_at_the_cutoff():
    heights, step = waves(n=1024, period=64)
    smooth = ringfilm.surface.prepare(heights, step, form="none", short_cutoff=64e-6)
    middle = slice(256, 768)
    assert smooth[32, middle].std() / heights[32, middle].std() == pytest.approx(0.5, rel=1e-3)
    assert ringfilm.surface.gaussian_transmission(64e-6, 64e-6) == pytest.approx(0.5, rel=1e-9)
    assert ringfilm.surface.gaussian_transmission(numpy.array([1e-3, 64e-6]), 64e-6).shape == (2,)


def test_moments_of_a_sine_are_those_of_its_differences():
    heights, step = waves()
    got = ringfilm.surface.moments(heights, step, direction="x")
    slopes = numpy.diff(heights, axis=1) / step
    curvatures = numpy.diff(heights, 2, axis=1) / step**2
    assert got.m2 == pytest.approx((slopes**2).mean(), rel=1e-9)
    assert got.m4_per_m2 == pytest.approx((curvatures**2).mean(), rel=1e-9)


def test_density_and_radius_come_back_from_their_moments():
    of = ringfilm.surface.moments_of(1e11, 1.5e-6)
    back = ringfilm.surface.asperity_parameters(of, 0.5e-6)
    assert (back.density_per_m2, back.beta_m, back.sigma_m) == pytest.approx((1e11, 1.5e-6, 0.5e-6), rel=1e-12)
    assert back.roughness_parameter() == pytest.approx(1e11 * 1.5e-6 * 0.5e-6)


def test_a_pair_is_the_sum_of_both():
    one = ringfilm.surface.SurfaceMeasures(0.3e-6, 0.4e-6, ringfilm.surface.SpectralMoments(0, 1e-3, 1e8))
    two = ringfilm.surface.SurfaceMeasures(0.4e-6, 0.5e-6, ringfilm.surface.SpectralMoments(0, 2e-3, 2e8))
    pair = ringfilm.surface.pair_parameters(one, two, rule="ra")
    assert pair.sigma_m == pytest.approx(0.5e-6, rel=1e-12)
    both = ringfilm.surface.asperity_parameters(ringfilm.surface.SpectralMoments(0, 3e-3, 3e8), 0.5e-6)
    assert pair.beta_m == pytest.approx(both.beta_m, rel=1e-12)


def test_files_of_instruments():
    ring = ringfilm.surface.read(MEASURED / "ring_new.x3p")
    assert ring.heights.ndim == 2 and ring.step[0] > 0 and ring.plausibility
    level = ringfilm.surface.prepare(ring.heights, ring.step, form="cylinder", long_cutoff=80e-6)
    assert 0 < ringfilm.surface.height_statistics(level, ring.step).Sq_m < 5e-6
    curve = ringfilm.surface.material_ratio_curve(level, ring.step)
    assert (numpy.diff(curve) <= 0).all()
    assert ringfilm.surface.core_roughness(curve).Rk_m > 0
    with pytest.raises(ringfilm.InputError):
        ringfilm.surface.read(MEASURED / "nothing.x3p")


def test_words_that_are_not_known_are_refused():
    heights, step = waves()
    with pytest.raises(ringfilm.InputError, match="choose one of"):
        ringfilm.surface.prepare(heights, step, form="tild")
    with pytest.raises(ringfilm.InputError, match="dimensions"):
        ringfilm.surface.height_statistics(numpy.zeros((2, 3, 4)), step)
    with pytest.raises(ringfilm.InputError):
        ringfilm.surface.height_statistics(heights, -1.0)


def test_a_face_gives_back_the_parabola_that_made_it():
    width, crown = 1.2e-3, 15e-6
    x = numpy.linspace(0, width, 601)
    gap = crown * ((x - width / 2) / (width / 2)) ** 2
    fit = ringfilm.face.fit_face(x, gap, width, sense="gap", levelling="none")
    numpy.testing.assert_allclose(fit.height(x), gap, atol=1e-11)
    assert fit.coefficients.shape == (7,)
    # Height in um of x in mm: the square term of the parabola.
    assert fit.coefficients[-3] == pytest.approx(crown * 1e6 / 0.6**2, rel=1e-6)
    assert fit.polynomial_residual.rms_m < 1e-12


def test_a_face_from_a_file():
    x, height = ringfilm.face.read_trace(MEASURED / "face_new.csv")
    assert x.shape == height.shape and (numpy.diff(x) > 0).all()


def test_a_friction_loop():
    x = numpy.linspace(0, 1e-6, 200)
    loop = ringfilm.lateral_force.loop_friction(x, 0.3 + 0 * x, -0.1 + 0 * x)
    assert loop.tmr_V == pytest.approx(0.2) and loop.offset_V == pytest.approx(0.1)
    assert loop.points < 200


def test_a_line_is_that_of_numpy():
    x = numpy.array([1.0, 2.0, 3.0, 4.0])
    y = numpy.array([1.1, 1.9, 3.2, 3.9])
    line = ringfilm.lateral_force.fit_line(x, y)
    slope, offset = numpy.polyfit(x, y, 1)
    assert (line.slope, line.offset) == pytest.approx((slope, offset), rel=1e-12)


def test_shear_strength_from_loops():
    silicon = ringfilm.lateral_force.read(MEASURED / "loops_silicon.csv")[0]
    calibration = ringfilm.lateral_force.calibrate_on_silicon(silicon.line, silicon.load_unit)
    assert calibration.psi == pytest.approx(0.19 / silicon.line.slope, rel=1e-12)
    samples = ringfilm.lateral_force.read(MEASURED / "loops_new.csv", MEASURED / "loops_run_in.csv")
    strengths, covariance = ringfilm.lateral_force.boundary_shear_strengths(samples, calibration)
    assert covariance.shape == (2, 2)
    assert strengths[0].zeta == pytest.approx(calibration.psi * samples[0].line.slope, rel=1e-12)
    assert strengths[0].deviation() == pytest.approx(numpy.sqrt(covariance[0, 0]), rel=1e-12)


def test_a_sample_is_not_its_own_calibration(tmp_path):
    loops = (MEASURED / "loops_silicon.csv").read_text()
    (tmp_path / "copy.csv").write_text(loops + "\n")
    silicon, copied = (
        ringfilm.lateral_force.read(path)[0] for path in (MEASURED / "loops_silicon.csv", tmp_path / "copy.csv")
    )
    calibration = ringfilm.lateral_force.calibrate_on_silicon(silicon.line, silicon.load_unit)
    for same in (calibration, pickle.loads(pickle.dumps(calibration))):
        with pytest.raises(ringfilm.InputError, match="it is calibrated on itself"):
            ringfilm.lateral_force.boundary_shear_strengths([copied], same)


def test_the_gaussian_integral_is_that_of_quadrature():
    lam = numpy.array([0.0, 0.5, 2.0])
    got = ringfilm.laws.gaussian_integral(2.5, lam)
    s = numpy.linspace(0, 12, 200_001)
    for value, at in zip(got, lam):
        expected = numpy.trapz((s) ** 2.5 * numpy.exp(-((s + at) ** 2) / 2), s) / numpy.sqrt(2 * numpy.pi)
        # Trapezia on a power of 5/2: third order at the end, below 1e-8 here.
        assert value == pytest.approx(expected, rel=1e-7)


def test_contact_follows_its_formula():
    E = ringfilm.laws.composite_modulus(203e9, 0.3, 92.3e9, 0.211)
    assert E == pytest.approx(2 / ((1 - 0.3**2) / 203e9 + (1 - 0.211**2) / 92.3e9), rel=1e-14)
    contact = ringfilm.laws.GreenwoodTripp(N=0.097e12, beta=1.56e-6, sigma=0.48e-6, E_prime=E)
    h = numpy.array([[0.5e-6, 1e-6], [1.5e-6, 2e-6]])
    roughness_parameter = 0.097e12 * 1.56e-6 * 0.48e-6
    expected = 8 * numpy.sqrt(2) / 15 * numpy.pi * roughness_parameter**2 * numpy.sqrt(0.48 / 1.56) * E
    numpy.testing.assert_allclose(
        contact.pressure(h), expected * ringfilm.laws.gaussian_integral(2.5, h / 0.48e-6), rtol=1e-9
    )
    assert (contact.pressure_slope(h) < 0).all() and contact.area_share(h).shape == (2, 2)


def test_closed_laws_have_their_published_values():
    def at(**choice):
        of = ringfilm.laws.summit_contact([1.286 * 0.48e-6], 0.097e12, 1.56e-6, 0.48e-6, 134.8e9, **choice)
        return of["contact_pressure"][0], of["real_area"][0]

    as_fed = at(model="greenwood-tripp", summit_plane="surface")
    closed = ringfilm.laws.GreenwoodTripp(0.097e12, 1.56e-6, 0.48e-6, 134.8e9)
    assert as_fed[0] == pytest.approx(closed.pressure(1.286 * 0.48e-6), rel=1e-6)
    pressure, area = at()
    assert pressure == pytest.approx(486.86444e6, rel=1e-5) and area == pytest.approx(0.03263409, rel=1e-5)
    assert at(asperity="zhao-maietta-chang", hardness=2.5e9)[0] < 0.5 * pressure
    with pytest.raises(ringfilm.InputError, match="hardness"):
        at(model="plastic")
    with pytest.raises(ringfilm.InputError, match="model"):
        at(model="hertz")


def test_the_flow_through_a_measured_gap_and_its_pairs():
    heights, step = waves(amplitude=0.6e-6)
    law = ringfilm.surface.contact_law(heights, step, [1e-6], 134.8e9, edges="periodic", flow_factors=True)
    e = 0.6
    assert law["phi_x"][0] == pytest.approx((1 - e * e) ** 2.5 / (1 + e * e / 2), rel=1e-3)
    assert law["phi_fp"][0] == pytest.approx((1 - e * e) / (1 + e * e / 2), rel=2e-2)
    assert {pair["state"] for pair in ringfilm.pairs()} == {"lubricated", "dry"}


def test_a_small_wave_lifts_a_land_by_its_closed_form():
    width, e, s = 100e-6, 0.02e-6, 2e-6
    x = numpy.arange(96) / 96
    heights = numpy.tile(-e * numpy.sin(2 * numpy.pi * x), (24, 1))
    of = ringfilm.surface.land_film(heights, width / 96, [s], width, 8.0, 6e-3, edges="periodic")
    assert of["lift"][0] == pytest.approx(6 * 6e-3 * 8 * e * width / (2 * numpy.pi * s**3), rel=3e-3)
    assert of["friction_stress"][0] == pytest.approx(6e-3 * 8 / s, rel=1e-3)
    with pytest.raises(ringfilm.InputError, match="touch"):
        ringfilm.surface.land_film(heights, width / 96, [0.01e-6], width, 8.0, 6e-3)


def test_the_classes_of_surfaces_are_lists_of_liners_and_rings():
    classes = ringfilm.surface_classes()
    assert list(classes) == ["liners", "rings"]
    assert {one["state"] for group in classes.values() for one in group} == {"new", "run-in", "worn"}
    assert all(liner["Rpq"] < liner["Rvq"] for liner in classes["liners"])


def test_the_oil_of_a_case(case):
    oil = ringfilm.laws.oil(case)
    p = numpy.array([1e5, 1e7, 1e8])
    assert (numpy.diff(oil.viscosity(p)) > 0).all() and (numpy.diff(oil.density(p)) > 0).all()
    walther = ringfilm.laws.Walther.fit([313.15, 373.15], [59.99e-6, 9.59e-6])
    numpy.testing.assert_allclose(walther.kinematic_viscosity([313.15, 373.15]), [59.99e-6, 9.59e-6], rtol=1e-10)
