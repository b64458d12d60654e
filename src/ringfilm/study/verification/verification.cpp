#include "ringfilm/study/verification/verification.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/find_by_name.hpp"
#include "ringfilm/study/verification/manufactured.hpp"

namespace ringfilm::study {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr int kMinAcross = 2;  // cells of a pad with a width, with however few along

double error_of(double expected, double got, Tolerance::Kind kind) {
  const double away = std::abs(got - expected);
  return kind == Tolerance::Kind::kAbsolute ? away : away / std::abs(expected);
}

VerificationRow row_of(const Check& check, const cycle::Quantity& quantity, double expected, double got,
                       const Tolerance& tolerance) {
  VerificationRow row;
  row.label = check.label;
  row.quantity = quantity.long_name;
  row.unit = quantity.unit;
  row.display_unit = quantity.display_unit;
  row.expected = expected;
  row.got = got;
  row.error = error_of(expected, got, tolerance.kind);
  row.tolerance = tolerance;
  row.verdict = row.error <= tolerance.value ? Verdict::kHolds : Verdict::kFails;  // a NaN fails
  row.source = check.source;
  row.because = check.because;
  return row;
}

cycle::Quantity plain_number(const std::string& name) { return {name, "1", "1", name, "", ""}; }

/// Slope of log(error) over log(step) by least squares.
double observed_order(const std::vector<double>& steps, const std::vector<double>& errors) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  for (std::size_t i = 0; i < steps.size(); ++i) {
    const double x = std::log(steps[i]), y = std::log(errors[i]);
    n += 1, sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

/// Where the parabola through three points is level.
double vertex(const std::vector<double>& x, const std::vector<double>& y) {
  const double left = (y[1] - y[0]) / (x[1] - x[0]), right = (y[2] - y[1]) / (x[2] - x[1]);
  const double curvature = (right - left) / (x[2] - x[0]);
  return 0.5 * (x[0] + x[1]) - left / (2 * curvature);
}

class Runner {
 public:
  explicit Runner(const Verification& verification) : verification_(verification) {
    outcome_.name = verification.name;
    outcome_.title = verification.title;
    outcome_.claim = verification.claim;
  }

  void check(const ValueCheck& check) {
    const double got = number(check.run, check.probe);
    add(row_of(check, quantity_of(check.probe), check.expected, got, check.tolerance));
  }

  void check(const OrderCheck& check) {
    const bool in_cells = check.refinement == Refinement::kCells;
    const bool counts = in_cells || !check.manufactured.empty();
    ConvergenceLine line;
    line.refinement = check.refinement;
    line.expected_order = check.order;
    line.step_unit = counts ? "" : "s";
    for (const double level : check.levels) {
      line.levels.push_back(counts ? 1 / level : level);
      const double scale = check.exact == 0 ? 1 : std::abs(check.exact);
      line.errors.push_back(std::abs(refined(check, level) - check.exact) / scale);
    }
    add_order(check, in_cells ? "order in cells" : "order in time", {Tolerance::Kind::kAbsolute, check.tolerance},
              std::move(line));
  }

  void check(const BoundCheck& check) {
    const double length = width_of(verification_.runs.at(check.run));
    const double scale = check.exact == 0 ? 1 : std::abs(check.exact);
    ConvergenceLine line;
    line.label = check.label;
    line.expected_order = 1;
    line.bound = check.most * length / scale;
    double largest = 0;  // [cells]
    for (int n = check.fewest_cells; n <= check.most_cells; ++n) {
      const double error = std::abs(with_cells(check.run, check.probe, n) - check.exact);
      line.levels.push_back(1.0 / n);
      line.errors.push_back(error / scale);
      const double cells = error / (length / n);
      if (std::isnan(cells) || cells > largest) largest = cells;  // a NaN stays
    }
    add(row_of(check, plain_number("largest error in cells"), 0, largest, {Tolerance::Kind::kAbsolute, check.most}));
    outcome_.lines.push_back(std::move(line));
  }

  void check(const OptimumCheck& check) {
    std::vector<double> values;
    for (const std::string& run : check.runs) values.push_back(number(run, check.probe));
    add(row_of(check, plain_number("where the " + quantity_of(check.probe).long_name + " is largest"), check.expected,
               vertex(check.parameters, values), check.tolerance));
  }

  /// The row shows the angle that uses most of its tolerance.
  void check(const CurveCheck& check) {
    const Measurement* run = measured(check.run, verification_.runs.at(check.run));
    VerificationRow worst;
    double most = -1;
    for (std::size_t k = 0; k < check.expected.size(); ++k) {
      const double angle = check.crank_angle_deg[k];
      Tolerance tolerance = check.tolerance;
      const auto& zone = check.dead_centre_zone;
      if (zone && std::abs(std::remainder(angle, 180.0)) <= zone->reach_deg) {
        tolerance.value = std::max(tolerance.value, zone->tolerance);
      }
      const VerificationRow row =
          row_of(check, *find_curve(check.quantity), check.expected[k],
                 run == nullptr ? kNothing : curve_value(*run, check.quantity, angle), tolerance);
      const double used = row.error / tolerance.value;
      if (used <= most) continue;  // a NaN is worse than any number
      worst = row;
      if (std::isnan(used)) break;
      most = used;
    }
    add(worst);
  }

  void check(const WearCheck& check) {
    const double got = attempt(check.label + ": ", [&] { return dry_wear_value(check.profile, check.quantity); });
    add(row_of(check, *find_by_name(dry_wear_quantities(), check.quantity), check.expected, got, check.tolerance));
  }

  void check(const ContactCheck& check) {
    if (!check.levels.empty()) return check_order(check);
    add(row_of(check, *find_by_name(contact_form_quantities(), check.quantity), check.expected,
               contact_number(check, check.form.points), check.tolerance));
  }

  void check(const EvaporationCheck& check) {
    add(row_of(check, *find_by_name(evaporation_quantities(), check.quantity), check.expected,
               evaporation_value(check.form, check.quantity), check.tolerance));
  }

  VerificationOutcome outcome() const { return outcome_; }

 private:
  void check_order(const ContactCheck& check) {
    ConvergenceLine line;
    line.expected_order = check.order;
    for (const double level : check.levels) {
      line.levels.push_back(1 / level);
      line.errors.push_back(std::abs(contact_number(check, static_cast<int>(level)) / check.expected - 1));
    }
    add_order(check, "order in cells", check.tolerance, std::move(line));
  }

  /// A line of errors with its slope.
  void add_order(const Check& check, const char* quantity, const Tolerance& tolerance, ConvergenceLine line) {
    line.label = check.label;
    line.observed_order = observed_order(line.levels, line.errors);
    add(row_of(check, plain_number(quantity), line.expected_order, *line.observed_order, tolerance));
    outcome_.lines.push_back(std::move(line));
  }

  double contact_number(const ContactCheck& check, int points) {
    ContactForm form = check.form;
    form.points = points;
    return attempt(check.label + ": ", [&] { return contact_form_value(form, check.quantity); });
  }

  /// NaN where there is no solution, which the outcome reports. @param head of the report
  template <class Number>
  double attempt(const std::string& head, const Number& number) {
    try {
      return number();
    } catch (const ConvergenceError& stopped) {
      outcome_.stops.push_back(head + stopped.what());
      return kNothing;
    }
  }

  void add(VerificationRow row) { outcome_.rows.push_back(std::move(row)); }

  static cycle::Quantity quantity_of(const Probe& probe) { return *find_measured(probe.quantity); }

  double number(const std::string& run, const Probe& probe) { return number(run, verification_.runs.at(run), probe); }

  double number(const std::string& key, const cycle::Case& c, const Probe& probe) {
    const Measurement* measurement = measured(key, c);
    return measurement == nullptr ? kNothing : value(*measurement, probe);
  }

  /// Width of the face, or length of the pad [m].
  static double width_of(const cycle::Case& c) {
    return c.problem == cycle::Problem::kPad ? c.pad.length : c.ring.face_width;
  }

  /// A pad with a width has its cells across refined as much as those along.
  static void refine(cycle::Case& c, int n_cells) {
    if (c.problem == cycle::Problem::kPad && c.pad.width) {
      const double finer = static_cast<double>(n_cells) / c.solver.cells;
      c.solver.cells_y = std::max(kMinAcross, static_cast<int>(std::lround(c.solver.cells_y * finer)));
    }
    c.solver.cells = n_cells;
  }

  double with_cells(const std::string& run, const Probe& probe, int n_cells) {
    cycle::Case c = verification_.runs.at(run);
    refine(c, n_cells);
    return number(run + " cells " + std::to_string(n_cells), c, probe);
  }

  double refined(const OrderCheck& check, double level) {
    const bool in_cells = check.refinement == Refinement::kCells;
    if (!check.manufactured.empty()) {
      const int count = static_cast<int>(std::lround(level));
      const int cells = in_cells ? count : check.cells.value();
      return attempt("", [&] { return manufactured_error(check.manufactured, cells, in_cells ? 0 : count); });
    }
    cycle::Case c = verification_.runs.at(check.run);
    if (check.cells) refine(c, *check.cells);
    if (in_cells) {
      refine(c, static_cast<int>(std::lround(level)));
    } else {
      c.pad.time_step = level;
    }
    const std::string key =
        check.run + " cells " + std::to_string(c.solver.cells) + " step " + std::to_string(in_cells ? 0.0 : 1 / level);
    return number(key, c, check.probe);
  }

  static double curve_value(const Measurement& run, const std::string& quantity, double angle) {
    const auto& angles = run.instants;
    const auto found = std::find(angles.begin(), angles.end(), angle);
    if (found == angles.end()) return kNothing;
    return run.curves.at(quantity)[static_cast<std::size_t>(found - angles.begin())];
  }

  /// nullptr where there is no solution, which the outcome reports once.
  const Measurement* measured(const std::string& key, const cycle::Case& c) {
    auto found = measurements_.find(key);
    if (found == measurements_.end()) {
      std::optional<Measurement> measurement;
      try {
        measurement = measure(c);
      } catch (const ConvergenceError& stopped) {
        outcome_.stops.push_back(key + ": " + stopped.what());
      }
      found = measurements_.emplace(key, std::move(measurement)).first;
    }
    return found->second ? &*found->second : nullptr;
  }

  const Verification& verification_;
  VerificationOutcome outcome_;
  std::map<std::string, std::optional<Measurement>> measurements_;
};

}  // namespace

Verdict VerificationOutcome::verdict() const {
  const bool holds = !rows.empty() && stops.empty() && std::all_of(rows.begin(), rows.end(), [](const auto& row) {
    return row.verdict == Verdict::kHolds;
  });
  return holds ? Verdict::kHolds : Verdict::kFails;
}

VerificationOutcome verify(const Verification& verification) {
  Runner runner(verification);
  for (const ValueCheck& check : verification.values) runner.check(check);
  for (const OptimumCheck& check : verification.optima) runner.check(check);
  for (const CurveCheck& check : verification.curves) runner.check(check);
  for (const WearCheck& check : verification.wear) runner.check(check);
  for (const ContactCheck& check : verification.contact) runner.check(check);
  for (const EvaporationCheck& check : verification.evaporation) runner.check(check);
  for (const OrderCheck& check : verification.orders) runner.check(check);
  for (const BoundCheck& check : verification.bounds) runner.check(check);
  return runner.outcome();
}

}  // namespace ringfilm::study
