#include "ringfilm/instrument/documents/force_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/instrument/documents/force_figures.hpp"
#include "ringfilm/instrument/documents/surface_values.hpp"
#include "ringfilm/io/case/contact_fragment.hpp"

namespace ringfilm::instrument {
namespace {

using surface::LoadUnit;

// Probability of chi squared below which the stated deviations are too small, or the relation is not linear.
constexpr double kTooSmallChance = 0.01;
constexpr double kLargeShare = 0.5;         // share of the variance of a coefficient
constexpr double kNotableReference = 0.05;  // relative deviation; less is harmless
constexpr double kWideMismatch = 0.1;       // relative mismatch of the widths on two facets

bool stated(const ForceRule& rule) { return rule.deviations == surface::DeviationScale::kStated; }

std::string uncertain_text(const surface::Uncertain& u, const DisplayUnit& unit = kPlainNumber) {
  return fmt::format("{:.6g} +- {:.3g}", number_in(u.value, unit), number_in(u.deviation, unit));
}

/// Units of a slope of the friction signal over load, and of psi.
struct LineUnits {
  explicit LineUnits(LoadUnit load) : volts(load == LoadUnit::kVolt) {}
  bool volts;
  std::string slope() const { return volts ? "1" : "V/N"; }
  std::string slope_display() const { return volts ? "1" : "mV/nN"; }
  std::string psi() const { return volts ? "1" : "N/V"; }
  std::string psi_display() const { return volts ? "1" : "nN/mV"; }
};

/// One table of the friction signal load by load.
io::MeasuredTable load_table(const ForceSample& sample, const std::string& word, const std::string& title) {
  const std::string unit = load_unit_of(sample.load_unit), display = load_display_of(sample.load_unit);
  io::MeasuredTable table{"loads_" + word, title, {}, {}, {}};
  add_column(table, "load", "normal load", "load", unit, display);
  add_column(table, "loops", "loops at this load", "loops", "1", "1");
  add_column(table, "tmr", "half the difference of trace and retrace, mean", "TMR", "V", "mV");
  add_column(table, "tmr_scatter", "standard deviation between loops", "scatter", "V", "mV");
  add_column(table, "tmr_error", "standard error of the mean", "error", "V", "mV");
  add_column(table, "line_distance", "TMR less line", "distance", "V", "mV");
  if (!sample.loops.empty()) add_column(table, "offset", "half the sum of both ways", "offset", "V", "mV");
  for (const surface::LoadFriction& load : sample.loads) {
    const bool scatter = !sample.loops.empty() && load.loops > 1;
    const double nothing = std::nan("");
    add_row(table, {load.load, static_cast<double>(load.loops), load.tmr_V, scatter ? load.tmr_scatter_V : nothing,
                    load.tmr_deviation_V > 0 ? load.tmr_deviation_V : nothing,
                    load.tmr_V - sample.line.offset - sample.line.slope * load.load, load.offset_V});
  }
  return table;
}

/// Slope and offset of one line; names begin with `head` and end with `tail`.
void add_line(const ForceSample& sample, const std::string& head, const std::string& tail, Group& to) {
  const LineUnits units(sample.load_unit);
  const surface::LineFit& line = sample.line;
  to.add(head + "friction_slope" + tail, "slope of friction signal over load", "m", units.slope(),
         units.slope_display(), line.slope, fmt::format("{} loads", line.points), line.slope_deviation);
  to.add(head + "friction_offset" + tail, "friction signal at load zero (adhesion)", "a", "V", "mV", line.offset, "",
         line.offset_deviation);
  if (line.scale == surface::DeviationScale::kStated) {
    to.add(head + "chi_squared_probability" + tail, "chance of so much scatter about the line", "", "1", "%",
           line.chi_squared_probability, "with the stated deviations");
  }
}

io::MeasuredGroup strength_group(const ForceSample& sample, const surface::ShearStrength& strength,
                                 const std::string& tail) {
  Group group("Coefficient of boundary shear strength, " + sample.name);
  group.add("boundary_shear_strength_coefficient" + tail, "coefficient of boundary shear strength, " + sample.name,
            "zeta", "1", "1", strength.zeta, "all shares together", strength.deviation());
  const auto add = [&](const char* name, const char* symbol, const char* words, double value, const char* remark) {
    group.add(name + tail, words, symbol, "1", "1", value, remark);
  };
  add("slope_deviation", "by slope", "share of the slope", strength.slope_deviation, "this sample's own");
  add("calibration_deviation", "by calibration", "share of the calibration's measurement",
      strength.calibration_deviation, "common to all samples");
  add("reference_deviation", "by reference", "share of what was taken over for it", strength.reference_deviation,
      "common to all samples");
  add("low", "low", "95 % interval from", strength.low, "");
  add("high", "high", "to", strength.high, "");
  add_line(sample, "", tail, group);
  return group;
}

void add_lever(const surface::Lever& lever, Group& to) {
  if (!(lever.youngs_modulus_Pa.value > 0) || !(lever.width_m.value > 0) || !(lever.thickness_m.value > 0)) return;
  to.add("normal_stiffness", "normal stiffness of the lever", "k_N", "N/m", "N/m", surface::normal_stiffness(lever));
  to.add("torsional_stiffness", "torsional stiffness of the lever at the tip", "k_T", "N/m", "N/m",
         surface::torsional_stiffness(lever));
}

io::MeasuredGroup calibration_group(const ForceCalibration& of) {
  const surface::Calibration& calibration = of.calibration;
  const LineUnits units(calibration.load_unit);
  Group group("Calibration: " + of.name);
  group.add("psi", "calibration factor", "psi", units.psi(), units.psi_display(), calibration.psi,
            "zeta = psi m; common to all samples", calibration.deviation());
  group.add("psi_measurement_deviation", "share of its measurement", "by measurement", units.psi(), units.psi_display(),
            calibration.measurement_deviation);
  group.add("psi_reference_deviation", "share of what was taken over", "by reference", units.psi(), units.psi_display(),
            calibration.reference_deviation);
  if (of.silicon) {
    group.add("silicon_coefficient", "coefficient of friction of silicon, taken over", "mu_Si", "1", "1",
              of.silicon_coefficient.value, "", of.silicon_coefficient.deviation);
    add_line(*of.silicon, "silicon_", "", group);
  }
  if (of.lever) add_lever(*of.lever, group);
  if (of.wedge) {
    for (std::size_t k = 0; k < of.facets.size(); ++k) {
      const std::string head = fmt::format("facet_{}_", k + 1);
      group.add(head + "angle", "angle of " + of.facets[k].name + " to the base", "theta", "rad", "degree",
                of.angles[k].value, "", of.angles[k].deviation);
      add_line(of.facets[k], head, "", group);
    }
    const surface::Uncertain& friction = of.wedge->friction_coefficient;
    group.add("grating_friction", "coefficient of friction of tip and grating", "mu", "1", "1", friction.value, "",
              friction.deviation);
    group.add("width_mismatch", "width on the second facet off what it should be", "", "1", "%",
              of.wedge->width_mismatch, "not used, a check");
  }
  return group;
}

/// Coefficients beside each other.
io::MeasuredTable sample_table(const std::vector<ForceSample>& samples, const surface::ShearStrengths& strengths) {
  io::MeasuredTable table{"samples", "Coefficients of boundary shear strength", {}, {}, {}};
  const auto column = [&](const char* name, const char* words, const char* symbol) {
    add_column(table, name, words, symbol, "1", "1");
  };
  column("coefficient", "coefficient", "zeta");
  column("deviation", "its standard deviation", "deviation");
  column("by_slope", "share of the sample's own line", "slope");
  column("by_calibration", "share of the calibration's measurement", "calibration");
  column("by_reference", "share of what was taken over", "reference");
  column("interval_low", "95 % interval from", "low");
  column("interval_high", "to", "high");
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const surface::ShearStrength& s = strengths.samples[i];
    add_row(table, samples[i].name,
            {s.zeta, s.deviation(), s.slope_deviation, s.calibration_deviation, s.reference_deviation, s.low, s.high});
  }
  return table;
}

io::MeasuredTable correlation_table(const std::vector<ForceSample>& samples, const std::vector<std::string>& words,
                                    const surface::ShearStrengths& strengths) {
  io::MeasuredTable table{"correlations", "Correlation of the coefficients, by the common calibration", {}, {}, {}};
  for (std::size_t j = 0; j < samples.size(); ++j) {
    std::vector<double>& rows = add_column(table, "with_" + words[j], samples[j].name, samples[j].name, "1", "1");
    for (std::size_t i = 0; i < samples.size(); ++i) rows.push_back(strengths.correlation(i, j));
    table.row_labels.push_back(samples[j].name);
  }
  return table;
}

std::vector<std::string> statement_lines(const ForceCalibration& of, const ForceRule& rule, bool loops) {
  std::vector<std::string> lines;
  if (loops) {
    lines.push_back(
        fmt::format("friction signal: half the mean of trace less retrace, without {:.3g} % of the line at each end",
                    100 * rule.end_share));
  }
  if (rule.load_deviation) lines.push_back("standard deviation of each load: " + *rule.load_deviation + ", as stated");
  lines.push_back(stated(rule) ? "line by total least squares; its errors from the deviations as stated or measured"
                               : "line by total least squares; its errors from the scatter about it");
  if (of.silicon) {
    lines.push_back("calibrated on silicon, whose coefficient of friction is taken as " +
                    uncertain_text(of.silicon_coefficient));
  } else if (of.wedge) {
    lines.push_back(fmt::format("calibrated on two facets of a grating at {} and {} degrees",
                                uncertain_text(of.angles[0], kDegree), uncertain_text(of.angles[1], kDegree)));
  } else {
    lines.push_back("calibrated by the sizes of a rectangular lever");
  }
  return lines;
}

double square(double x) { return x * x; }

std::vector<std::string> note_lines(std::size_t n_samples, const SampleList& everything, const ForceCalibration& of,
                                    const surface::ShearStrengths& strengths, const ForceRule& rule) {
  std::vector<std::string> notes;
  const surface::ShearStrength& first = strengths.samples.front();
  const double reference = square(of.calibration.reference_deviation / of.calibration.psi);
  if (of.calibration.method == surface::CalibrationMethod::kSilicon && of.silicon_coefficient.deviation == 0) {
    notes.push_back(
        "the coefficient of silicon is taken as exact: no coefficient here is known better than it; state it with its "
        "+-");
  }
  if (reference > square(kNotableReference) && reference > kLargeShare * square(first.deviation() / first.zeta)) {
    notes.push_back(
        fmt::format("what was taken over for the calibration alone leaves {:.2g} % of every coefficient "
                    "open, most of its uncertainty; ratios between samples do not have it",
                    100 * std::sqrt(reference)));
  }
  for (const ForceSample* sample : everything) {
    if (stated(rule) && sample->line.chi_squared_probability < kTooSmallChance) {
      notes.push_back(
          fmt::format("{}: the loads scatter about the line far more than the deviations allow (chance "
                      "{:.2g} %): they are too small, or the relation is not linear; --deviations from-residuals "
                      "takes the errors from the scatter",
                      sample->name, 100 * sample->line.chi_squared_probability));
    }
    if (sample->line.offset < -3 * sample->line.offset_deviation) {
      notes.push_back(sample->name +
                      ": the line ends below zero at load zero, which adhesion does not do; is the zero "
                      "of the load right?");
    }
  }
  std::vector<std::string> at_zero;
  for (const surface::ShearStrength& s : strengths.samples) {
    if (s.low == 0) at_zero.push_back(s.sample);
  }
  if (!at_zero.empty()) {
    notes.push_back(joined(at_zero, ", ") +
                    ": the 95 % interval reaches zero and was cut off there, since friction is not negative");
  }
  if (of.wedge && std::abs(of.wedge->width_mismatch) > kWideMismatch) {
    notes.push_back(
        fmt::format("the loops on the second facet are {:.2g} % off the width that goes with the first: are "
                    "both of one material and the angles right?",
                    100 * of.wedge->width_mismatch));
  }
  if (n_samples > 1) {
    notes.push_back(
        "one calibration for all samples: their coefficients rise and fall together (see the correlations)");
  }
  return notes;
}

std::string file_names(const ForceSample& sample) {
  const std::string& first = sample.sources.front();
  const std::string name = file_name(first.substr(0, first.find(": ")));
  return sample.digests.size() < 2 ? name : fmt::format("{} and {} more", name, sample.digests.size() - 1);
}

std::string fragment_of(const ForceSample& sample, const surface::ShearStrength& strength, const ForceCalibration& of) {
  std::vector<std::string> heading = {"Coefficient of boundary shear strength of sample " + sample.name};
  for (std::size_t k = 0; k < sample.digests.size(); ++k) heading.push_back("loops: SHA-256 " + sample.digests[k]);
  heading.push_back(fmt::format("95 % interval {:.4g} to {:.4g}", strength.low, strength.high));
  return io::shear_strength_fragment(strength, file_names(sample), of.calibration.method, of.name, heading);
}

/// Do both hold a loop with the same numbers, or without loops the same table of loads?
bool have_common_numbers(const ForceSample& a, const ForceSample& b) {
  const auto is_loop_of_b = [&b](const surface::FrictionLoop& loop) {
    return std::find(b.loops.begin(), b.loops.end(), loop) != b.loops.end();
  };
  if (!a.loops.empty() || !b.loops.empty()) return std::any_of(a.loops.begin(), a.loops.end(), is_loop_of_b);
  return std::equal(a.loads.begin(), a.loads.end(), b.loads.begin(), b.loads.end(),
                    [](const auto& x, const auto& y) { return x.load == y.load && x.tmr_V == y.tmr_V; });
}

/// Loops cannot be their own reference, under whatever name their file comes.
void check_apart(const ForceSample& sample, const ForceSample& reference, const std::string& reference_is) {
  if (!have_common_numbers(sample, reference)) return;
  throw InputError(fmt::format("the sample {} ({}) and the calibration on {} ({}) have the same {}", sample.name,
                               joined(sample.paths, ", "), reference_is, joined(reference.paths, ", "),
                               sample.loops.empty() ? "loads and friction signals" : "loops"),
                   "name another file for one of them");
}

}  // namespace

ForceCalibration silicon_calibration(ForceSample silicon, surface::Uncertain reference) {
  ForceCalibration of;
  of.calibration = surface::calibrate_on_silicon(silicon.line, silicon.load_unit, reference);
  of.silicon = std::move(silicon);
  of.silicon_coefficient = reference;
  return of;
}

ForceCalibration wedge_calibration(std::vector<ForceSample> facets, const std::array<surface::Uncertain, 2>& angles_rad,
                                   const ForceRule& rule) {
  if (facets.size() != 2) {
    throw InputError(fmt::format("the wedge method requires the loops of two facets; {} came", facets.size()),
                     "one file for each, with unlike names: a line \"# sample: NAME\" distinguishes them");
  }
  if (facets[0].load_unit != facets[1].load_unit) {
    throw InputError("the loads of the two facets are not in one kind of unit", "both in volts, or both in newtons");
  }
  surface::WedgeFacet both[2];
  for (std::size_t k = 0; k < 2; ++k) {
    if (facets[k].loops.empty()) {
      throw InputError(facets[k].name + ": the wedge method needs friction loops; a summary has no offsets",
                       "give the loops themselves");
    }
    both[k] = {angles_rad[k], facets[k].line, surface::offset_load_line(facets[k].loads, rule.deviations)};
  }
  ForceCalibration of;
  of.wedge = surface::calibrate_on_wedge(both[0], both[1], facets[0].load_unit);
  of.calibration = of.wedge->calibration;
  of.facets = std::move(facets);
  of.angles = angles_rad;
  return of;
}

io::Measurement force_measurement(const std::vector<ForceSample>& samples, const ForceCalibration& of,
                                  const ForceRule& rule, const std::optional<std::size_t>& requested) {
  for (const ForceSample& sample : samples) {
    if (of.silicon) check_apart(sample, *of.silicon, "silicon");
    for (const ForceSample& facet : of.facets) check_apart(sample, facet, "a facet");
  }
  std::vector<surface::FrictionSample> lines;
  for (const ForceSample& sample : samples) lines.push_back({sample.name, sample.line, sample.load_unit});
  const surface::ShearStrengths strengths = surface::boundary_shear_strengths(lines, of.calibration);
  SampleList drawn;  // what psi turns into friction
  for (const ForceSample& sample : samples) drawn.push_back(&sample);
  if (of.silicon) drawn.push_back(&*of.silicon);
  SampleList everything = drawn;
  for (const ForceSample& facet : of.facets) everything.push_back(&facet);
  const std::vector<std::string> words = words_of(everything);

  io::Measurement all;
  all.kind = "lateral-force";
  all.title = "Boundary shear strength from friction loops";
  bool loops = false;
  for (const ForceSample* sample : everything) {
    all.sources.insert(all.sources.end(), sample->sources.begin(), sample->sources.end());
    loops = loops || !sample->loops.empty();
  }
  all.sources.insert(all.sources.end(), of.sources.begin(), of.sources.end());
  all.statements = statement_lines(of, rule, loops);
  all.notes = note_lines(samples.size(), everything, of, strengths, rule);

  for (std::size_t i = 0; i < samples.size(); ++i) {
    const std::string tail = samples.size() == 1 ? "" : "_" + words[i];
    all.groups.push_back(strength_group(samples[i], strengths.samples[i], tail));
    if (all.key_values.size() < 3) all.key_values.push_back("boundary_shear_strength_coefficient" + tail);
  }
  if (samples.size() == 1) all.key_values.insert(all.key_values.end(), {"low", "high"});
  all.groups.push_back(calibration_group(of));
  all.tables.push_back(sample_table(samples, strengths));
  if (samples.size() > 1) all.tables.push_back(correlation_table(samples, words, strengths));
  all.curves.push_back(friction_curve(drawn, words, of.calibration));
  for (std::size_t i = 0; i < everything.size(); ++i) {
    const ForceSample& sample = *everything[i];
    all.tables.push_back(load_table(sample, words[i], "Friction signal of each load, " + sample.name));
    for (io::MeasuredCurve& curve : loop_curves(sample, words[i], rule.end_share)) {
      all.curves.push_back(std::move(curve));
    }
  }
  const std::optional<std::size_t> chosen = requested             ? requested
                                            : samples.size() == 1 ? std::optional<std::size_t>(0)
                                                                  : std::nullopt;
  if (chosen) all.fragment = fragment_of(samples[*chosen], strengths.samples[*chosen], of);
  return all;
}

}  // namespace ringfilm::instrument
