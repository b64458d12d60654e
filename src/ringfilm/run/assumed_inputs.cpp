#include "ringfilm/run/assumed_inputs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <limits>
#include <optional>
#include <utility>
#include <variant>

#include "ringfilm/case/conditions.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/run/run.hpp"
#include "ringfilm/study/ensemble/threads.hpp"

namespace ringfilm::run {
namespace {

using cycle::Case;
using cycle::Field;
using io::TomlValue;

const std::string kContact = "contact.";

std::string plain_key(const std::string& key) {
  const auto of_ring = cycle::ring_key(key);
  return of_ring ? of_ring->key : key;
}

/// Do films depend on the key? Those of oil consumption follow from them.
bool changes_films(const std::string& key) {
  return key.rfind("oil_transport.", 0) != 0 && key.rfind("evaporation.", 0) != 0;
}

/// Is a default one that was assumed?
bool is_assumed_default(const Field& field, const Case& c) {
  if (field.is_for_record) return false;
  const bool by_conditions = cycle::is_engine(c.conditions) && cycle::is_replaced_by(c.conditions, field.key);
  return by_conditions || field.help.find("assumed") != std::string::npos;
}

/// An assumed input: in a pack the same key of [contact] in each ring is one.
struct Assumed {
  std::string key;
  std::vector<std::string> keys;  ///< in a pack those of the rings
  bool is_default;
};

std::vector<Assumed> find_assumed(const Case& c, const std::set<std::string>& called_assumed) {
  std::vector<Assumed> all;
  for (const io::CaseEntry& entry : io::case_entries(c)) {
    const std::string plain = plain_key(entry.key);
    const Field& field = *cycle::find_field(plain);
    const bool is_shared = plain != entry.key && plain.rfind(kContact, 0) == 0 && !called_assumed.contains(entry.key);
    const std::string& key = is_shared ? plain : entry.key;
    const Case& of = c.is_pack() ? c.rings.front() : c;
    const bool is_assumed = entry.assumed ? is_assumed_default(field, of) : called_assumed.contains(key);
    const bool is_number =
        !std::holds_alternative<cycle::CountKind>(field.kind) &&
        (std::holds_alternative<cycle::StrokeValuesKind>(field.kind) || entry.value_si == entry.value_si);
    if (!is_assumed || !is_number || field.is_for_record || !changes_films(plain)) continue;
    const auto same = std::ranges::find(all, key, &Assumed::key);
    if (same != all.end()) {
      same->keys.push_back(entry.key);
    } else {
      all.push_back({key, {entry.key}, entry.assumed});
    }
  }
  return all;
}

/// A quantity as a case file has it, with four digits.
TomlValue toml_of(double value, const Field& field, const io::Units& units) {
  constexpr int kDigits = 4;
  TomlValue toml = io::parse_toml_value(
      field.unit == "1" ? fmt::format("{:.{}g}", value, kDigits)
                        : "\"" + units.shown(value, field.unit, field.display_unit, kDigits) + "\"");
  return toml;
}

double moved(double value, const Field& field, double direction) {
  return field.unit == "K" ? value + direction * kAssumedTemperatureStep : value * (1 + direction * kAssumedStep);
}

/// The value of a key, moved; nothing where there is none, or 0, of which nothing is a share.
std::optional<TomlValue> moved_value(const std::string& key, const Case& c, double direction, const io::Units& units) {
  const io::LocatedKey located = io::located_key(c, key);
  const Field& field = located.field;
  const auto of = [&](double value) { return toml_of(moved(value, field, direction), field, units); };
  if (const auto* stroke = std::get_if<cycle::StrokeValuesKind>(&field.kind)) {
    const std::vector<cycle::StrokeValue>& points = stroke->ref(located.of);
    if (points.size() == 1) return of(points.front().value);
    TomlValue list;
    list.kind = TomlValue::Kind::kList;
    for (const cycle::StrokeValue& point : points) {
      TomlValue pair;
      pair.kind = TomlValue::Kind::kList;
      pair.items = {io::parse_toml_value("\"" + units.shown(point.distance, "m", "mm") + "\""), of(point.value)};
      list.items.push_back(std::move(pair));
    }
    return list;
  }
  for (const io::CaseEntry& entry : io::case_entries(located.of)) {
    if (entry.key == field.key && entry.value_si != 0) return of(entry.value_si);
  }
  return std::nullopt;
}

struct ChangedCase {
  Case input;
  std::string setting;
};

std::optional<ChangedCase> changed_case(const Assumed& assumed, const Case& c, double direction,
                                        const io::Units& units) {
  std::vector<io::Change> changes;
  for (const std::string& key : assumed.keys) {
    std::optional<TomlValue> value = moved_value(key, c, direction, units);
    if (!value) return std::nullopt;
    changes.push_back({key, std::move(*value)});
  }
  ChangedCase changed{c, ""};
  try {
    io::update(changed.input, changes, units);
    io::check_case(changed.input);
  } catch (const InputError&) {
    return std::nullopt;
  }
  changed.setting = fmt::format("{} = {}", assumed.key, changes.front().value->as_written());
  return changed;
}

struct FrictionAndFilm {
  double fmep, min_film;  ///< [Pa], [m]
};

/// Throws ConvergenceError, InputError.
FrictionAndFilm computed(const Case& c) {
  Request request{study::coarse_case(c), "", false, false, false, false};
  const CycleOutcome done = std::move(run_cycles({std::move(request)}, 1).front());
  if (done.stopped) throw *done.stopped;
  const io::ResultDocument& document = done.document;
  double film =
      document.is_pack() ? std::numeric_limits<double>::infinity() : document.result.values.min_film_thickness;
  for (const io::ResultDocument& ring : document.rings) film = std::min(film, ring.result.values.min_film_thickness);
  return {document.result.values.fmep, film};
}

void compute(const Case& changed, const FrictionAndFilm& unchanged, study::AssumedInput& input) {
  try {
    const FrictionAndFilm with = computed(changed);
    input.fmep_change = with.fmep / unchanged.fmep - 1;
    input.min_film_change = with.min_film / unchanged.min_film - 1;
  } catch (const ConvergenceError&) {
    input.solved = false;
  } catch (const InputError&) {
    input.solved = false;
  }
}

std::string shown(const Assumed& assumed, const Case& c) {
  for (const io::CaseEntry& entry : io::case_entries(c)) {
    if (entry.key == assumed.keys.front()) return entry.shown;
  }
  return "";
}

}  // namespace

std::vector<study::AssumedInput> assumed_inputs(const Case& c, const std::set<std::string>& called_assumed,
                                                int threads) {
  const io::Units units;
  std::vector<study::AssumedInput> inputs;
  std::vector<Case> changed;
  for (const Assumed& assumed : find_assumed(c, called_assumed)) {
    std::optional<ChangedCase> one = changed_case(assumed, c, 1, units);
    if (!one) one = changed_case(assumed, c, -1, units);
    if (!one) continue;
    inputs.push_back({assumed.key, shown(assumed, c), assumed.is_default, one->setting});
    changed.push_back(std::move(one->input));
  }
  const FrictionAndFilm unchanged = computed(c);
  std::atomic<std::size_t> next = 0;
  const int n = std::min(study::n_threads(threads), static_cast<int>(changed.size()));
  if (n > 0) {
    study::on_threads(n, [&](int) {
      for (std::size_t i = next++; i < changed.size(); i = next++) compute(changed[i], unchanged, inputs[i]);
    });
  }
  study::rank(inputs);
  return inputs;
}

std::size_t n_assumed_inputs(const Case& c, const std::set<std::string>& called_assumed) {
  return find_assumed(c, called_assumed).size();
}

}  // namespace ringfilm::run
