#include "ringfilm/surface/friction_loop/lateral_force.hpp"

#include "measurement/height_maps.hpp"
#include "record.hpp"
#include "ringfilm/instrument/documents/force_sample.hpp"

namespace ringfilm::python {
namespace {

using namespace surface;

const std::map<std::string, LoadUnit> kLoadUnits{{"V", LoadUnit::kVolt}, {"N", LoadUnit::kNewton}};
const std::map<std::string, DeviationScale> kScales{{"stated", DeviationScale::kStated},
                                                    {"from-residuals", DeviationScale::kFromResiduals}};

struct Samples {
  static constexpr auto name = py::detail::make_caster<std::vector<instrument::ForceSample>>::name;
};

FrictionLoop loop_of(const GivenNumbers& position, const GivenNumbers& trace, const GivenNumbers& retrace) {
  return {0, row_of("position", position.value), row_of("trace", trace.value), row_of("retrace", retrace.value)};
}

/// A deviation of each of n points, from as many numbers or from one.
std::vector<double> deviations_of(const char* name, const GivenNumbers& given, std::size_t n) {
  const Doubles array = doubles_of(name, given.value);
  if (array.ndim() == 0) return std::vector<double>(n, *array.data());
  const std::vector<double> row = row_of(name, given.value);
  return row.size() == 1 ? std::vector<double>(n, row[0]) : row;
}

std::vector<LinePoint> points_of(const GivenNumbers& x, const GivenNumbers& y, const GivenNumbers& x_deviation,
                                 const GivenNumbers& y_deviation) {
  const auto xs = row_of("x", x.value), ys = row_of("y", y.value);
  const auto x_deviations = deviations_of("x_deviation", x_deviation, xs.size());
  const auto y_deviations = deviations_of("y_deviation", y_deviation, xs.size());
  if (ys.size() != xs.size() || x_deviations.size() != xs.size() || y_deviations.size() != xs.size())
    throw InputError("x, y and their deviations have different lengths", "give as many of each, or one deviation");
  std::vector<LinePoint> points;
  for (std::size_t i = 0; i < xs.size(); ++i) points.push_back({xs[i], ys[i], x_deviations[i], y_deviations[i]});
  return points;
}

std::vector<instrument::ForceSample> read(const py::args& paths, const GivenNumber& end_share,
                                          const GivenText& deviations, const GivenMaybeText& load_deviation) {
  std::vector<std::string> names;
  for (const auto path : paths) names.push_back(path_of("path", path));
  if (names.empty()) throw InputError("no file is named", "name one CSV file of friction loops or more");
  instrument::ForceRule rule;
  rule.end_share = number_of("end_share", end_share.value, "");
  rule.deviations = chosen("deviations", deviations, kScales);
  rule.load_deviation = maybe_text_of("load_deviation", load_deviation.value, "0.5 nN");
  rule.load_deviation_word = "load_deviation";
  return instrument::read_force_samples(names, rule, io::Units());
}

py::object to_state(const std::vector<FrictionLoop>& loops) {
  py::list state;
  for (const FrictionLoop& loop : loops) {
    state.append(
        py::make_tuple(loop.load, array_of(loop.position_m), array_of(loop.trace_V), array_of(loop.retrace_V)));
  }
  return state;
}

std::vector<FrictionLoop> from_state(const py::handle& state) {
  std::vector<FrictionLoop> loops;
  for (const py::handle one : state) {
    const auto parts = py::cast<py::tuple>(one);
    const auto numbers = [&parts](int i) { return pickled_row(parts[i]); };
    loops.push_back({py::cast<double>(parts[0]), numbers(1), numbers(2), numbers(3)});
  }
  return loops;
}

/// A number and its standard deviation. Throws TypeError.
Uncertain uncertain_of(const char* name, const py::handle& given) {
  if ((!py::isinstance<py::tuple>(given) && !py::isinstance<py::list>(given)) || py::len(given) != 2) {
    throw py::type_error(std::string(name) + " must be two numbers, (value, standard deviation)");
  }
  const py::object value = given[py::int_(0)], deviation = given[py::int_(1)];
  return {number_of(name, value, ""), number_of(name, deviation, "")};
}

void bind_force_records(py::module_& part) {
  Record<LoopFriction>(part, "LoopFriction", "A friction loop without its ends. Source: eq-friction-loop.")
      .with("tmr_V", &LoopFriction::tmr_V, "Half of trace minus retrace [V].")
      .with("tmr_deviation_V", &LoopFriction::tmr_deviation_V, "Its standard error [V].")
      .with("offset_V", &LoopFriction::offset_V, "Half of trace plus retrace [V].")
      .with("offset_deviation_V", &LoopFriction::offset_deviation_V, "Its standard error [V].")
      .with("points", &LoopFriction::points, "Positions that were kept.");
  Record<LoadFriction>(part, "LoadFriction", "All loops of one load.")
      .with("load", &LoadFriction::load, "[V] or [N].")
      .with("load_deviation", &LoadFriction::load_deviation, "Standard deviation of the load [V] or [N]; 0: exact.")
      .with("tmr_V", &LoadFriction::tmr_V, "Mean friction signal [V].")
      .with("tmr_scatter_V", &LoadFriction::tmr_scatter_V, "Between the loops of this load [V].")
      .with("tmr_deviation_V", &LoadFriction::tmr_deviation_V, "Standard error of the mean [V]; 0: not known.")
      .with("offset_V", &LoadFriction::offset_V, "Mean of half of trace plus retrace [V].")
      .with("offset_deviation_V", &LoadFriction::offset_deviation_V, "Its standard error [V]; 0: not known.")
      .with("loops", &LoadFriction::loops, "How many.");
  Record<LineFit> line(part, "LineFit", "y = offset + slope x. Source: York (2004), docs/theory, eq-line-weights.");
  line.with("slope", &LineFit::slope, "Slope [y/x].")
      .with("offset", &LineFit::offset, "Value at 0 [y].")
      .with("slope_deviation", &LineFit::slope_deviation, "Standard error of the slope.")
      .with("offset_deviation", &LineFit::offset_deviation, "Standard error of the offset.")
      .with("chi_squared", &LineFit::chi_squared, "Weighted squares about the line.")
      .with("covariance", &LineFit::covariance, "Of slope and offset.")
      .with(
          "chi_squared_probability", &LineFit::chi_squared_probability,
          "That stated deviations alone give as much or more [-]; below 0.01 they are too small, or the points are not "
          "on a line.")
      .with("points", &LineFit::points, "How many points.")
      .with_word(
          "deviations", &LineFit::scale, [](DeviationScale scale) { return word_of(scale, kScales); },
          "What the deviations of the points meant, \"stated\" or \"from-residuals\".");
  line.type().def(
      "slope_half_width",
      [](const LineFit& self, const GivenNumber& confidence) {
        return self.slope_half_width(number_of("confidence", confidence.value, ""));
      },
      py::arg("confidence"),
      "Half the width of the interval that holds the slope with this probability, between 0 and 1 [-]. Raises "
      "InputError.");
  Record<Calibration>(part, "Calibration", "The factor psi of zeta = psi m.")
      .with("psi", &Calibration::psi, "[-] for loads in volts, [N/V] for loads in newtons.")
      .with("measurement_deviation", &Calibration::measurement_deviation, "Of psi, from its own lines.")
      .with("reference_deviation", &Calibration::reference_deviation, "Of psi, from what was taken over.")
      .with("degrees_of_freedom", &Calibration::degrees_of_freedom, "Of the measurement; inf where it is stated.")
      .with_word(
          "load_unit", &Calibration::load_unit, [](LoadUnit unit) { return word_of(unit, kLoadUnits); },
          "Unit of the loads, \"V\" or \"N\".")
      .with_word(
          "method", &Calibration::method, [](CalibrationMethod method) { return name_of(method); },
          "\"silicon\", \"geometry\" or \"wedge\".")
      .keep(&Calibration::lines);
  Record<instrument::ForceSample>(part, "ForceSample", "Loops of one sample and the line through them.")
      .with("name", &instrument::ForceSample::name, "As the file has it.")
      .with("loads", &instrument::ForceSample::loads, "A list of LoadFriction, rising.")
      .with("line", &instrument::ForceSample::line, "LineFit of friction signal against load.")
      .with_word(
          "load_unit", &instrument::ForceSample::load_unit, [](LoadUnit unit) { return word_of(unit, kLoadUnits); },
          "Unit of the loads, \"V\" or \"N\".")
      .keep(&instrument::ForceSample::sources)
      .keep(&instrument::ForceSample::paths)
      .keep(&instrument::ForceSample::digests)
      .keep([](const instrument::ForceSample& self) { return to_state(self.loops); },
            [](instrument::ForceSample& self, const py::handle& state) { self.loops = from_state(state); },
            [](const instrument::ForceSample& a, const instrument::ForceSample& b) { return a.loops == b.loops; });
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
  bind_force_records(part);
  part.def(
      "loop_friction",
      [](const GivenNumbers& position, const GivenNumbers& trace, const GivenNumbers& retrace,
         const GivenNumber& end_share) {
        return loop_friction(loop_of(position, trace, retrace), number_of("end_share", end_share.value, ""));
      },
      py::arg("position"), py::arg("trace"), py::arg("retrace"),
      py::arg("end_share") = instrument::ForceRule{}.end_share,
      R"(Friction signal of one loop.

position [m], trace and retrace [V]: shape (points,), both ways at the same positions, rising. end_share: of the length,
cut off at each end [-]. Returns a LoopFriction. Raises InputError, for NaN and masked values too, and TypeError.
Source: docs/theory, eq-friction-loop.)");
  part.def(
      "fit_line",
      [](const GivenNumbers& x, const GivenNumbers& y, const GivenNumbers& x_deviation, const GivenNumbers& y_deviation,
         const GivenText& deviations) {
        return fit_line(points_of(x, y, x_deviation, y_deviation), chosen("deviations", deviations, kScales));
      },
      py::arg("x"), py::arg("y"), py::arg("x_deviation") = 0.0, py::arg("y_deviation") = 1.0,
      py::arg("deviations") = "from-residuals",
      R"(A straight line through points that are uncertain in both directions, by weighted total least squares.

x, y: shape (points,) [any unit]. x_deviation, y_deviation: standard deviations, one for all or one a point;
"from-residuals" takes only their ratios for known, "stated" themselves. Returns a LineFit. Raises InputError.
Source: York (2004).)");
  part.def(
      "calibrate_on_silicon",
      [](const GivenOne<LineFit>& silicon, const GivenText& load_unit, const Given<kinds::MaybePair>& value) {
        const Uncertain reference = value.value.is_none() ? kSiliconAhimou : uncertain_of("reference", value.value);
        return calibrate_on_silicon(one_of("silicon", silicon), chosen("load_unit", load_unit, kLoadUnits), reference);
      },
      py::arg("silicon"), py::arg("load_unit"), py::arg("reference") = py::none(),
      R"(psi from the line of silicon. load_unit: "V" or "N". reference: (coefficient of friction, its deviation);
None: 0.19, 0.1 after Ahimou et al. (2007). Returns a Calibration. Raises InputError. Source: eq-psi-silicon.)");
  part.def(
      "boundary_shear_strengths",
      [](const Given<Samples>& samples, const GivenOne<Calibration>& calibration) {
        const py::handle given = samples.value;
        if (!py::isinstance<py::list>(given) && !py::isinstance<py::tuple>(given))
          throw py::type_error("samples must be a list of ForceSample");
        std::vector<FrictionSample> lines;
        for (const py::handle one : given) {
          const auto& sample =
              one_of<instrument::ForceSample>("each of samples", {py::reinterpret_borrow<py::object>(one)});
          lines.push_back({sample.name, sample.line, sample.load_unit});
        }
        const ShearStrengths all = boundary_shear_strengths(lines, one_of("calibration", calibration));
        const auto n = static_cast<py::ssize_t>(all.samples.size());
        py::array_t<double> covariance({n, n}, all.covariance.data());
        return py::make_tuple(all.samples, covariance);
      },
      py::arg("samples"), py::arg("calibration"),
      R"(Coefficients of boundary shear strength of samples that share a calibration.

Returns (list of ShearStrength, covariance of zeta of shape (samples, samples)). Raises InputError, for a sample with
the line that the calibration follows from, too.
Source: eq-zeta, eq-zeta-covariance.)");
  part.def("read", &read, py::arg("end_share") = instrument::ForceRule{}.end_share,
           py::arg("deviations") = "from-residuals", py::arg("load_deviation") = py::none(),
           R"(Samples of CSV files of friction loops (docs/manual/lateral-force.md); several paths may be named.

end_share: of the scan length, cut off at each end [-]. deviations: "from-residuals" or "stated"; load_deviation: of
each load, "0.5 nN". Returns a list of ForceSample. Raises InputError with the faults of all files.)");
}

}  // namespace ringfilm::python
