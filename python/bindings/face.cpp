#include "height_maps.hpp"
#include "record.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/face_fit.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

FaceFit fitted(const Heights& x, const Heights& height, double width, const std::string& sense,
               const std::optional<double>& start, const std::string& direction, const std::string& levelling,
               double tilt, const std::string& zero, double land_height, const std::optional<double>& pore_depth,
               const std::optional<double>& spline_cutoff, int degree) {
  using std::map;
  using std::string;
  FaceRule rule;
  rule.sense = chosen("sense", sense,
                      map<string, HeightSense>{{"material", HeightSense::kMaterial}, {"gap", HeightSense::kGap}});
  rule.width_m = width;
  rule.start_m = start;
  rule.direction = chosen(
      "direction", direction,
      map<string, FaceDirection>{{"as-measured", FaceDirection::kAsMeasured}, {"turned", FaceDirection::kTurned}});
  rule.levelling =
      chosen("levelling", levelling,
             map<string, FaceLevelling>{
                 {"none", FaceLevelling::kNone}, {"stated", FaceLevelling::kStated}, {"land", FaceLevelling::kLand}});
  rule.tilt = tilt;
  rule.zero =
      chosen("zero", zero,
             map<string, FaceZero>{{"lowest-point", FaceZero::kLowestPoint}, {"as-measured", FaceZero::kAsMeasured}});
  rule.land_height_m = land_height;
  rule.pore_depth_m = pore_depth;
  rule.spline_cutoff_m = spline_cutoff;
  rule.degree = degree;
  const Trace trace{numbers_of(x), numbers_of(height)};
  const py::gil_scoped_release others_go_on;
  return fit_face(trace, rule);
}

}  // namespace

void bind_face(py::module_& module) {
  py::module_ part = module.def_submodule("face", "From a trace over a ring face to its shape; see ringfilm.face.");
  Record<FaceResidual>(part, "FaceResidual", "Trace less fit.")
      .with("rms_m", &FaceResidual::rms_m, "Rms [m].")
      .with("largest_m", &FaceResidual::largest_m, "The largest [m].")
      .with("largest_at_m", &FaceResidual::largest_at_m, "Where it is [m].");
  Record<InventedShape> invented(part, "InventedShape", "Where the polynomial has what the trace has not.");
  invented.with("from_m", &InventedShape::from_m, "Begin [m].")
      .with("to_m", &InventedShape::to_m, "End [m].")
      .with("size_m", &InventedShape::size_m, "Largest distance, or fall [m].");
  invented.type().def("words", &InventedShape::words, "The same as a sentence.");
  Record<FaceFit> fit(part, "FaceFit", "The shape of a ring face. Source: docs/theory/face.md.");
  fit.with("x_m", &FaceFit::x_m, "Places from 0 to the width, shape (x,) [m].")
      .with("gap_m", &FaceFit::gap_m, "Gap of the trace, levelled and aligned, shape (x,) [m].")
      .with("start_m", &FaceFit::start_m, "Place in the trace that became x = 0 [m].")
      .with("tilt", &FaceFit::tilt, "Taken off [-].")
      .with("land_from_m", &FaceFit::land_from_m, "Where the land begins [m].")
      .with("land_to_m", &FaceFit::land_to_m, "Where it ends [m].")
      .with("spline_m", &FaceFit::spline_m, "Spline at x_m, shape (x,) [m].")
      .with("spline_cutoff_m", &FaceFit::spline_cutoff_m, "Its stiffness [m].")
      .with("polynomial_residual", &FaceFit::polynomial_residual, "FaceResidual of the polynomial.")
      .with("spline_residual", &FaceFit::spline_residual, "FaceResidual of the spline.")
      .with("polynomial_minimum_at_m", &FaceFit::polynomial_minimum_at_m, "Lowest place of the polynomial [m].")
      .with("spline_minimum_at_m", &FaceFit::spline_minimum_at_m, "Lowest place of the spline [m].")
      .with("noise_m", &FaceFit::noise_m, "Rms of what neither follows [m].")
      .with("invented", &FaceFit::invented, "A list of InventedShape.")
      .with("pore_share", &FaceFit::pore_share, "Share of the points left out as pores [-].");
  fit.type()
      .def_property_readonly(
          "coefficients", [](const FaceFit& self) { return array_of(self.polynomial.coefficients_mm_um()); },
          "Of the polynomial, height in um of x in mm, highest power first, as ring.face.coefficients has them.")
      .def(
          "height",
          [](const FaceFit& self, const Heights& x) {
            return py::vectorize([&self](double at) { return self.polynomial.height_m(at); })(x);
          },
          py::arg("x"), "Height of the polynomial at x, any shape [m].");
  part.def("fit_face", &fitted, py::arg("x"), py::arg("height"), py::arg("width"), py::arg("sense") = "material",
           py::arg("start") = py::none(), py::arg("direction") = "as-measured", py::arg("levelling") = "land",
           py::arg("tilt") = 0.0, py::arg("zero") = "lowest-point", py::arg("land_height") = FaceRule{}.land_height_m,
           py::arg("pore_depth") = py::none(), py::arg("spline_cutoff") = py::none(),
           py::arg("degree") = FaceRule{}.degree,
           R"(The shape of a ring face from a trace over it: polynomial and spline, both with what they leave.

x, height: places and heights of the trace, shape (points,) [m]. width: of the face [m].
sense: "material" (heights away from the ring, as a stylus has them) or "gap". start: where the face begins in the
trace [m]; None: where its mean gap is least. direction: "as-measured", "turned". levelling: "land", "stated" with its
tilt [-], "none". zero: "lowest-point", "as-measured". land_height, pore_depth, spline_cutoff [m]; degree of the
polynomial. Returns a FaceFit. Raises InputError. Source: docs/theory/face.md.)");
  part.def(
      "read_trace",
      [](const py::object& path, const std::optional<std::string>& height_unit,
         const std::optional<std::string>& lateral_unit, const std::optional<std::string>& step) {
        instrument::SurfaceOptions options;
        options.height_unit = height_unit;
        options.lateral_unit = lateral_unit;
        options.step_x = step;
        const auto name = py::cast<std::string>(py::module_::import("os").attr("fspath")(path));
        const auto file = instrument::read_trace_file(name, options, io::Units());
        return py::make_tuple(array_of(file.trace.x_m), array_of(file.trace.height_m));
      },
      py::arg("path"), py::arg("height_unit") = py::none(), py::arg("lateral_unit") = py::none(),
      py::arg("step") = py::none(),
      R"(Places and heights of a trace, two arrays of shape (points,) [m], from a file of any known format.

height_unit, lateral_unit: "um"; step: "0.5 um", where the file does not say. Raises InputError.)");
}

}  // namespace ringfilm::python
