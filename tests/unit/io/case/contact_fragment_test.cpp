#include "ringfilm/io/case/contact_fragment.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../case_example.hpp"

namespace ringfilm::io {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

/// Fragments carry 8 digits.
constexpr double kDigits = 1e-7;

PairOfSurfaces pair_of_surfaces() {
  PairOfSurfaces pair;
  pair.asperity_density = 0.0971234e12;
  pair.asperity_radius = 1.5612345e-6;
  pair.roughness = 0.48123e-6;
  cycle::MeasuredContact& m = pair.measured;
  m.ring_surface = "new \"ring\".x3p, channel 1";
  m.liner_surface = "liner.sur";
  m.filter = "plane, Gaussian ISO 16610-61";
  m.long_cutoff = 0.8e-3;
  m.short_cutoff = 2.5e-6;
  m.step = 0.5e-6;
  m.roughness_rule = "Ra, root-sum-square";
  m.difference_scheme = "central, 3 points";
  m.regions = 12;
  m.asperity_density_deviation = 0.011e12;
  m.asperity_radius_deviation = 0.2e-6;
  m.roughness_deviation = 0.05e-6;
  m.density_radius_correlation = -0.61234567;
  m.density_roughness_correlation = 0.1;
  m.radius_roughness_correlation = -0.5;
  return pair;
}

surface::ShearStrength shear_strength() {
  surface::ShearStrength s;
  s.sample = "new ring";
  s.zeta = 0.35812345;
  s.slope_deviation = 0.01;
  s.calibration_deviation = 0.008;
  s.reference_deviation = 0.0596;
  return s;
}

surface::Trace face_trace() {
  surface::Trace trace;
  for (int i = 0; i <= 300; ++i) {
    const double x = 1.2e-3 * i / 300, t = x / 0.6e-3 - 1;
    trace.x_m.push_back(x);
    trace.height_m.push_back(15e-6 * t * t + 2e-6 * t * t * t + 3e-6);
  }
  return trace;
}

surface::FaceRule face_rule() {
  surface::FaceRule rule;
  rule.sense = surface::HeightSense::kGap;
  rule.width_m = 1.2e-3;
  rule.levelling = surface::FaceLevelling::kNone;
  return rule;
}

/// A case without the sections that fragments bring.
CaseText bare_case(const std::string& includes) {
  CaseText text;
  text.top += "include = [" + includes + "]\n";
  text.contact = text.face = "";
  return text;
}

TEST(ContactFragment, IsReadBackByACaseThatIncludesIt) {
  const surface::FaceFit fit = surface::fit_face(face_trace(), face_rule());
  const CaseFolder folder(bare_case("\"pair.toml\", \"face.toml\", \"zeta.toml\""));
  folder.write("pair.toml", contact_fragment(pair_of_surfaces(), {"N, beta, sigma of a pair", "two\nlines"}));
  folder.write("face.toml", face_polynomial_fragment(fit, face_rule(), "new.csv", {}));
  folder.write("zeta.toml", shear_strength_fragment(shear_strength(), "loops.csv", surface::CalibrationMethod::kSilicon,
                                                    "silicon, tip 4", {"zeta"}));
  const cycle::Case c = folder.read();
  const PairOfSurfaces pair = pair_of_surfaces();
  EXPECT_NEAR(c.contact.asperity_density / pair.asperity_density, 1, kDigits);
  EXPECT_NEAR(c.contact.asperity_radius / pair.asperity_radius, 1, kDigits);
  EXPECT_NEAR(c.contact.roughness / pair.roughness, 1, kDigits);
  const cycle::MeasuredContact &m = c.contact.measured, &w = pair.measured;
  EXPECT_EQ(m.ring_surface, w.ring_surface);
  EXPECT_EQ(m.liner_surface, w.liner_surface);
  EXPECT_EQ(m.filter, w.filter);
  EXPECT_NEAR(*m.long_cutoff / *w.long_cutoff, 1, kDigits);
  EXPECT_NEAR(*m.short_cutoff / *w.short_cutoff, 1, kDigits);
  EXPECT_NEAR(*m.step / *w.step, 1, kDigits);
  EXPECT_EQ(m.roughness_rule, w.roughness_rule);
  EXPECT_EQ(m.difference_scheme, w.difference_scheme);
  EXPECT_EQ(m.regions, w.regions);
  EXPECT_NEAR(*m.asperity_density_deviation / *w.asperity_density_deviation, 1, kDigits);
  EXPECT_NEAR(*m.asperity_radius_deviation / *w.asperity_radius_deviation, 1, kDigits);
  EXPECT_NEAR(*m.roughness_deviation / *w.roughness_deviation, 1, kDigits);
  EXPECT_NEAR(*m.density_radius_correlation, *w.density_radius_correlation, kDigits);
  EXPECT_EQ(m.density_roughness_correlation, w.density_roughness_correlation);
  EXPECT_EQ(m.radius_roughness_correlation, w.radius_roughness_correlation);
  EXPECT_NEAR(c.contact.boundary_shear_strength_coefficient, 0.35812345, kDigits);
  EXPECT_EQ(m.shear_strength.loops, "loops.csv, new ring");
  EXPECT_EQ(m.shear_strength.method, "silicon");
  EXPECT_EQ(m.shear_strength.calibration, "silicon, tip 4");
  EXPECT_EQ(m.shear_strength.slope_deviation, 0.01);
  EXPECT_EQ(m.shear_strength.calibration_deviation, 0.008);
  EXPECT_EQ(m.shear_strength.reference_deviation, 0.0596);
  EXPECT_EQ(c.ring.face.form, cycle::FaceForm::kPolynomial);
  EXPECT_EQ(c.ring.face.coefficients, fit.polynomial.coefficients_mm_um());
  EXPECT_EQ(c.ring.face.length_unit, 1e-3);
  EXPECT_EQ(c.ring.face.height_unit, 1e-6);
  EXPECT_EQ(c.ring.face.measured.trace, "new.csv");
  // The record of the run holds it all.
  const std::string resolved = resolved_case(c);
  for (const char* line :
       {"regions = 12", "calibration = \"silicon, tip 4\"", "density_radius_correlation = -0.61234567"}) {
    EXPECT_THAT(resolved, HasSubstr(line));
  }
}

TEST(ContactFragment, GivesTheSplineOfAFaceAsPoints) {
  const surface::FaceFit fit = surface::fit_face(face_trace(), face_rule());
  const CaseFolder folder(bare_case("\"pair.toml\", \"parts.toml\", \"zeta.toml\""));
  folder.write("pair.toml", contact_fragment(pair_of_surfaces(), {}));
  folder.write("zeta.toml", shear_strength_fragment(shear_strength(), "loops.csv", surface::CalibrationMethod::kWedge,
                                                    "grating", {}));
  folder.write("parts.toml", face_points_fragment(fit, face_rule(), "new.csv", "points.csv", {}));
  folder.write("points.csv", face_points_csv(fit));
  const cycle::Case c = folder.read();
  ASSERT_EQ(c.ring.face.x.size(), fit.x_m.size());
  EXPECT_EQ(c.ring.face.x.back(), c.ring.face_width);
  // Nine digits of 20 um.
  for (std::size_t i = 0; i < fit.x_m.size(); ++i) EXPECT_NEAR(c.ring.face.height[i], fit.spline_m[i], 1e-13);
}

TEST(ContactFragment, HoldsForTheWidthThatWasFittedOnly) {
  const surface::FaceFit fit = surface::fit_face(face_trace(), face_rule());
  const auto faults = [&](const std::string& width) {
    CaseText text;
    text.top += "include = [\"face.toml\"]\n";
    text.face = "";
    text.ring = "[ring]\nface_width = \"" + width + "\"\nelastic_pressure = \"0.2 MPa\"\n";
    const CaseFolder folder(text);
    folder.write("face.toml", face_polynomial_fragment(fit, face_rule(), "new.csv", {}));
    return folder.faults();
  };
  EXPECT_EQ(faults("1.2 mm"), "");
  EXPECT_EQ(faults("1200.00001 um"), "");
  for (const char* other : {"1.5 mm", "1.1 mm"}) {
    EXPECT_THAT(faults(other), HasSubstr("but the face was fitted over 1.2 mm (ring.face.measured.width)"));
  }
}

TEST(ContactFragment, ReportsWhereThePolynomialInventsShape) {
  surface::FaceFit fit = surface::fit_face(face_trace(), face_rule());
  EXPECT_THAT(face_polynomial_fragment(fit, face_rule(), "a.csv", {}), Not(HasSubstr("fit_artifact")));
  fit.invented.push_back({1.14e-3, 1.2e-3, surface::InventionReason::kFallsTowardsTheEdge, 0.3e-6});
  EXPECT_THAT(face_polynomial_fragment(fit, face_rule(), "a.csv", {}),
              HasSubstr("fit_artifact = \"x = 1.14 to 1.2 mm: the gap falls by 0.3 um towards the edge"));
}

TEST(ContactFragment, APlateauComesBackInPlaceOfTheRoughness) {
  PairOfSurfaces pair = pair_of_surfaces();
  pair.plateau.emplace();
  pair.plateau->Rpq = 0.08123456e-6;
  pair.plateau->Rvq = 0.9123e-6;
  pair.plateau->Rmq = 0.8234567;
  pair.plateau->ring_roughness = 0.1e-6;
  pair.plateau->surface_roughness = 0.4e-6;
  pair.plateau->offset = 0.09e-6;
  CaseText text = bare_case("\"pair.toml\"");
  text.contact = "[contact]\nboundary_shear_strength_coefficient = 0.3\n";
  text.face = CaseText().face;
  const CaseFolder folder(text);
  folder.write("pair.toml", contact_fragment(pair, {}));
  const cycle::Contact read = folder.read().contact;
  EXPECT_NEAR(*read.plateau.Rpq / *pair.plateau->Rpq, 1, kDigits);
  EXPECT_NEAR(*read.plateau.Rmq / *pair.plateau->Rmq, 1, kDigits);
  EXPECT_NEAR(*read.plateau.offset / *pair.plateau->offset, 1, kDigits);
  EXPECT_NEAR(read.plateau.ring_roughness / pair.plateau->ring_roughness, 1, kDigits);
  EXPECT_EQ(read.roughness, 0);
  EXPECT_FALSE(read.measured.roughness_deviation);
  EXPECT_TRUE(read.measured.asperity_density_deviation);
  EXPECT_THAT(plateau_fragment(*pair.plateau, {"liner"}),
              AllOf(HasSubstr("# liner\n"), Not(HasSubstr("ring_roughness"))));
}

TEST(ContactFragment, AKeyInFragmentAndCaseNamesBothPlaces) {
  CaseText text = bare_case("\"pair.toml\"");
  text.contact = "[contact]\nroughness = \"0.5 um\"\nboundary_shear_strength_coefficient = 0.3\n";
  text.face = CaseText().face;
  const CaseFolder folder(text);
  folder.write("pair.toml", contact_fragment(pair_of_surfaces(), {}));
  const std::string reported = folder.faults();
  EXPECT_THAT(reported, HasSubstr("contact.roughness is given twice"));
  EXPECT_THAT(reported, HasSubstr("delete line 4 of pair.toml or line "));
}

TEST(MeasuredContact, IsRefusedWhereItCannotBe) {
  const auto reported = [](const std::string& more) {
    CaseText text;
    text.more = more;
    return faults_of(text);
  };
  EXPECT_EQ(reported("[contact.measured]\nstep = \"1 um\"\nshort_cutoff = \"2.5 um\"\nlong_cutoff = \"0.8 mm\"\n"), "");
  EXPECT_THAT(reported("[contact.measured]\nshort_cutoff = \"2 mm\"\nlong_cutoff = \"0.8 mm\"\n"),
              HasSubstr("is not below"));
  EXPECT_THAT(reported("[contact.measured]\nstep = \"3 um\"\nshort_cutoff = \"2 um\"\n"), HasSubstr("is above"));
  EXPECT_THAT(reported("[contact.measured]\nregions = 2.5\n"), HasSubstr("is not a whole number"));
  EXPECT_THAT(reported("[contact.measured]\ndensity_radius_correlation = 0.5\n"),
              HasSubstr("standard deviations of both"));
  const std::string deviations =
      "asperity_density_deviation = \"0.01 um-2\"\nasperity_radius_deviation = \"0.1 um\"\n"
      "roughness_deviation = \"0.01 um\"\n";
  EXPECT_THAT(reported("[contact.measured]\n" + deviations +
                       "density_radius_correlation = 0.9\ndensity_roughness_correlation = 0.9\n"
                       "radius_roughness_correlation = -0.9\n"),
              HasSubstr("cannot hold at once"));
  EXPECT_THAT(reported("[contact.measured.shear_strength]\nmethod = \"guess\"\n"), HasSubstr("\"guess\" is unknown"));
  EXPECT_THAT(reported("[contact.measured.shear_strength]\nreference_deviation = 0.1\n"),
              HasSubstr("calibration is missing"));
}

TEST(Coating, AsksForItsPoissonsRatioAndAUse) {
  const auto reported = [](const std::string& more) {
    CaseText text;
    text.more = more;
    return faults_of(text);
  };
  EXPECT_EQ(reported("[ring.coating]\nyoungs_modulus = \"280 GPa\"\npoissons_ratio = 0.3\nthickness = \"100 um\"\n"),
            "");
  EXPECT_THAT(reported("[ring.coating]\nyoungs_modulus = \"280 GPa\"\n"),
              HasSubstr("the key ring.coating.poissons_ratio is missing"));
  EXPECT_THAT(reported("[ring.coating]\nthickness = \"100 um\"\n"), HasSubstr("ring.coating.thickness is not used"));
  CaseText text;
  text.contact += "composite_modulus = \"190 GPa\"\n";
  text.more = "[ring.coating]\nyoungs_modulus = \"280 GPa\"\n";
  EXPECT_THAT(faults_of(text), HasSubstr("ring.coating.youngs_modulus is not used"));
}

}  // namespace
}  // namespace ringfilm::io
