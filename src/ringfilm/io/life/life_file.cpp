#include "ringfilm/io/life/life_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <optional>

#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/cycle/pack/gas_quantities.hpp"
#include "ringfilm/io/life/duty_table.hpp"
#include "ringfilm/io/life/wear_table.hpp"
#include "ringfilm/io/study/document_reader.hpp"
#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/life/end_of_life.hpp"

namespace ringfilm::io {
namespace {

class LifeReader : DocumentReader {
 public:
  LifeReader(const std::string& path, const std::vector<Override>& overrides)
      : DocumentReader(path), overrides_(overrides) {}

  LifeFile read() {
    const TomlValue root = read_document(DocumentKind::kLife, "life");
    TomlTable table(root, "a life",
                    {"title", "case", "mode", "hours", "state", "path", "wear", "running_in", "duty", "report_point",
                     "pack", "end_of_life"},
                    faults_);
    life_.title = table.text("title").value_or(stem());
    table.choose("mode", {{"measured-path", life::Mode::kMeasuredPath}, {"archard", life::Mode::kArchard}}, life_.mode);
    read_hours(table);
    read_base(table);
    read_duty(table);
    for (const TomlValue& state : table.items("state")) read_state(state);
    read_path(table);
    read_wear(table);
    read_running_in(table);
    read_pack(table);
    read_end(table);
    if (faults_.empty() && n_duty_ == 0) faults_ = faults_without_points();
    if (faults_.empty()) read_points(table);
    state_accuracies();
    if (faults_.empty()) faults_ = life::faults_of(life_);
    if (!faults_.empty()) throw InputError(with_places(faults_));
    return {std::move(life_), std::move(files_)};
  }

 private:
  /// What is wrong whatever the points next to the base case, of which each costs the reading of a case.
  std::vector<Fault> faults_without_points() {
    const life::Life as_read = life_;
    state_accuracies();
    std::vector<Fault> faults = life::faults_of(life_);
    life_ = as_read;
    return faults;
  }

  /// What lies at no place of the file concerns it as a whole.
  std::vector<Fault> with_places(std::vector<Fault> faults) const {
    for (Fault& fault : faults) {
      if (fault.mark.file.empty()) fault.mark.file = path_;
    }
    return faults;
  }

  void read_hours(TomlTable& table) {
    const TomlValue* hours = table.find("hours");
    if (hours == nullptr || (hours->kind == TomlValue::Kind::kList && hours->items.empty())) {
      table.refuse(hours == nullptr ? SourceMark{path_, 0, 0, ""} : hours->mark, "the life has no hours to report",
                   "write, for example, hours = [\"0 h\", \"10 h\", \"150 h\"]");
      return;
    }
    for (const TomlValue& item : table.items("hours")) {
      if (const auto time = table.quantity("hours", item, "s", kTimeExample, units_))
        life_.times.push_back({*time, item.mark});
    }
  }

  /// The case that a key names; nothing if it cannot be read.
  std::optional<cycle::Case> read_named_case(TomlTable& table, const std::string& example) {
    const std::string name = table.needed_text("case", example);
    if (name.empty()) return std::nullopt;
    return read_ring(locate(name, folder_).shown, {}, table.find("case")->mark);
  }

  /// A case of one ring. @param mark where the life asks for it
  std::optional<cycle::Case> read_ring(const std::string& path, const std::vector<Override>& overrides,
                                       const SourceMark& mark) {
    auto input = read_at(
        mark, [&](std::vector<DroppedKey>& dropped) { return read_case_dropping(path, overrides, units_, dropped); });
    if (!input || !is_one_ring(*input, path, "a life", mark)) return std::nullopt;
    record(*input);
    return input;
  }

  /// Cells and steps in place of accuracies. All states share the nodes of the face: cells of one length, and those of
  /// the base case.
  void state_accuracies() {
    for (life::OperatingPoint& point : life_.points) {
      if (!point.input.solver.accuracy) continue;
      point.input = cycle::with_accuracy(std::move(point.input), cycle::CellLengths::kUniform);
      const std::string text = cycle::accuracy_text(point.input);
      if (life_.accuracy.find(text) == std::string::npos) life_.accuracy += (life_.accuracy.empty() ? "" : "; ") + text;
      point.input.solver.accuracy.reset();
    }
    for (life::MeasuredState& state : life_.states) state.input.solver.accuracy.reset();
  }

  /// What reads a case; nothing where it is refused. @param mark where the life asks for it
  template <class Read>
  std::optional<cycle::Case> read_at(const SourceMark& mark, const Read& read) {
    try {
      std::vector<DroppedKey> dropped;
      return read(dropped);
    } catch (const InputError& error) {
      append_case_faults(error, mark, faults_);
      return std::nullopt;
    }
  }

  void read_base(TomlTable& table) {
    if (auto input = read_named_case(table, "\"new.toml\"")) {
      life_.points.push_back({kWholeDuty, 1, std::move(*input)});
    }
  }

  /// What the duty and the points next to it state.
  void read_duty(TomlTable& table) {
    const DutySources sources{folder_, units_};
    std::vector<std::string> names;
    if (const TomlValue* value = table.find("duty")) {
      Duty duty = read_duty_table(*value, sources, faults_);
      check_end_of_duty(duty);
      stated_points_ = std::move(duty.points);
    } else {
      names.push_back(kWholeDuty);
    }
    n_duty_ = stated_points_.size();
    for (const StatedPoint& point : stated_points_) names.push_back(point.name);
    std::ranges::move(read_report_points(table.items("report_point"), names, sources, faults_),
                      std::back_inserter(stated_points_));
  }

  void check_end_of_duty(const Duty& duty) {
    for (const life::ReportedTime& now : life_.times) {
      constexpr double kRounding = 1e-9;
      if (!duty.length || now.time <= *duty.length * (1 + kRounding)) continue;
      faults_.push_back({now.mark,
                         fmt::format("the running time {} is after the end of the duty, {}", life::hours_text(now.time),
                                     life::hours_text(*duty.length)),
                         "ask for earlier hours, or repeat the segments more often"});
    }
  }

  /// The cases of the points, each another reading of the base case; a duty takes the place of that case.
  void read_points(TomlTable& table) {
    const std::string path = locate(table.find("case")->text, folder_).shown;
    const ReadBase read_base = [&](const std::vector<Override>& overrides, const SourceMark& mark) {
      return read_ring(path, overrides, mark);
    };
    if (n_duty_ > 0) life_.points.clear();
    std::ranges::move(operating_points(stated_points_, read_base, faults_), std::back_inserter(life_.points));
  }

  void read_state(const TomlValue& value) {
    TomlTable table(value, "[[state]]", {"hours", "case"}, faults_);
    life::MeasuredState state;
    state.mark = value.key_mark;
    if (const TomlValue* hours = table.need("hours", kTimeExample)) state.mark = hours->mark;
    const auto time = table.quantity("hours", "s", kTimeExample, units_);
    auto input = read_named_case(table, "\"run-in.toml\"");
    if (!time || !input) return;
    state.time = *time;
    state.input = std::move(*input);
    life_.states.push_back(std::move(state));
  }

  void read_path(TomlTable& root) {
    const TomlValue* value = root.find("path");
    if (value == nullptr) return;
    TomlTable table(*value, "[path]", {"time_scale", "time_constant", "datum"}, faults_);
    table.choose("datum", {{"own", life::Datum::kOwn}, {"common", life::Datum::kCommon}}, life_.datum);
    if (life_.datum == life::Datum::kCommon && life_.mode == life::Mode::kArchard) {
      table.refuse_key("datum", "means nothing with mode = \"archard\"",
                       "leave it out: the face of a scenario is not on the path");
    }
    life::Interpolation& path = life_.path;
    table.choose("time_scale", {{"logarithmic", life::TimeScale::kLogarithmic}, {"linear", life::TimeScale::kLinear}},
                 path.scale);
    if (path.scale == life::TimeScale::kLinear) {
      table.refuse_key("time_constant", "means nothing with time_scale = \"linear\"",
                       "leave it out, or take time_scale = \"logarithmic\"");
    }
    const auto constant = table.quantity("time_constant", "s", kTimeExample, units_);
    if (constant && !(*constant > 0)) {
      table.refuse_value("time_constant", "is not above 0",
                         "state a time after which the ring changes more slowly, for example \"1 h\"");
    }
    path.time_constant = constant.value_or(path.time_constant);
  }

  void read_wear(TomlTable& root) {
    const TomlValue* value = root.find("wear");
    const bool wears = life_.mode == life::Mode::kArchard;
    if (value == nullptr) {
      if (!wears) return;
      faults_.push_back({{path_, 0, 0, ""},
                         "mode = \"archard\" has no [wear]",
                         "write [wear] and, for example, coefficient = \"4e-18 m2/N\" below"});
      return;
    }
    if (!wears) {
      root.refuse(value->key_mark, "[wear] means nothing with mode = \"measured-path\"",
                  "leave it out, or take mode = \"archard\"");
      return;
    }
    const cycle::Case* base = life_.points.empty() ? nullptr : &life_.points.front().input;
    life_.wear = read_wear_table(*value, base, units_, faults_);
  }

  void read_running_in(TomlTable& root) {
    const TomlValue* value = root.find("running_in");
    if (value == nullptr) return;
    TomlTable table(*value, "[running_in]", {"roughness_limit", "depth_scale", "surface"}, faults_);
    life::RunningIn& law = life_.running_in.emplace();
    law.mark = table.mark();
    table.choose("surface", {{"liner", life::RunningInSurface::kLiner}, {"ring", life::RunningInSurface::kRing}},
                 law.surface);
    const auto read_length = [&](const std::string& key, const std::string& example, double& length, SourceMark& mark) {
      const TomlValue* stated = table.need(key, example);
      if (stated == nullptr) return;
      mark = stated->mark;
      length = table.quantity(key, *stated, "m", example, units_).value_or(1);
      if (!(length > 0)) {
        table.refuse_value(key, "is not above 0", fmt::format("state, for example, {} = {}", key, example));
      }
    };
    read_length("roughness_limit", "\"0.1 um\"", law.roughness_limit, law.limit_mark);
    read_length("depth_scale", "\"0.3 um\"", law.depth_scale, law.scale_mark);
  }

  /// A pack, of which only the gas is used.
  void read_pack(TomlTable& root) {
    const TomlValue* value = root.find("pack");
    if (value == nullptr) return;
    TomlTable table(*value, "[pack]", {"case", "ring", "pressures"}, faults_);
    if (value->kind != TomlValue::Kind::kTable) return;
    const std::string name = table.needed_text("case", "\"pack.toml\"");
    const std::uint64_t ring = table.count("ring").value_or(1);
    auto pressures = life::RingPressures::kGiven;
    table.choose("pressures", {{"given", life::RingPressures::kGiven}, {"computed", life::RingPressures::kComputed}},
                 pressures);
    if (name.empty()) return;
    const SourceMark mark = table.find("case")->mark;
    auto input = read_at(mark, [&](std::vector<DroppedKey>& dropped) {
      return read_case_dropping(locate(name, folder_).shown, overrides_, units_, dropped, CasePurpose::kGasPath);
    });
    if (!input) return;
    record(*input);
    const std::size_t n = std::max<std::size_t>(1, input->rings.size());
    if (ring < 1 || ring > n) {
      table.refuse_value("ring", fmt::format("is not from 1 to {}", n), "rings count from the chamber");
      return;
    }
    life_.pack = life::RingPack{std::move(*input), static_cast<std::size_t>(ring), pressures, mark};
  }

  /// A limit for each quantity that the user names.
  void read_end(TomlTable& root) {
    const TomlValue* value = root.find("end_of_life");
    if (value == nullptr) return;
    std::vector<std::string> names;
    for (const cycle::Quantity& quantity : life::limitable_quantities()) names.push_back(quantity.name);
    TomlTable table(*value, "[end_of_life]", names, faults_);
    for (const cycle::Quantity& quantity : life::limitable_quantities()) {
      if (table.find(quantity.name) == nullptr) continue;
      if (cycle::is_gas_sum(quantity.name) && root.find("pack") == nullptr) {
        table.refuse_key(quantity.name, "needs the gas of a ring pack, and the life has none",
                         "write [pack] with, for example, case = \"pack.toml\", or limit end_gap_growth");
        continue;
      }
      const std::string example = quantity.unit == "1" ? "0.5" : fmt::format("\"1 {}\"", quantity.display_unit);
      const auto number = table.quantity(quantity.name, quantity.unit, example, units_);
      if (number) life_.end_rules.push_back({quantity.name, *number});
    }
  }

  static constexpr const char* kWholeDuty = "duty";        // the point of a life without [duty]
  static constexpr const char* kTimeExample = "\"10 h\"";  // as one would write it

  const std::vector<Override>& overrides_;
  life::Life life_;
  std::vector<StatedPoint> stated_points_;  ///< those of the duty, then those next to it
  std::size_t n_duty_ = 0;
};

}  // namespace

LifeFile read_life(const std::string& path, const std::vector<Override>& overrides) {
  return LifeReader(path, overrides).read();
}

}  // namespace ringfilm::io
