#include "ringfilm/io/case/contact_fragment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_value_text.hpp"

namespace ringfilm::io {
namespace {

std::string comments(const std::vector<std::string>& heading) {
  std::string text;
  for (std::string line : heading) {
    for (char& c : line) {
      if (static_cast<unsigned char>(c) < 0x20 || c == '\x7f') c = ' ';
    }
    text += "# " + line + "\n";
  }
  return text;
}

/// The keys of the table that `requested` names (whole sections end in a dot) and for which `c` has a value.
std::string fragment(const cycle::Case& c, const std::vector<std::string>& requested,
                     const std::vector<std::string>& heading) {
  const Units units;
  std::string text = comments(heading), section;
  for (const cycle::Field& field : cycle::case_fields()) {
    const bool is_requested = std::ranges::any_of(requested, [&](const std::string& key) {
      return key.back() == '.' ? field.key.starts_with(key) : field.key == key;
    });
    if (!is_requested || !cycle::is_active(field, c)) continue;
    const std::string value = written_value(field, c, units);
    if (value.empty()) continue;
    const std::size_t dot = field.key.rfind('.');
    if (field.key.substr(0, dot) != section) {
      section = field.key.substr(0, dot);
      text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    }
    text += fmt::format("{} = {}\n", field.key.substr(dot + 1), value);
  }
  return text;
}

std::string name_of(surface::FaceLevelling levelling) {
  switch (levelling) {
    case surface::FaceLevelling::kNone:
      return "as measured";
    case surface::FaceLevelling::kStated:
      return "stated tilt";
    case surface::FaceLevelling::kRunningSurface:
      return "running surface level";
  }
  throw std::logic_error("a rule of levelling without a name");
}

cycle::MeasuredFace measured_face(const surface::FaceFit& fit, const surface::FaceRule& rule,
                                  const std::string& trace_name, const surface::FaceResidual& residual) {
  cycle::MeasuredFace measured;
  measured.trace = trace_name;
  measured.width = rule.width_m;
  measured.levelling = fmt::format("{}, {} removed", name_of(rule.levelling), text_in(fit.tilt, kMilliradian));
  measured.residual_rms = residual.rms_m;
  measured.largest_residual = std::abs(residual.largest_m);
  return measured;
}

}  // namespace

std::string contact_fragment(const PairOfSurfaces& pair, const std::vector<std::string>& heading) {
  cycle::Case c;
  c.contact.asperity_density = pair.asperity_density;
  c.contact.asperity_radius = pair.asperity_radius;
  c.contact.roughness = pair.roughness;
  c.contact.roughness_measure = pair.roughness_measure;
  c.contact.measured = pair.measured;
  c.contact.measured.shear_strength = {};
  std::vector<std::string> keys = {"contact.asperity_density", "contact.asperity_radius", "contact.roughness",
                                   "contact.roughness_measure", "contact.measured."};
  if (pair.plateau) {
    c.contact.plateau = *pair.plateau;
    keys.push_back("contact.plateau.");
    cycle::MeasuredContact& measured = c.contact.measured;  // the scatter of a roughness that is not stated
    measured.roughness_deviation.reset();
    measured.density_roughness_correlation.reset();
    measured.radius_roughness_correlation.reset();
  }
  if (pair.hardness) {
    c.contact.model = cycle::ContactLaw::kGreenwoodWilliamson;
    c.contact.asperity = cycle::AsperityLaw::kZhaoMaiettaChang;
    c.contact.summit_plane = cycle::SummitPlane::kNayak;
    c.contact.hardness = pair.hardness;
    keys.insert(keys.end(), {"contact.model", "contact.asperity", "contact.summit_plane", "contact.hardness"});
  }
  return fragment(c, keys, heading);
}

std::string plateau_fragment(const cycle::Plateau& plateau, const std::vector<std::string>& heading) {
  cycle::Case c;
  c.contact.plateau = plateau;
  return fragment(c,
                  {"contact.plateau.Rpq", "contact.plateau.Rvq", "contact.plateau.Rmq",
                   "contact.plateau.surface_roughness", "contact.plateau.offset"},
                  heading);
}

std::string contact_law_fragment(const std::string& law_name, const std::vector<std::string>& heading) {
  cycle::Case c;
  c.contact.model = cycle::ContactLaw::kTable;
  c.contact.law_file = law_name;
  c.film.flow_factors = c.film.shear_flow = c.film.stress_factors = cycle::Roughness::kMeasured;
  c.film.average_gap = cycle::AverageGap::kMeasured;
  return fragment(c,
                  {"contact.model", "contact.law", "film.flow_factors", "film.shear_flow", "film.stress_factors",
                   "film.average_gap"},
                  heading);
}

std::string face_polynomial_fragment(const surface::FaceFit& fit, const surface::FaceRule& rule,
                                     const std::string& trace_name, const std::vector<std::string>& heading) {
  cycle::Case c;
  cycle::RingFace& face = c.ring.face;
  face.form = cycle::FaceForm::kPolynomial;
  face.coefficients = fit.polynomial.coefficients_mm_um();
  face.length_unit = 1e-3;
  face.height_unit = 1e-6;
  face.measured = measured_face(fit, rule, trace_name, fit.polynomial_residual);
  std::string words;
  for (const surface::FitArtifact& shape : fit.invented) words += (words.empty() ? "" : "; ") + shape.words();
  if (!words.empty()) face.measured.fit_artifact = words;
  return fragment(c,
                  {"ring.face.form", "ring.face.coefficients", "ring.face.length_unit", "ring.face.height_unit",
                   "ring.face.measured."},
                  heading);
}

std::string face_points_fragment(const surface::FaceFit& fit, const surface::FaceRule& rule,
                                 const std::string& trace_name, const std::string& points_file,
                                 const std::vector<std::string>& heading) {
  cycle::Case c;
  cycle::RingFace& face = c.ring.face;
  face.form = cycle::FaceForm::kPoints;
  face.points_file = points_file;
  face.measured = measured_face(fit, rule, trace_name, fit.spline_residual);
  return fragment(c, {"ring.face.form", "ring.face.file", "ring.face.measured."}, heading);
}

std::string face_points_csv(const surface::FaceFit& fit) {
  std::string text = "x [mm],height [um]\n";
  for (std::size_t i = 0; i < fit.x_m.size(); ++i) {
    text += fmt::format("{:.9g},{:.9g}\n", number_in(fit.x_m[i], kMillimetre), number_in(fit.spline_m[i], kMicrometre));
  }
  return text;
}

std::string shear_strength_fragment(const surface::ShearStrength& strength, const std::string& loops_name,
                                    surface::CalibrationMethod method, const std::string& calibration_name,
                                    const std::vector<std::string>& heading) {
  cycle::Case c;
  c.contact.boundary_shear_strength_coefficient = strength.zeta;
  cycle::MeasuredShearStrength& measured = c.contact.measured.shear_strength;
  measured.loops = strength.sample.empty() ? loops_name : loops_name + ", " + strength.sample;
  measured.method = surface::name_of(method);
  measured.calibration = calibration_name;
  measured.slope_deviation = strength.slope_deviation;
  measured.calibration_deviation = strength.calibration_deviation;
  measured.reference_deviation = strength.reference_deviation;
  return fragment(c, {"contact.boundary_shear_strength_coefficient", "contact.measured.shear_strength."}, heading);
}

}  // namespace ringfilm::io
