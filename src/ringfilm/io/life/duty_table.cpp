#include "ringfilm/io/life/duty_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/toml_table.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

/// What the length of a part of a duty is called and written as.
struct Form {
  const char* list;     ///< name of the list, "segment"
  const char* length;   ///< key of the length
  const char* example;  ///< example of a length
};
constexpr Form kSegments{"segment", "duration", "\"10 min\""}, kPoints{"point", "weight", "0.3"};

/// The trace of a case with the excess over its least pressure scaled, so that its highest pressure is `peak` [Pa].
void scale_trace(double peak, cycle::Case& c) {
  cycle::SampledTrace trace = *c.gas.cylinder_pressure;
  const auto [low, high] = std::minmax_element(trace.value.begin(), trace.value.end());
  const double least = *low, factor = (peak - least) / (*high - least);
  for (double& p : trace.value) p = least + factor * (p - least);
  c.gas.cylinder_pressure = std::move(trace);
}

/// @returns whether the case has such a trace
bool put_peak(const StatedPoint& point, cycle::Case& input, std::vector<Fault>& faults) {
  if (!point.peak) return true;
  if (input.gas.model != cycle::GasModel::kTrace) {
    faults.push_back({point.peak_mark, "peak_pressure scales a trace, and the gas model is not \"trace\"",
                      "state it as set = { \"gas.peak_pressure\" = \"90 bar\" }"});
    return false;
  }
  const std::vector<double>& values = (*input.gas.cylinder_pressure).value;
  const double least = *std::min_element(values.begin(), values.end());
  if (*point.peak <= least) {
    faults.push_back({point.peak_mark,
                      fmt::format("the peak pressure {} is not above the least pressure of the trace, {}",
                                  text_in(*point.peak, kBar), text_in(least, kBar)),
                      "state a higher peak_pressure, with the reference of the trace"});
    return false;
  }
  scale_trace(*point.peak, input);
  return true;
}

/// Keys of an operating point beside its length.
std::vector<std::string> point_keys() {
  return {"name", "speed", "oil_temperature", "cylinder_pressure", "peak_pressure", "set"};
}

/// Reads what an operating point changes of the base case.
class PointReader {
 public:
  PointReader(const DutySources& sources, std::vector<Fault>& faults) : sources_(sources), faults_(faults) {}

  /// With a share of 0; nothing where it was refused. Names are each used once.
  std::optional<StatedPoint> read(TomlTable& part) {
    const std::size_t n_before = faults_.size();
    StatedPoint point;
    point.mark = part.mark();
    point.name = part.needed_text("name", "\"idle\"");
    if (!point.name.empty() && !names_.insert(point.name).second) {
      part.refuse(part.find("name")->mark, fmt::format("two operating points have the name {}", point.name),
                  "give each a name of its own");
    }
    point.overrides = overrides_of(part);
    if (const TomlValue* value = part.find("peak_pressure")) {
      point.peak_mark = value->mark;
      point.peak = part.quantity("peak_pressure", "Pa", "\"90 bar\"", sources_.units);
    }
    return faults_.size() > n_before ? std::nullopt : std::optional(std::move(point));
  }

  void reserve(const std::string& name) { names_.insert(name); }

 private:
  std::vector<Override> overrides_of(TomlTable& part) {
    std::vector<Override> overrides;
    const auto add = [&](const char* key, const char* of_case) {
      if (const auto text = part.text(key)) overrides.push_back({of_case, value_text(of_case, *text)});
    };
    add("speed", "operating.speed");
    add("oil_temperature", "operating.oil_temperature");
    add("cylinder_pressure", "gas.cylinder_pressure");
    const TomlValue* set = part.find("set");
    if (set == nullptr) return overrides;
    if (set->kind != TomlValue::Kind::kTable) {
      part.refuse(set->mark, "set is not a table", "write set = { \"gas.model\" = \"wiebe\" }");
      return overrides;
    }
    for (const TomlMember& member : set->members) {
      const bool is_text = member.value.kind == TomlValue::Kind::kText;
      overrides.push_back(
          {member.key, is_text ? value_text(member.key, member.value.text) : member.value.as_written()});
    }
    return overrides;
  }

  /// Names of files count from the life's file, those of overrides from the working folder.
  std::string value_text(const std::string& key, const std::string& text) const {
    const cycle::Field* field = cycle::find_field(key);
    const bool is_file = field != nullptr && study::is_file(*field);
    return quoted(is_file ? locate(text, sources_.folder).shown : text);
  }

  const DutySources& sources_;
  std::vector<Fault>& faults_;
  std::set<std::string> names_;
};

class DutyReader {
 public:
  DutyReader(const TomlValue& value, const DutySources& sources, std::vector<Fault>& faults)
      : table_(value, "[duty]", {"repeat", "segment", "point"}, faults),
        sources_(sources),
        faults_(faults),
        points_(sources, faults) {}

  Duty read() {
    const std::size_t n_before = faults_.size();
    const bool has_points = table_.find("point") != nullptr;
    const Form& form = has_points ? kPoints : kSegments;
    if (has_points && table_.find("segment") != nullptr) {
      table_.refuse(table_.find("point")->key_mark, "[duty] has segments and points",
                    "give all parts a duration, or all of them a weight");
    }
    const std::vector<TomlValue> parts = table_.items(form.list);
    for (const TomlValue& part : parts) read_part(part, form);
    if (parts.empty() && faults_.size() == n_before) {
      table_.refuse(table_.mark(), "[duty] has neither segments nor points, and so no length",
                    "write [[duty.segment]] with name, duration and speed below");
    }
    read_repeat(form, n_before);
    if (faults_.size() > n_before) return {};
    share_out();
    return std::move(duty_);
  }

 private:
  void read_part(const TomlValue& value, const Form& form) {
    std::vector<std::string> keys = point_keys();
    keys.emplace_back(form.length);
    TomlTable part(value, fmt::format("[[duty.{}]]", form.list), keys, faults_);
    const std::size_t n_before = faults_.size();
    const double length = read_length(part, form);
    std::optional<StatedPoint> point = points_.read(part);
    if (!point || faults_.size() > n_before) return;
    point->share = length;
    duty_.points.push_back(std::move(*point));
  }

  /// Lengths as shares; relative to the largest, so that no sum of them runs out of range.
  void share_out() {
    double largest = 0, total = 0;
    for (const StatedPoint& point : duty_.points) largest = std::max(largest, point.share);
    for (const StatedPoint& point : duty_.points) total += point.share / largest;
    for (StatedPoint& point : duty_.points) point.share = point.share / largest / total;
  }

  double read_length(TomlTable& part, const Form& form) {
    part.need(form.length, form.example);
    const bool is_weight = &form == &kPoints;
    const std::optional<double> length =
        is_weight ? part.number(form.length) : part.quantity(form.length, "s", form.example, sources_.units);
    if (length && !(*length > 0)) {
      part.refuse_value(form.length, "is not above 0",
                        fmt::format("write, for example, {} = {}; a point outside the duty is a [[report_point]]",
                                    form.length, form.example));
    }
    if (!is_weight && length > life::kMaxTime) {
      part.refuse_value(form.length, "is more than a century",
                        "durations are up to " + life::hours_text(life::kMaxTime));
    }
    return length.value_or(0);
  }

  void read_repeat(const Form& form, std::size_t n_before) {
    const auto repeat = table_.count("repeat");
    if (!repeat) return;
    if (*repeat == 0) {
      table_.refuse_value("repeat", "leaves no duty", "state how often the segments follow one another");
    } else if (&form == &kPoints) {
      table_.refuse_key("repeat", "means nothing with points, which have weights and no duration",
                        "leave it out, or give the parts as [[duty.segment]] with durations");
    } else if (faults_.size() == n_before) {
      double total = 0;
      for (const StatedPoint& part : duty_.points) total += part.share;
      duty_.length = static_cast<double>(*repeat) * total;
    }
  }

  TomlTable table_;
  const DutySources& sources_;
  std::vector<Fault>& faults_;
  PointReader points_;
  Duty duty_;  ///< shares are lengths until all are known
};

}  // namespace

Duty read_duty_table(const TomlValue& value, const DutySources& sources, std::vector<Fault>& faults) {
  return DutyReader(value, sources, faults).read();
}

std::vector<StatedPoint> read_report_points(const std::vector<TomlValue>& values,
                                            const std::vector<std::string>& names_of_duty, const DutySources& sources,
                                            std::vector<Fault>& faults) {
  PointReader reader(sources, faults);
  for (const std::string& name : names_of_duty) reader.reserve(name);
  std::vector<StatedPoint> points;
  for (const TomlValue& value : values) {
    TomlTable table(value, "[[report_point]]", point_keys(), faults);
    if (auto point = reader.read(table)) points.push_back(std::move(*point));
  }
  return points;
}

std::vector<life::OperatingPoint> operating_points(const std::vector<StatedPoint>& stated, const ReadBase& read_base,
                                                   std::vector<Fault>& faults) {
  constexpr int kMaxRefused = 10;  // each costs the reading of a case, and one cause often refuses all
  std::vector<life::OperatingPoint> points;
  int refused = 0;
  for (std::size_t i = 0; i < stated.size(); ++i) {
    const StatedPoint& point = stated[i];
    if (refused == kMaxRefused) {
      faults.push_back({point.mark, fmt::format("{} more operating points were not read", stated.size() - i),
                        "correct those before it first"});
      break;
    }
    std::optional<cycle::Case> input = read_base(point.overrides, point.mark);
    if (input && put_peak(point, *input, faults)) {
      points.push_back({point.name, point.share, std::move(*input)});
    } else {
      ++refused;
    }
  }
  return points;
}

}  // namespace ringfilm::io
