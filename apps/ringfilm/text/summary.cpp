#include "text/summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "gas_path/gas_tables.hpp"
#include "ringfilm/base/joined.hpp"
#include "ringfilm/io/result/pack_sums.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "text/engineering_text.hpp"
#include "text/note_text.hpp"
#include "text/wrapped_text.hpp"

namespace ringfilm::app {
namespace {

using cycle::CycleValues;

enum class Detail { kShort, kAll };

constexpr int kValueWidth = 12;
constexpr int kValueWithErrorWidth = 24;

class Table {
 public:
  Table(const CycleValues& values, const std::optional<study::ErrorEstimate>& errors)
      : values_(values), errors_(errors) {}

  /// A line for the cycle value of that name, with a remark.
  void add(const std::string& name, const std::string& remark = "") {
    const cycle::CycleQuantity& quantity = cycle_quantity(name);
    text_ += fmt::format("{:>{}}   {}{}\n", shown(name), errors_ ? kValueWithErrorWidth : kValueWidth,
                         quantity.long_name, remark.empty() ? "" : " (" + remark + ")");
  }
  std::string shown(const std::string& name) const {
    const auto value = cycle_quantity(name).value;
    return errors_ ? in_words_(name, values_.*value, errors_->values.*value) : in_words_(name, values_.*value);
  }
  std::string at(const std::string& angle_name) const { return "at " + shown(angle_name); }

  const std::string& text() const { return text_; }

 private:
  const CycleValues& values_;
  const std::optional<study::ErrorEstimate>& errors_;
  EngineeringText in_words_;
  std::string text_;
};

std::string percent(double part, double whole) { return fmt::format("{:.0f} %", whole > 0 ? 100 * part / whole : 0.0); }

std::string values_table(const CycleValues& values, const std::optional<study::ErrorEstimate>& errors, Detail detail) {
  Table table(values, errors);
  const bool all = detail == Detail::kAll;
  table.add("fmep");
  table.add("mean_power_loss", "boundary " + percent(values.mean_boundary_power, values.mean_power_loss) +
                                   ", viscous " + percent(values.mean_viscous_power, values.mean_power_loss));
  if (all) {
    table.add("energy_per_cycle", fmt::format("power {}, exhaust {}, intake {}, compression {}",
                                              percent(values.power_stroke_energy, values.energy_per_cycle),
                                              percent(values.exhaust_stroke_energy, values.energy_per_cycle),
                                              percent(values.intake_stroke_energy, values.energy_per_cycle),
                                              percent(values.compression_stroke_energy, values.energy_per_cycle)));
    table.add("mean_total_friction", "boundary " + table.shown("mean_boundary_friction") + ", viscous " +
                                         table.shown("mean_viscous_friction"));
  }
  table.add("peak_total_friction", table.at("peak_total_friction_angle"));
  if (all) {
    table.add("peak_boundary_friction", table.at("peak_boundary_friction_angle"));
    table.add("peak_viscous_friction", table.at("peak_viscous_friction_angle"));
  }
  table.add("peak_friction_coefficient", table.at("peak_friction_coefficient_angle") +
                                             "; within 60 degree of firing TDC " +
                                             table.shown("peak_friction_coefficient_firing"));
  table.add("min_film_thickness", table.at("min_film_thickness_angle"));
  table.add("lambda_ratio_at_peak_pressure", "lowest of the cycle " + table.shown("min_lambda_ratio"));
  const std::string other_regimes = fmt::format("mixed {}, full film {}", percent(values.mixed_regime_cycle_share, 1),
                                                percent(values.full_film_cycle_share, 1));
  table.add(
      "boundary_regime_cycle_share",
      other_regimes +
          (all ? fmt::format("; of the friction energy {}, {} and {}", percent(values.boundary_regime_energy_share, 1),
                             percent(values.mixed_regime_energy_share, 1), percent(values.full_film_energy_share, 1))
               : ""));
  table.add("mean_absolute_oil_flow", all ? "net " + table.shown("net_oil_flow") + ", positive to the crankcase" : "");
  const bool follows_oil = values.oil_replenished != 0 || values.oil_scraped_up != 0 || values.oil_scraped_down != 0;
  if (follows_oil) {
    table.add("oil_replenished", "left at TDC " + table.shown("oil_scraped_up") +
                                     (all ? ", at BDC " + table.shown("oil_scraped_down") : ""));
  }
  if (values.gas_through_film_forward + values.gas_through_film_back > 0) {
    table.add("gas_through_film_forward",
              all ? "back " + table.shown("gas_through_film_back") + "; upper bounds" : "upper bound");
  }
  table.add("peak_film_pressure",
            "peak gas pressure " + table.shown("peak_gas_pressure") + " " + table.at("peak_gas_pressure_angle"));
  table.add("archard_wear_load");
  return table.text();
}

/// The cylinder pressure by the numbers with which an indicated one is checked.
std::string indicated_line(const std::map<std::string, double>& derived) {
  const auto imep = derived.find("imep"), index = derived.find("compression_index");
  if (imep == derived.end()) return "";
  std::string text = "cylinder pressure: IMEP " + text_in(imep->second, kBar, 4);
  if (index != derived.end()) text += fmt::format(", polytropic index of compression {:.3g}", index->second);
  return text + "\n";
}

/// What only an unrolled film has: its grid, and what the ends of the gap do.
std::string unrolled_lines(const cycle::Case& input, const cycle::CycleResult& result) {
  const EngineeringText in_words;
  std::string text = fmt::format("film on the unrolled ring: {} x {} cells, {} around", input.solver.cells,
                                 input.solver.cells_y, text_in(input.ring_length(), kMillimetre));
  const auto shown = [&](const char* name) {
    const auto& all = cycle::unrolled_cycle_quantities();
    const auto found = std::find_if(all.begin(), all.end(), [&](const auto& q) { return q.name == name; });
    return in_words(*found, result.unrolled_values.*found->value);
  };
  text += input.ring.end_gap ? fmt::format(", gap of {} at {:.4g} degree", text_in(*input.ring.end_gap, kMillimetre, 4),
                                           input.ring.gap_position_deg)
                             : ", joined without a gap";
  if (input.bends() && result.complete) {
    text += fmt::format(
        "; the ring bends: largest clearance {} ({}), open area where it is lifted off {} on average, "
        "{} at the most ({})",
        shown("peak_clearance"), shown("peak_clearance_angle"), shown("mean_open_area"), shown("peak_open_area"),
        shown("peak_open_area_angle"));
  }
  if (input.ring.end_gap && result.complete) {
    text += fmt::format(
        "; oil into the gap {} on average, negative out of it; the largest flow either way {} ({}), to and fro {} of "
        "the flow at the middle section; share "
        "of the ends in load {}, friction power {}, flow {}",
        shown("mean_gap_leakage"), shown("peak_gap_leakage"), shown("peak_gap_leakage_angle"),
        shown("gap_leakage_share"), shown("ends_share_mean_load"), shown("ends_share_friction_power"),
        shown("ends_share_absolute_flow"));
  }
  return wrapped(words(text));
}

std::string error_lines(const study::ErrorEstimate& errors, cycle::StepControl control) {
  std::string grids;
  for (const study::GridRun& run : errors.runs) {
    const std::string around = run.cells_y > 0 ? fmt::format(" x {}", run.cells_y) : "";
    grids +=
        fmt::format("{}{}{} cells at {:.4g} degree", grids.empty() ? "" : ", ", run.cells, around, run.crank_step_deg);
    if (control == cycle::StepControl::kAdaptive) grids += fmt::format(" (step_error {:.3g})", run.step_error);
  }
  return wrapped(words("+- is the error of cells and crank steps, from the grids " + grids +
                       "; errors of the models and the inputs are not included"));
}

std::string stopped_solver_lines(const cycle::Effort& effort) {
  return wrapped(words(fmt::format("solver: stopped after {} crank steps and {} Newton iterations", effort.crank_steps,
                                   effort.newton_iterations)));
}

std::string solver_lines(const cycle::Effort& effort) {
  std::string text = fmt::format(
      "solver: {:.4g} cycles until the state repeats (to {:.1e}), {} crank steps, {} Newton iterations; load balanced "
      "to {:.1e} (relative)",
      effort.cycles_integrated, effort.periodicity_error, effort.crank_steps, effort.newton_iterations,
      effort.max_load_residual);
  if (effort.max_mass_residual > 0) text += fmt::format(", mass to {:.1e}", effort.max_mass_residual);
  const long n_fallbacks = effort.fallback_secant + effort.fallback_sub_step;
  if (n_fallbacks > 0) text += fmt::format("; {} steps needed the fallback chain", n_fallbacks);
  return wrapped(words(text));
}

/// What is not printed, counted.
std::string counts_line(const io::ResultDocument& document) {
  const auto n_default = std::count_if(document.inputs.begin(), document.inputs.end(),
                                       [](const io::CaseEntry& entry) { return entry.assumed; });
  std::set<std::string> topics;
  long steps = 0;
  for (const io::ResultDocument& ring : io::rings_of(document)) {
    for (const study::LedgerEntry& entry : ring.ledger) topics.insert(entry.topic);
    steps += ring.result.effort.crank_steps;
  }
  return wrapped(words(
      fmt::format("{} default inputs, {} modelling assumptions, {} crank steps in {:.4g} cycles; "
                  "--all prints them, more values and all notes",
                  n_default, topics.size(), steps, io::rings_of(document).front().result.effort.cycles_integrated)));
}

std::string assumption_lines(const io::ResultDocument& document) {
  std::string topics;
  for (const study::LedgerEntry& entry : document.ledger) topics += (topics.empty() ? "" : ", ") + entry.topic;
  return wrapped(words(fmt::format("modelling assumptions: {} ({})", document.ledger.size(), topics))) +
         (document.ledger_computed
              ? ""
              : "    `ringfilm check` describes them; --ledger computes what other choices would change\n");
}

std::string note_lines(const io::ResultDocument& document) {
  std::string text;
  for (const std::string& note : document.input_notes) text += wrapped(words("note: " + note));
  for (const auto& [topic, message, count] : document.result.notes) {
    text += wrapped(words("note: " + message + (count > 1 ? fmt::format(" ({} times)", count) : "")));
  }
  return text;
}

std::string oil_temperature(const cycle::Case& c) {
  if (!c.thermal.is_stated()) return "oil at " + text_in(c.operating.oil_temperature, kCelsius);
  return fmt::format("oil film at the temperature of {}", c.thermal.film == cycle::FilmTemperature::kRing ? "the ring"
                                                          : c.thermal.film == cycle::FilmTemperature::kLiner
                                                              ? "the liner"
                                                              : "its walls (their mean)");
}

std::string ring_shares(const std::vector<io::RingSums>& rings, double whole) {
  std::string text;
  for (const io::RingSums& ring : rings) {
    text += fmt::format("  ring {}: {:>8.4g} kPa FMEP, {:>8.4g} W, {} of the pack\n", ring.ring,
                        number_in(ring.values.fmep, kKilopascal), ring.values.mean_power_loss,
                        percent(ring.values.mean_power_loss, whole));
  }
  return text;
}

std::string pack_oil_lines(const io::ResultDocument& pack) {
  const std::optional<io::PackOil> oil = io::pack_oil(pack);
  if (!oil) return "";
  return wrapped(words(fmt::format(
      "oil on the liner above the first ring: {} after the power stroke, {} after the intake stroke; it leaves {} at "
      "TDC per cycle",
      text_in(oil->film_after_power_stroke, kMicrometre, 4), text_in(oil->film_after_intake_stroke, kMicrometre, 4),
      text_in(oil->left_at_tdc, kMilligram, 3))));
}

/// The unit in which a loss is printed.
const DisplayUnit& shown_unit(const cycle::OilLoss& loss) {
  static constexpr DisplayUnit kPercent{"1", "%", {1, 100}}, kGramPerKwh{"kg/J", "g/kWh", kGramPerKilowattHour.scale};
  return loss.unit == "1" ? kPercent : loss.unit == "kg/J" ? kGramPerKwh : kGramPerHour;
}

/// Which inputs narrow the band of the total.
std::string narrowed_lines(const std::vector<cycle::OilLoss>& losses) {
  std::string text;
  for (const cycle::NarrowedBand& band : cycle::narrowed_bands(losses)) {
    text += fmt::format("{} {} ({:.0f} % of its width, {:.2g} to {:.2g} g/h would remain)",
                        text.empty() ? "the band of the total narrows, where these are known, by" : ",", band.input,
                        100 * band.band_share, number_in(band.low, kGramPerHour), number_in(band.high, kGramPerHour));
  }
  return text.empty() ? "" : wrapped(words(text));
}

/// The loss of a cylinder, and what narrows it most.
std::string oil_consumption_line(const std::vector<cycle::OilLoss>& losses) {
  const auto total = std::find_if(losses.begin(), losses.end(),
                                  [](const cycle::OilLoss& loss) { return loss.name == cycle::kTotalOilLoss; });
  if (total == losses.end()) return "";
  const auto shown = [](double loss) { return fmt::format("{:.2g}", number_in(loss, kGramPerHour)); };
  std::string text = fmt::format("oil consumption of the cylinder, estimated: {} g/h ({} to {})", shown(total->value),
                                 shown(total->low), shown(total->high));
  const std::vector<cycle::NarrowedBand> bands = cycle::narrowed_bands(losses);
  if (!bands.empty()) text += ", least known: " + bands.front().input;
  return wrapped(words(text));
}

std::string oil_consumption_table(const std::vector<cycle::OilLoss>& losses) {
  if (losses.empty()) return "";
  std::string text = fmt::format("{:<30}{:>11}{:>11}{:>11}\n", "oil consumption, estimated", "low", "value", "high");
  for (const cycle::OilLoss& loss : losses) {
    const DisplayUnit& unit = shown_unit(loss);
    const auto cell = [&unit](double value) { return fmt::format("{:>11.2g}", number_in(value, unit)); };
    std::string name = loss.name == cycle::kEngineOilLoss     ? "engine, all cylinders"
                       : loss.name == cycle::kTotalOilLoss    ? "total of one cylinder"
                       : loss.name == cycle::kFuelShareOfOil  ? "engine, share of fuel"
                       : loss.name == cycle::kSpecificOilLoss ? "engine, over brake power"
                                                              : loss.name;
    std::replace(name.begin(), name.end(), '_', ' ');
    text += fmt::format("  {:<28}{}{}{}   {}\n", name, cell(loss.low), cell(loss.value), cell(loss.high), unit.name);
  }
  return text + narrowed_lines(losses);
}

/// Blow-by and peaks of pressure.
std::string gas_line(const io::ResultDocument& pack) {
  std::string text = "blow-by per cylinder " + blow_by_text(pack.gas->sums) + reverse_blow_by_text(pack.gas->sums) +
                     "; peaks of pressure";
  for (std::size_t i = 1; i + 1 < pack.gas->regions.size(); ++i) {
    const gas_path::RegionValues& region = pack.gas->regions[i];
    text += fmt::format("{} {} {}", i > 1 ? "," : "", region.name, text_in(region.peak_pressure, kBar, 3));
  }
  return text;
}

std::string pack_gas_lines(const io::ResultDocument& pack) {
  if (!pack.gas) return "";
  std::string text = wrapped(words(gas_line(pack)));
  for (const std::string& table :
       {paths_table(*pack.gas), composition_table(*pack.gas), ring_motion_table(*pack.gas)}) {
    if (!table.empty()) text += "\n" + table;
  }
  return text;
}

}  // namespace

std::string default_input_lines(const std::vector<io::CaseEntry>& inputs) {
  std::vector<std::string> entries;
  for (const io::CaseEntry& entry : inputs) {
    if (entry.assumed) entries.push_back(entry.key + " = " + entry.shown);
  }
  if (entries.empty()) return "default inputs: none, the case states every key in use\n";
  std::vector<std::string> pieces = {
      fmt::format("default inputs: {} keys that the case does not state:", entries.size())};
  for (const std::string& entry : entries) pieces.push_back(entry + (&entry == &entries.back() ? "" : ","));
  return wrapped(pieces);
}

std::string pack_summary(const io::ResultDocument& pack) {
  const EngineeringText in_words;
  const auto shown = [&](const char* name) { return in_words(name, pack.result.values.*cycle_quantity(name).value); };
  if (!pack.result.complete) return "all rings: no sums, since one stopped\n";
  const std::vector<io::RingSums> rings = io::ring_sums(pack);
  return wrapped(
             words(fmt::format("all {} rings: friction mean effective pressure {}, mean power loss {}, {} per cycle",
                               rings.size(), shown("fmep"), shown("mean_power_loss"), shown("energy_per_cycle")))) +
         ring_shares(rings, pack.result.values.mean_power_loss) + pack_oil_lines(pack) +
         oil_consumption_table(pack.oil_losses) + pack_gas_lines(pack);
}

namespace {

std::string conditions_line(const cycle::Case& input) {
  return wrapped(words(fmt::format("{}, {}; cylinder pressure: {}", text_in(input.operating.speed, kRpm),
                                   oil_temperature(input), pressure_origin(input.gas))));
}

/// "ring 1: top ring, ring 2: ..." of rings that have names.
std::string ring_names(const cycle::Case& pack) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < pack.rings.size(); ++i) {
    const std::string& name = pack.rings[i].ring.name;
    if (!name.empty()) names.push_back(fmt::format("ring {}: {}", i + 1, name));
  }
  return names.empty() ? "" : wrapped(words(joined(names, ", ")));
}

/// Lines of notes of a result that is not printed whole, so that it fits a screen.
constexpr std::size_t kNoteLines = 6, kPackNoteLines = 12;

/// Values of the rings side by side.
class RingColumns {
 public:
  explicit RingColumns(const io::ResultDocument& pack) : pack_(pack), labels_(labels()) {
    line("", "all rings", [this](std::size_t i) { return labels_[i]; });
  }

  const std::vector<std::string>& names() const { return labels_; }

  /// @param of_pack has the pack this value, too?
  void add(const std::string& name, bool of_pack) {
    const cycle::CycleQuantity& quantity = cycle_quantity(name);
    const std::string unit = quantity.display_unit == "1" ? "" : " [" + quantity.display_unit + "]";
    line(quantity.long_name + unit, of_pack ? number(quantity, pack_.result.values) : "",
         [&](std::size_t i) { return number(quantity, pack_.rings[i].result.values); });
  }
  void add_boundary_share() {
    const auto share = [](const CycleValues& v) { return percent(v.mean_boundary_power, v.mean_power_loss); };
    line("boundary share of it", share(pack_.result.values),
         [&](std::size_t i) { return share(pack_.rings[i].result.values); });
  }
  const std::string& text() const { return text_; }

 private:
  /// "ring 2", and of an oil ring with rails "3 upper".
  std::vector<std::string> labels() const {
    const std::vector<std::size_t> numbers = io::ring_numbers(pack_);
    std::vector<std::string> labels;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
      const bool has_rails = std::count(numbers.begin(), numbers.end(), numbers[i]) > 1;
      const bool is_upper = has_rails && (i == 0 || numbers[i - 1] != numbers[i]);
      labels.push_back(!has_rails ? fmt::format("ring {}", numbers[i])
                                  : fmt::format("{} {}", numbers[i], is_upper ? "upper" : "lower"));
    }
    return labels;
  }
  template <class Cell>
  void line(const std::string& name, const std::string& of_pack, const Cell& of_ring) {
    text_ += fmt::format("{:<{}}{:>{}}", name, kNameWidth, of_pack, kWidth);
    for (std::size_t i = 0; i < labels_.size(); ++i) text_ += fmt::format("{:>{}}", of_ring(i), kWidth);
    text_ += "\n";
  }
  std::string number(const cycle::CycleQuantity& quantity, const CycleValues& values) const {
    const std::string text = in_words_(quantity, values.*quantity.value);
    return text.substr(0, text.find(' '));
  }

  static constexpr int kNameWidth = 47, kWidth = 10;
  const io::ResultDocument& pack_;
  std::vector<std::string> labels_;
  EngineeringText in_words_;
  std::string text_;
};

}  // namespace

std::string short_summary(const cycle::Case& input, const io::ResultDocument& document) {
  const cycle::CycleResult& result = document.result;
  if (!result.complete) return summary(input, document);
  const NoteText notes({&document}, {""});
  std::string text = document.title + "\n" + conditions_line(input) + notes.verdict() + "\n";
  if (!result.samples.empty()) text += values_table(result.values, document.errors, Detail::kShort) + "\n";
  text += indicated_line(result.derived) + oil_consumption_line(document.oil_losses);
  if (!result.unrolled.is_absent()) text += unrolled_lines(input, result);
  if (document.errors && study::has_values(*document.errors)) {
    text += error_lines(*document.errors, input.solver.crank_step_control);
  }
  return text + notes.most_serious(kNoteLines) + counts_line(document);
}

std::string short_pack_summary(const cycle::Case& input, const io::ResultDocument& pack) {
  RingColumns columns(pack);
  columns.add("fmep", true);
  columns.add("mean_power_loss", true);
  columns.add_boundary_share();
  for (const char* name : {"peak_total_friction", "min_film_thickness", "min_lambda_ratio",
                           "boundary_regime_cycle_share", "mixed_regime_cycle_share", "peak_film_pressure"}) {
    columns.add(name, false);
  }
  std::vector<const io::ResultDocument*> rings;
  for (const io::ResultDocument& ring : pack.rings) rings.push_back(&ring);
  const NoteText notes(rings, columns.names());
  std::string text = pack.title + "\n" + conditions_line(input) + ring_names(input) + notes.verdict() + "\n" +
                     columns.text() + "\n" + pack_oil_lines(pack) + oil_consumption_line(pack.oil_losses);
  if (pack.gas) text += wrapped(words(gas_line(pack)));
  return text + notes.most_serious(kPackNoteLines) + counts_line(pack);
}

std::string summary(const cycle::Case& input, const io::ResultDocument& document) {
  std::string text = document.title + "\n" + conditions_line(input) + "\n";
  const cycle::CycleResult& result = document.result;
  if (!result.complete) {
    text += fmt::format(
        "STOPPED after {:.4g} cycles, before the cycle repeated itself; {} crank angles are in the result, but no "
        "values "
        "of the cycle\n\n",
        result.effort.cycles_integrated, result.samples.size());
  }
  if (result.complete && !result.samples.empty())
    text += values_table(result.values, document.errors, Detail::kAll) + "\n";
  text += indicated_line(result.derived);
  if (!document.oil_losses.empty()) text += oil_consumption_table(document.oil_losses) + "\n";
  if (!result.unrolled.is_absent()) text += unrolled_lines(input, result);
  if (document.errors && study::has_values(*document.errors))
    text += error_lines(*document.errors, input.solver.crank_step_control);
  text += result.complete ? solver_lines(result.effort) : stopped_solver_lines(result.effort);
  text += default_input_lines(document.inputs) + assumption_lines(document) + note_lines(document);
  return text;
}

std::string ledger_table(const io::ResultDocument& document) {
  const CycleValues& base = document.result.values;
  const auto change = [](double with, double without) {
    return without == 0 ? std::string("-") : fmt::format("{:+.1f} %", 100 * (with / without - 1));
  };
  std::string text =
      fmt::format("{:<68}{:>12}{:>12}{:>12}\n", "the other choice alone", "min film", "mean power", "mean |flow|");
  for (const study::LedgerEntry& entry : document.ledger) {
    for (const study::LedgerVariant& variant : entry.variants) {
      if (!variant.solved) {
        text += fmt::format("  {:<66}  not solved: {}\n", variant.setting, variant.reason);
        continue;
      }
      text += fmt::format("  {:<66}{:>12}{:>12}{:>12}\n", variant.setting,
                          change(variant.values.min_film_thickness, base.min_film_thickness),
                          change(variant.values.mean_power_loss, base.mean_power_loss),
                          change(variant.values.mean_absolute_oil_flow, base.mean_absolute_oil_flow));
    }
  }
  return text;
}

}  // namespace ringfilm::app
