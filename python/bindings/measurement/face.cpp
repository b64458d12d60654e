#include "array_view.hpp"
#include "measurement/height_maps.hpp"
#include "measurement/measured_files.hpp"
#include "record.hpp"
#include "ringfilm/surface/face/face_fit.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, HeightSense> kSenses{{"material", HeightSense::kMaterial}, {"gap", HeightSense::kGap}};
const std::map<std::string, FaceDirection> kFaceDirections{{"as-measured", FaceDirection::kAsMeasured},
                                                           {"turned", FaceDirection::kTurned}};
const std::map<std::string, FaceLevelling> kLevellings{{"none", FaceLevelling::kNone},
                                                       {"stated", FaceLevelling::kStated},
                                                       {"running-surface", FaceLevelling::kRunningSurface}};
const std::map<std::string, FaceZero> kZeros{{"lowest-point", FaceZero::kMinPoint},
                                             {"as-measured", FaceZero::kAsMeasured}};
const std::map<std::string, InventionReason> kReasons{
    {"departs", InventionReason::kDeparts},
    {"turn-not-in-trace", InventionReason::kTurnNotInTrace},
    {"falls-towards-the-edge", InventionReason::kFallsTowardsTheEdge}};

FaceFit fitted(const GivenNumbers& x, const GivenNumbers& height, const GivenNumber& width, const GivenText& sense,
               const GivenMaybeNumber& start, const GivenText& direction, const GivenText& levelling,
               const GivenNumber& tilt, const GivenText& zero, const GivenNumber& running_surface_height,
               const GivenMaybeNumber& pore_depth, const GivenMaybeNumber& spline_cutoff,
               const Given<kinds::Integer>& degree) {
  FaceRule rule;
  rule.sense = chosen("sense", sense, kSenses);
  rule.width_m = number_of("width", width.value, "m");
  rule.start_m = maybe_number_of("start", start.value, "m");
  rule.direction = chosen("direction", direction, kFaceDirections);
  rule.levelling = chosen("levelling", levelling, kLevellings);
  rule.tilt = number_of("tilt", tilt.value, "");
  rule.zero = chosen("zero", zero, kZeros);
  rule.running_surface_height_m = number_of("running_surface_height", running_surface_height.value, "m");
  rule.pore_depth_m = maybe_number_of("pore_depth", pore_depth.value, "m");
  rule.spline_cutoff_m = maybe_number_of("spline_cutoff", spline_cutoff.value, "m");
  rule.degree = integer_of("degree", degree.value);
  const Trace trace{row_of("x", x.value), row_of("height", height.value)};
  const py::gil_scoped_release others_go_on;
  return fit_face(trace, rule);
}

py::tuple ends(const double (&values)[2]) { return py::make_tuple(values[0], values[1]); }

/// Both ends of a fit, which are not plain members.
void keep_ends(Record<FaceFit>& fit, const char* name, double (FaceFit::*member)[2], const char* doc) {
  fit.derived(
      name, [member](const FaceFit& self) { return ends(self.*member); }, doc);
  fit.keep([member](const FaceFit& self) -> py::object { return ends(self.*member); },
           [member](FaceFit& self, const py::handle& state) {
             const auto [first, second] = py::cast<std::pair<double, double>>(state);
             (self.*member)[0] = first;
             (self.*member)[1] = second;
           },
           [member](const FaceFit& a, const FaceFit& b) {
             return (a.*member)[0] == (b.*member)[0] && (a.*member)[1] == (b.*member)[1];
           });
}

void keep_polynomial(Record<FaceFit>& fit) {
  fit.type().def_property_readonly(
      "coefficients",
      [](const py::object& self) {
        const auto& all = py::cast<const FaceFit&>(self).polynomial.coefficients_mm_um();
        return view(all, self);
      },
      "Of the polynomial, height in um of x in mm, highest power first, as ring.face.coefficients has them; shape "
      "(degree + 1,), read-only.");
  fit.type().attr("_members").attr("append")("coefficients");
  fit.keep(
      [](const FaceFit& self) -> py::object {
        return py::make_tuple(array_of(self.polynomial.coefficients_mm_um()), self.polynomial.width_m());
      },
      [](FaceFit& self, const py::handle& state) {
        const auto [all, width] = py::cast<std::pair<Doubles, double>>(state);
        self.polynomial = FacePolynomial({all.data(), all.data() + all.size()}, width);
      },
      [](const FaceFit& a, const FaceFit& b) {
        return a.polynomial.coefficients_mm_um() == b.polynomial.coefficients_mm_um() &&
               a.polynomial.width_m() == b.polynomial.width_m();
      });
}

}  // namespace

void bind_face(py::module_& module) {
  py::module_ part = module.def_submodule("face", "From a trace over a ring face to its shape; see ringfilm.face.");
  Record<FaceResidual>(part, "FaceResidual", "Trace less fit.")
      .with("rms_m", &FaceResidual::rms_m, "Rms [m].")
      .with("largest_m", &FaceResidual::largest_m, "The largest [m].")
      .with("largest_at_m", &FaceResidual::largest_at_m, "Where it is [m].");
  Record<FitArtifact> invented(part, "FitArtifact", "Where the polynomial has what the trace has not.");
  invented.with("from_m", &FitArtifact::from_m, "Begin [m].")
      .with("to_m", &FitArtifact::to_m, "End [m].")
      .with_word(
          "reason", &FitArtifact::reason, [](InventionReason r) { return word_of(r, kReasons); },
          "What gives it away: \"departs\" from the trace, \"turn-not-in-trace\", \"falls-towards-the-edge\".")
      .with("size_m", &FitArtifact::size_m, "Largest distance, or fall [m].");
  invented.type().def("words", &FitArtifact::words, "The same as a sentence.");
  Record<FaceFit> fit(part, "FaceFit",
                      "The shape of a ring face; its arrays are read-only. Source: docs/theory/face.md.");
  fit.with("x_m", &FaceFit::x_m, "Places from 0 to the width, shape (x,) [m].")
      .with("gap_m", &FaceFit::gap_m, "Gap of the trace, levelled and aligned, shape (x,) [m].")
      .with("start_m", &FaceFit::start_m, "Place in the trace that became x = 0 [m].")
      .with("tilt", &FaceFit::tilt, "Tilt that was removed [-].")
      .with("running_surface_from_m", &FaceFit::running_surface_from_m, "Where the running surface begins [m].")
      .with("running_surface_to_m", &FaceFit::running_surface_to_m, "Where it ends [m].")
      .with("spline_m", &FaceFit::spline_m, "Spline at x_m, shape (x,) [m].")
      .with("spline_cutoff_m", &FaceFit::spline_cutoff_m, "Its stiffness [m].")
      .with("polynomial_residual", &FaceFit::polynomial_residual, "FaceResidual of the polynomial.")
      .with("spline_residual", &FaceFit::spline_residual, "FaceResidual of the spline.")
      .with("polynomial_minimum_m", &FaceFit::polynomial_minimum_m, "Least gap of the polynomial, as gap_m counts [m].")
      .with("polynomial_minimum_at_m", &FaceFit::polynomial_minimum_at_m, "Lowest place of the polynomial [m].")
      .with("spline_minimum_m", &FaceFit::spline_minimum_m, "Least gap of the spline, as gap_m counts [m].")
      .with("spline_minimum_at_m", &FaceFit::spline_minimum_at_m, "Lowest place of the spline [m].")
      .with("noise_m", &FaceFit::noise_m, "Rms of what neither follows [m].")
      .with("invented", &FaceFit::invented, "A list of FitArtifact.")
      .with("pore_share", &FaceFit::pore_share, "Share of the points omitted as pores [-].")
      .with("averaged", &FaceFit::averaged, "Neighbouring points of the trace that were averaged into one.");
  keep_ends(fit, "polynomial_end_m", &FaceFit::polynomial_end_m,
            "The polynomial at x = 0 and at the width, above its lowest place, (first, last) [m].");
  keep_ends(fit, "spline_end_m", &FaceFit::spline_end_m, "The same of the spline, (first, last) [m].");
  keep_polynomial(fit);
  fit.type().def(
      "height",
      [](const FaceFit& self, const GivenNumbers& x) {
        return mapped("x", x, [&self](double at) { return self.polynomial.height_m(at); });
      },
      py::arg("x"), "Height of the polynomial at x, any shape [m]. Raises InputError.");
  part.def("fit_face", &fitted, py::arg("x"), py::arg("height"), py::arg("width"), py::arg("sense") = "material",
           py::arg("start") = py::none(), py::arg("direction") = "as-measured",
           py::arg("levelling") = "running-surface", py::arg("tilt") = 0.0, py::arg("zero") = "lowest-point",
           py::arg("running_surface_height") = FaceRule{}.running_surface_height_m, py::arg("pore_depth") = py::none(),
           py::arg("spline_cutoff") = py::none(), py::arg("degree") = FaceRule{}.degree,
           R"(The shape of a ring face from a trace over it: polynomial and spline, both with what they leave.

x, height: places and heights of the trace, shape (points,) [m]. width: of the face [m].
sense: "material" (heights away from the ring, as a stylus has them) or "gap". start: where the face begins in the
trace [m]; None: where its mean gap is least. direction: "as-measured", "turned". levelling: "running-surface", "stated"
with its tilt [-], "none". zero: "lowest-point", "as-measured". running_surface_height, pore_depth, spline_cutoff [m];
degree of the polynomial. Returns a FaceFit. Raises InputError, for NaN and masked points too, and TypeError.
Source: docs/theory/face.md.)");
  part.def(
      "read_trace",
      [](const Given<kinds::Path>& path, const GivenMaybeText& height_unit, const GivenMaybeText& lateral_unit,
         const GivenMaybeText& step, const GivenMaybeText& columns, const Given<kinds::Integer>& skip_lines,
         const Given<kinds::Words>& missing) {
        auto options = file_options(height_unit, lateral_unit, "step", step);
        options.table = table_reading(columns, skip_lines, missing);
        const auto file = instrument::read_trace_file(path_of("path", path.value), options, io::Units());
        for (const std::string& doubt : file.origin.doubts) {
          if (PyErr_WarnEx(PyExc_UserWarning, (file.origin.path + ": " + doubt).c_str(), 1) != 0) {
            throw py::error_already_set();
          }
        }
        return py::make_tuple(array_of(file.trace.x_m), array_of(file.trace.height_m));
      },
      py::arg("path"), py::arg("height_unit") = py::none(), py::arg("lateral_unit") = py::none(),
      py::arg("step") = py::none(), py::arg("columns") = py::none(), py::arg("skip_lines") = 0,
      py::arg("missing") = py::tuple(),
      R"(Places and heights of a trace, two arrays of shape (points,) [m], from a file of any known format.

height_unit, lateral_unit: "um"; step: "0.5 um", where the file does not state it. columns, skip_lines, missing: of a
text file, as of ringfilm.surface.read. Warns (UserWarning) where the
heights may not be those of the surface. Raises InputError, TypeError.)");
}

}  // namespace ringfilm::python
