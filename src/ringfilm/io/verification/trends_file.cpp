#include "ringfilm/io/verification/trends_file.hpp"

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <set>
#include <utility>

#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/toml_table.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

/// Scatter of a pack at the default solver.step_error is about 1 %.
constexpr double kMinChange = 0.02;
constexpr std::uint64_t kMaxRings = 100;
constexpr double kCycle = 720;  // [degree]

class TrendsReader {
 public:
  TrendsReader(const std::string& path, const Units& units) : path_(path), units_(units) {}

  study::TrendList read() {
    const TomlValue root = parse_toml(read_source_text(path_, path_, kMaxToml));
    for (const auto& [name, tables] : root.members) {
      const bool is_known = name == "base" || name == "trend" || name == "inexpressible";
      if (!is_known || tables.kind != TomlValue::Kind::kList) {
        faults_.push_back(
            {tables.key_mark, "unknown key " + name, "tables are [[base]], [[trend]] and [[inexpressible]]"});
        continue;
      }
      for (const TomlValue& value : tables.items) {
        TomlTable table(value, "[[" + name + "]]", faults_);
        if (name == "base") read_base(table);
        if (name == "trend") read_trend(table);
        if (name == "inexpressible") read_inexpressible(table);
        table.refuse_the_rest();
      }
    }
    if (list_.trends.empty() && faults_.empty()) throw InputError(path_ + " has no [[trend]]", "add one");
    if (!faults_.empty()) throw InputError(std::move(faults_));
    return std::move(list_);
  }

 private:
  void read_base(TomlTable& table) {
    study::TrendBase base;
    base.name = table.needed_text("name");
    base.start_engine = table.text("start").value_or("");
    if (base.start_engine.empty()) {
      base.path = locate(table.needed_text("case"), fs::path(path_).parent_path().string()).shown;
    }
    list_.bases.push_back(std::move(base));
  }

  void read_inexpressible(TomlTable& table) {
    study::InexpressibleTrend trend;
    trend.id = needed_id(table);
    trend.statement = table.needed_text("statement");
    trend.source = table.needed_text("source");
    trend.reason = table.needed_text("reason");
    list_.inexpressible.push_back(std::move(trend));
  }

  void read_trend(TomlTable& table) {
    study::Trend trend;
    trend.id = needed_id(table);
    trend.statement = table.needed_text("statement");
    trend.source = table.needed_text("source");
    trend.size = table.text("size").value_or("");
    trend.assumed = table.needed_text("assumed");
    trend.base = table.needed_text("base");
    if (std::ranges::find(list_.bases, trend.base, &study::TrendBase::name) == list_.bases.end()) {
      table.refuse_value("base", "is not the name of a [[base]] above");
    }
    trend.settings = settings(table);
    read_levels(table, trend.levels);
    read_probe(table, trend.probe);
    read_expectation(table, trend);
    trend.least_change = table.number("least_change").value_or(kMinChange);
    table.need("known", "\"agrees\"");
    table.choose("known", study::agreements(), trend.known);
    if (trend.known == study::Agreement::kDisagrees) trend.reason = table.needed_text("reason");
    list_.trends.push_back(std::move(trend));
  }

  std::string needed_id(TomlTable& table) {
    std::string id = table.needed_text("id");
    if (!ids_.insert(id).second && !id.empty()) table.refuse_value("id", "is the id of two trends");
    return id;
  }

  static std::vector<std::string> settings(TomlTable& table) {
    std::vector<std::string> all = table.texts("set");
    if (std::ranges::any_of(all, [](const auto& one) { return one.find('=') == std::string::npos; })) {
      table.refuse_value("set", "holds no key=value", "for example \"operating.speed=2000 rpm\"");
    }
    return all;
  }

  void read_levels(TomlTable& table, std::vector<study::TrendLevel>& levels) {
    table.need("levels", "[{ name = \"2000 rpm\", set = [\"operating.speed=2000 rpm\"] }]");
    const std::vector<TomlValue> values = table.items("levels");
    for (const TomlValue& value : values) {
      TomlTable level(value, "a level", {"name", "set"}, faults_);
      const std::string name = level.needed_text("name");
      levels.push_back({name, settings(level)});
    }
    if (values.empty()) table.refuse_value("levels", "has no level");
  }

  void read_probe(TomlTable& table, study::TrendProbe& probe) {
    probe.quantity = table.needed_text("quantity");
    probe.share_of = table.text("share_of");
    if (const TomlValue* ring = table.find("ring")) {
      probe.ring = static_cast<std::size_t>(table.count("ring", *ring, 1, kMaxRings).value_or(1));
    }
    if (table.find("between") != nullptr) read_window(table, probe.window.emplace());
    const auto check = [&](const char* key, const std::string& name) {
      if (name.empty() || study::find_probed(probe, name)) return;
      table.refuse_value(
          key,
          probe.window ? "is not a curve over crank angle" : "is not a value of the cycle or of the gas between rings",
          probe.window ? "" : "of a curve over crank angle state between and take");
    };
    check("quantity", probe.quantity);
    if (!probe.share_of) return;
    check("share_of", *probe.share_of);
    if (study::is_of_gas(probe)) table.refuse_key("share_of", "has no meaning for the gas between rings", "remove it");
  }

  void read_window(TomlTable& table, study::CrankWindow& window) {
    std::vector<double> angles;
    for (const TomlValue& item : table.items("between")) {
      angles.push_back(table.quantity("between", item, "degree", "\"60 degree\"", units_).value_or(0));
    }
    if (angles.size() != 2 || angles[0] < 0 || angles[1] < angles[0] || angles[1] > kCycle) {
      table.refuse_value("between", "is not two crank angles from 0 to 720 degree");
    } else {
      window.from_deg = angles[0];
      window.to_deg = angles[1];
    }
    table.need("take", "\"largest\"");
    using enum study::WindowValue;
    table.choose<study::WindowValue>("take", {{"largest", kMax}, {"smallest", kMin}, {"mean", kMean}}, window.value);
  }

  void read_expectation(TomlTable& table, study::Trend& trend) {
    using enum study::TrendExpectation;
    table.need("expect", "\"rises\"");
    table.choose("expect", study::trend_expectations(), trend.expectation);
    if (trend.expectation == kLargerChangeThan) {
      trend.than = table.needed_text("than");
      const bool is_above = std::ranges::any_of(list_.trends, [&](const auto& one) { return one.id == trend.than; });
      if (!is_above) table.refuse_value("than", "is not the id of a trend above");
    }
    if (trend.expectation == kWithin) read_limits(table, trend);
    if (trend.expectation != kWithin && trend.levels.size() == 1) {
      table.refuse_value("expect", "requires two levels or more");
    }
  }

  void read_limits(TomlTable& table, study::Trend& trend) {
    const bool is_known = study::find_probed(trend.probe, trend.probe.quantity).has_value();
    const std::string unit =
        trend.probe.share_of || !is_known ? "1" : study::find_probed(trend.probe, trend.probe.quantity)->unit;
    table.need("limits");
    std::vector<double> limits;
    for (const TomlValue& item : table.items("limits")) {
      limits.push_back(table.quantity("limits", item, unit, "\"1 " + unit + "\"", units_).value_or(0));
    }
    if (limits.size() != 2) {
      table.refuse_value("limits", "is not two numbers, the smallest and the largest");
      return;
    }
    trend.least_limit = limits[0];
    trend.most_limit = limits[1];
  }

  const std::string& path_;
  const Units& units_;
  std::set<std::string> ids_;
  std::vector<Fault> faults_;
  study::TrendList list_;
};

}  // namespace

std::string trends_path() {
  return (fs::path(shipped_folder()) / "verification" / "measured_trends" / "trends.toml").string();
}

study::TrendList read_trends(const std::string& path, const Units& units) { return TrendsReader(path, units).read(); }

}  // namespace ringfilm::io
