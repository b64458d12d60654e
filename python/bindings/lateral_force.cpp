#include "ringfilm/surface/lateral_force.hpp"

#include "height_maps.hpp"
#include "record.hpp"
#include "ringfilm/instrument/force_sample.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, LoadUnit> kLoadUnits{{"V", LoadUnit::kVolt}, {"N", LoadUnit::kNewton}};
const std::map<std::string, DeviationScale> kScales{{"stated", DeviationScale::kStated},
                                                    {"from-residuals", DeviationScale::kFromResiduals}};

FrictionLoop loop_of(const Heights& position, const Heights& trace, const Heights& retrace, double load) {
  return {load, numbers_of(position), numbers_of(trace), numbers_of(retrace)};
}

std::vector<LinePoint> points_of(const Heights& x, const Heights& y, const Heights& x_deviation,
                                 const Heights& y_deviation) {
  const py::ssize_t n = x.size();
  const auto fits = [n](const Heights& array) { return array.size() == n || array.size() == 1; };
  if (y.size() != n || !fits(x_deviation) || !fits(y_deviation))
    throw InputError("x, y and their deviations have different lengths", "give as many of each, or one deviation");
  const auto at = [](const Heights& array, py::ssize_t i) { return array.data()[array.size() == 1 ? 0 : i]; };
  std::vector<LinePoint> points;
  for (py::ssize_t i = 0; i < n; ++i) points.push_back({at(x, i), at(y, i), at(x_deviation, i), at(y_deviation, i)});
  return points;
}

std::vector<instrument::ForceSample> read(const py::args& paths, double end_share, const std::string& deviations,
                                          const std::optional<std::string>& load_deviation) {
  std::vector<std::string> names;
  for (const auto path : paths) names.push_back(py::cast<std::string>(py::module_::import("os").attr("fspath")(path)));
  instrument::ForceRule rule;
  rule.end_share = end_share;
  rule.deviations = chosen("deviations", deviations, kScales);
  rule.load_deviation = load_deviation;
  return instrument::read_force_samples(names, rule, io::Units());
}

void bind_records(py::module_& part) {
  Record<LoopFriction>(part, "LoopFriction", "A friction loop without its ends. Source: eq-friction-loop.")
      .with("tmr_V", &LoopFriction::tmr_V, "Half of trace minus retrace [V].")
      .with("tmr_deviation_V", &LoopFriction::tmr_deviation_V, "Its standard error [V].")
      .with("offset_V", &LoopFriction::offset_V, "Half of trace plus retrace [V].")
      .with("offset_deviation_V", &LoopFriction::offset_deviation_V, "Its standard error [V].")
      .with("points", &LoopFriction::points, "Positions that were kept.");
  Record<LoadFriction>(part, "LoadFriction", "All loops of one load.")
      .with("load", &LoadFriction::load, "[V] or [N].")
      .with("tmr_V", &LoadFriction::tmr_V, "Mean friction signal [V].")
      .with("tmr_scatter_V", &LoadFriction::tmr_scatter_V, "Between the loops of this load [V].")
      .with("tmr_deviation_V", &LoadFriction::tmr_deviation_V, "Standard error of the mean [V]; 0: not known.")
      .with("loops", &LoadFriction::loops, "How many.");
  Record<LineFit> line(part, "LineFit", "y = offset + slope x. Source: York (2004), docs/theory, eq-line-weights.");
  line.with("slope", &LineFit::slope, "Slope [y/x].")
      .with("offset", &LineFit::offset, "Value at 0 [y].")
      .with("slope_deviation", &LineFit::slope_deviation, "Standard error of the slope.")
      .with("offset_deviation", &LineFit::offset_deviation, "Standard error of the offset.")
      .with("chi_squared", &LineFit::chi_squared, "Weighted squares about the line.")
      .with("points", &LineFit::points, "How many points.");
  line.type().def("slope_half_width", &LineFit::slope_half_width, py::arg("confidence"),
                  "Half the width of the interval that holds the slope with this probability.");
  Record<Calibration>(part, "Calibration", "The factor psi of zeta = psi m.")
      .with("psi", &Calibration::psi, "[-] for loads in volts, [N/V] for loads in newtons.")
      .with("measurement_deviation", &Calibration::measurement_deviation, "Of psi, from its own lines.")
      .with("reference_deviation", &Calibration::reference_deviation, "Of psi, from what was taken over.");
  Record<instrument::ForceSample> sample(part, "ForceSample", "Loops of one sample and the line through them.");
  sample.with("name", &instrument::ForceSample::name, "As the file has it.")
      .with("loads", &instrument::ForceSample::loads, "A list of LoadFriction, rising.")
      .with("line", &instrument::ForceSample::line, "LineFit of friction signal against load.");
  sample.type().def_property_readonly(
      "load_unit", [](const instrument::ForceSample& self) { return self.load_unit == LoadUnit::kVolt ? "V" : "N"; },
      "Unit of the loads, \"V\" or \"N\".");
  Record<ShearStrength> strength(part, "ShearStrength", "zeta of one sample. Source: eq-zeta, eq-zeta-shares.");
  strength.with("sample", &ShearStrength::sample, "Its name.")
      .with("zeta", &ShearStrength::zeta, "Coefficient of boundary shear strength [-].")
      .with("slope_deviation", &ShearStrength::slope_deviation, "From the sample's own line [-].")
      .with("calibration_deviation", &ShearStrength::calibration_deviation, "From the measurement of psi [-].")
      .with("reference_deviation", &ShearStrength::reference_deviation, "From the value taken over for psi [-].")
      .with("low", &ShearStrength::low, "Lower end of the 95 % interval [-].")
      .with("high", &ShearStrength::high, "Upper end [-].");
  strength.type().def("deviation", &ShearStrength::deviation, "Standard deviation, all shares together [-].");
}

}  // namespace

void bind_lateral_force(py::module_& module) {
  py::module_ part = module.def_submodule("lateral_force", "Friction loops; see ringfilm.lateral_force.");
  bind_records(part);
  part.def(
      "loop_friction",
      [](const Heights& position, const Heights& trace, const Heights& retrace, double end_share) {
        return loop_friction(loop_of(position, trace, retrace, 0), end_share);
      },
      py::arg("position"), py::arg("trace"), py::arg("retrace"),
      py::arg("end_share") = instrument::ForceRule{}.end_share,
      R"(Friction signal of one loop.

position [m], trace and retrace [V]: shape (points,), both ways at the same positions, rising. end_share: of the length,
cut off at each end [-]. Returns a LoopFriction. Raises InputError. Source: docs/theory, eq-friction-loop.)");
  part.def(
      "fit_line",
      [](const Heights& x, const Heights& y, const Heights& x_deviation, const Heights& y_deviation,
         const std::string& deviations) {
        return fit_line(points_of(x, y, x_deviation, y_deviation), chosen("deviations", deviations, kScales));
      },
      py::arg("x"), py::arg("y"), py::arg("x_deviation") = 0.0, py::arg("y_deviation") = 1.0,
      py::arg("deviations") = "from-residuals",
      R"(A straight line through points that are uncertain in both directions, by weighted total least squares.

x, y: shape (points,) [any unit]. x_deviation, y_deviation: standard deviations, one for all or one a point; "from-residuals" takes
only their ratios for known, "stated" themselves. Returns a LineFit. Raises InputError. Source: York (2004).)");
  part.def(
      "calibrate_on_silicon",
      [](const LineFit& silicon, const std::string& load_unit, const std::optional<std::pair<double, double>>& value) {
        const Uncertain reference = value ? Uncertain{value->first, value->second} : kSiliconAhimou;
        return calibrate_on_silicon(silicon, chosen("load_unit", load_unit, kLoadUnits), reference);
      },
      py::arg("silicon"), py::arg("load_unit"), py::arg("reference") = py::none(),
      R"(psi from the line of silicon. load_unit: "V" or "N". reference: (coefficient of friction, its deviation);
None: 0.19, 0.1 after Ahimou et al. (2007). Returns a Calibration. Raises InputError. Source: eq-psi-silicon.)");
  part.def(
      "boundary_shear_strengths",
      [](const std::vector<instrument::ForceSample>& samples, const Calibration& calibration) {
        std::vector<FrictionSample> lines;
        for (const auto& sample : samples) lines.push_back({sample.name, sample.line, sample.load_unit});
        const ShearStrengths all = boundary_shear_strengths(lines, calibration);
        const auto n = static_cast<py::ssize_t>(all.samples.size());
        py::array_t<double> covariance({n, n}, all.covariance.data());
        return py::make_tuple(all.samples, covariance);
      },
      py::arg("samples"), py::arg("calibration"),
      R"(Coefficients of boundary shear strength of samples that share a calibration.

Returns (list of ShearStrength, covariance of zeta of shape (samples, samples)). Raises InputError.
Source: eq-zeta, eq-zeta-covariance.)");
  part.def("read", &read, py::arg("end_share") = instrument::ForceRule{}.end_share,
           py::arg("deviations") = "from-residuals", py::arg("load_deviation") = py::none(),
           R"(Samples of CSV files of friction loops (docs/manual/lateral-force.md); several paths may be named.

end_share: of the scan length, cut off at each end [-]. deviations: "from-residuals" or "stated"; load_deviation: of each
load, "0.5 nN". Returns a list of ForceSample. Raises InputError with the faults of all files.)");
}

}  // namespace ringfilm::python
