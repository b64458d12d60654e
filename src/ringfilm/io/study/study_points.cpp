#include "ringfilm/io/study/study_points.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>
#include <variant>

#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

/// Values of one key over the points.
struct KeyValues {
  std::string key;
  SourceMark mark;
  std::vector<TomlValue> values;
};

class PointsReader {
 public:
  PointsReader(const FactorSources& sources, std::vector<Fault>& faults) : sources_(sources), faults_(faults) {}

  StudyPoints read(const std::vector<TomlValue>& tables, const SourceMark& mark) {
    const std::size_t n_before = faults_.size();
    if (tables.empty()) {
      faults_.push_back(
          {mark, "method = \"operating-points\" has no points",
           "write [[point]] with name, weight and values = { \"operating.speed\" = \"1000 rpm\" } below"});
    }
    for (const TomlValue& table : tables) read_point(table);
    if (faults_.size() == n_before) {
      for (const KeyValues& of_key : keys_) add_factor(of_key);
    }
    return std::move(points_);
  }

 private:
  void read_point(const TomlValue& value) {
    TomlTable table(value, "[[point]]", {"name", "weight", "values"}, faults_);
    study::WeightedPoint point;
    point.name = table.needed_text("name", "\"idle\"");
    if (!names_.insert(point.name).second && !point.name.empty()) {
      table.refuse(table.find("name")->mark, fmt::format("two points have the name {}", point.name),
                   "give each a name of its own");
    }
    const TomlValue* weight = table.need("weight", "0.3");
    point.weight = table.number("weight").value_or(1);
    if (!(point.weight > 0)) {
      table.refuse(weight->mark, fmt::format("the weight of a point is above 0, not {}", weight->as_written()),
                   "write, for example, weight = 0.3");
    }
    const TomlValue* values = table.find("values");
    if (values == nullptr || values->kind != TomlValue::Kind::kTable || values->members.empty()) {
      table.refuse(values == nullptr ? table.mark() : values->mark, "[[point]] has no values",
                   "write, for example, values = { \"operating.speed\" = \"1000 rpm\" }");
      return;
    }
    take_values(table, *values);
    points_.points.push_back(std::move(point));
  }

  /// Each point states every key: a number of another point would otherwise be taken from the base.
  void take_values(TomlTable& table, const TomlValue& values) {
    const bool is_first = points_.points.empty();
    for (const TomlMember& member : values.members) {
      const auto found =
          std::find_if(keys_.begin(), keys_.end(), [&](const KeyValues& one) { return one.key == member.key; });
      if (found != keys_.end()) {
        found->values.push_back(member.value);
      } else if (is_first) {
        keys_.push_back({member.key, member.value.key_mark, {member.value}});
      } else {
        table.refuse(member.value.key_mark, fmt::format("{} is not a key of the first point", member.key),
                     "state the same keys at each point, at the others with the value of the base");
      }
    }
    for (const KeyValues& one : keys_) {
      if (one.values.size() == points_.points.size() + 1) continue;
      table.refuse(values.mark, fmt::format("the point has no {}, which others state", one.key),
                   "state the same keys at each point, at the others with the value of the base");
    }
  }

  static TomlMember member(const std::string& key, TomlValue value, const SourceMark& mark) {
    value.key_mark = mark;
    return {key, std::move(value)};
  }

  /// A factor with the values of all points, as [[factor]] would state them.
  void add_factor(const KeyValues& of_key) {
    TomlValue key, values, table;
    key.kind = TomlValue::Kind::kText;
    key.text = of_key.key;
    key.mark = values.mark = table.mark = table.key_mark = of_key.mark;
    values.kind = TomlValue::Kind::kList;
    values.items = of_key.values;
    table.kind = TomlValue::Kind::kTable;
    table.members = {member("key", key, of_key.mark), member("values", values, of_key.mark)};
    std::optional<study::Factor> factor = read_factor(table, sources_, faults_);
    if (!factor) return;
    points_.list.resize(points_.points.size());
    if (const auto* levels = std::get_if<study::Levels>(&factor->variation)) {
      for (std::size_t i = 0; i < levels->values.size(); ++i) points_.list[i].push_back(levels->values[i]);
      factor->variation = study::Listed{};
    } else {
      put_choices(*factor);
    }
    points_.factors.push_back(std::move(*factor));
  }

  /// Each text once, and at each point the place of its own.
  void put_choices(study::Factor& factor) {
    const auto given = std::get<study::Choices>(factor.variation).values;
    std::vector<study::Choice> once;
    for (std::size_t i = 0; i < given.size(); ++i) {
      auto at = std::find_if(once.begin(), once.end(), [&](const auto& one) { return one.text == given[i].text; });
      if (at == once.end()) at = once.insert(once.end(), given[i]);
      points_.list[i].push_back(static_cast<double>(at - once.begin()));
    }
    factor.variation = study::Choices{std::move(once)};
  }

  const FactorSources& sources_;
  std::vector<Fault>& faults_;
  std::set<std::string> names_;
  std::vector<KeyValues> keys_;
  StudyPoints points_;
};

}  // namespace

StudyPoints read_study_points(const std::vector<TomlValue>& tables, const SourceMark& mark,
                              const FactorSources& sources, std::vector<Fault>& faults) {
  return PointsReader(sources, faults).read(tables, mark);
}

}  // namespace ringfilm::io
