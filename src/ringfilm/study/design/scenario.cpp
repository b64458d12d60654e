#include "ringfilm/study/design/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <type_traits>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/case/accuracy.hpp"
#include "ringfilm/case/conditions.hpp"
#include "ringfilm/cycle/checks/case_rules.hpp"
#include "ringfilm/study/design/wording.hpp"

namespace ringfilm::study {
namespace {

using namespace cycle;

struct EntryOf {
  Entry operator()(const NumberKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const OptionalNumberKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const NumberOrFileKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const OptionalNumberOrFileKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const ConstantOrTemperatureValuesKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const CountKind&) const { return Entry::kWholeNumber; }
  Entry operator()(const NumberListKind&) const { return Entry::kScaleOnly; }
  Entry operator()(const TemperatureValuesKind&) const { return Entry::kScaleOnly; }
  Entry operator()(const StrokeValuesKind&) const { return Entry::kAnyNumber; }
  Entry operator()(const FourierTermsKind&) const { return Entry::kScaleOnly; }
  Entry operator()(const ChoiceKind&) const { return Entry::kText; }
  Entry operator()(const TextKind&) const { return Entry::kText; }
  Entry operator()(const OptionalTextKind&) const { return Entry::kText; }
  Entry operator()(const FileKind&) const { return Entry::kText; }
  Entry operator()(const OptionalFileKind&) const { return Entry::kText; }
  Entry operator()(const UnitNameKind&) const { return Entry::kNone; }
  Entry operator()(const DistillationKind&) const { return Entry::kNone; }
  Entry operator()(const CornersKind&) const { return Entry::kNone; }
  Entry operator()(const AnglesKind&) const { return Entry::kNone; }
  Entry operator()(const FieldAnglesKind&) const { return Entry::kNone; }
};

/// Puts one number into one key of a case.
class NumberWriter {
 public:
  NumberWriter(Case& c, const Field& field, const Factor& factor, double number, std::vector<Fault>& faults)
      : case_(c), field_(field), factor_(factor), number_(number), faults_(faults) {}

  void operator()(const NumberKind& kind) { kind.ref(case_) = changed(kind.ref(case_)); }
  void operator()(const OptionalNumberKind& kind) { change_optional(kind.ref(case_)); }
  void operator()(const NumberOrFileKind& kind) {
    if (kind.file(case_)) {
      refuse_file();
    } else {
      kind.number(case_) = changed(kind.number(case_));
    }
  }
  void operator()(const OptionalNumberOrFileKind& kind) {
    LandPressure& pressure = kind.ref(case_);
    if (pressure.file) {
      refuse_file();
    } else {
      change_optional(pressure.constant);
    }
  }
  void operator()(const ConstantOrTemperatureValuesKind& kind) {
    if (factor_.how == FactorMode::kSet) {
      kind.constant(case_) = changed(0);
      kind.ref(case_).clear();
    } else if (kind.constant(case_)) {
      change_optional(kind.constant(case_));
    } else {
      (*this)(TemperatureValuesKind{kind.ref});
    }
  }
  void operator()(const TemperatureValuesKind& kind) {
    for (TemperatureValue& point : kind.ref(case_)) point.value = changed(point.value);
  }
  void operator()(const FourierTermsKind& kind) {
    for (FourierTerm& term : kind.ref(case_)) term.amplitude = changed(term.amplitude);
  }
  void operator()(const StrokeValuesKind& kind) {
    if (factor_.how == FactorMode::kSet) {
      kind.ref(case_) = {{0, changed(0)}};
    } else {
      for (StrokeValue& point : kind.ref(case_)) point.value = changed(point.value);
    }
  }
  void operator()(const NumberListKind& kind) {
    for (double& value : kind.ref(case_)) value = changed(value);
  }
  void operator()(const CountKind& kind) {
    const double count = changed(kind.ref(case_));
    if (count != std::round(count) || std::abs(count) > 1e9) {
      refuse("= " + number_text(count) + " is not a whole number", "list whole numbers");
    } else {
      kind.ref(case_) = static_cast<int>(count);
    }
  }
  template <class Other>
  void operator()(const Other&) {
    throw std::logic_error("a key that takes no number: " + field_.key);
  }

 private:
  double changed(double base) {
    const double value = factor_.how == FactorMode::kSet     ? number_
                         : factor_.how == FactorMode::kScale ? base * number_
                                                             : base + number_;
    if (!std::isfinite(value)) {
      refuse("is not finite", "check the distribution and the gain of the factor");
    } else if (field_.range && !field_.range->contains(value)) {
      refuse("= " + with_unit(value, field_) + " is out of range", "allowed is " + range_words(field_));
    }
    return value;
  }

  void change_optional(std::optional<double>& value) {
    if (factor_.how == FactorMode::kSet) {
      value = changed(0);
    } else if (value) {
      value = changed(*value);
    } else {
      refuse("is not stated in this base", "there is nothing to scale or to add to; state it, or set it");
    }
  }

  void refuse_file() {
    refuse("is read from a file in this base", "a number cannot take its place in a study; state one in the base");
  }

  void refuse(const std::string& predicate, const std::string& remedy) {
    faults_.push_back({factor_.mark, called(factor_) + ": " + field_.key + " " + predicate, remedy});
  }

  Case& case_;
  const Field& field_;
  const Factor& factor_;
  double number_;
  std::vector<Fault>& faults_;
};

void choose(Case& c, const Field& field, const Choice& choice) {
  if (const auto* along_stroke = std::get_if<StrokeValuesKind>(&field.kind)) {
    along_stroke->ref(c) = choice.along_stroke;
    return;
  }
  const auto* names = std::get_if<ChoiceKind>(&field.kind);
  if (names == nullptr) throw std::logic_error("a text that no model computes with: " + choice.text);
  const auto found = std::find(names->names.begin(), names->names.end(), choice.text);
  if (found == names->names.end()) throw std::logic_error("a choice that the key does not have: " + choice.text);
  const cycle::Conditions before = c.conditions;
  names->choose(c, static_cast<int>(found - names->names.begin()));
  if (c.conditions != before) cycle::replace_conditions(c);
}

/// Puts in what was read from files with the choices of the point.
void put_readings(const Study& study, const Point& point, Case& c) {
  for (const FileReading& reading : study.readings) {
    std::vector<std::optional<std::size_t>> choices;
    for (const std::size_t j : reading.factors) {
      const std::optional<double> value = applies(study.factors.at(j), point.base) ? point.values.at(j) : std::nullopt;
      choices.push_back(value ? std::optional(static_cast<std::size_t>(*value)) : std::nullopt);
    }
    const bool is_chosen = std::any_of(choices.begin(), choices.end(), [](const auto& one) { return one.has_value(); });
    if (is_chosen) reading.put(c, point.base, choices);
  }
}

constexpr int kTurns = 5;

/// The only key of a file that is kept as text: the case contains just the name of that file.
constexpr const char* kOilFile = "lubricant.file";

/// When it is the turn of a factor: conditions must not undo a choice, no choice a number, and no number that is set
/// one that is added.
int turn(const Factor& factor) {
  const auto is_conditions = [](const Target& target) { return target.key == "conditions"; };
  if (std::any_of(factor.targets.begin(), factor.targets.end(), is_conditions)) return 1;
  if (std::holds_alternative<Choices>(factor.variation)) return 2;
  return factor.how == FactorMode::kSet ? 3 : factor.how == FactorMode::kScale ? 4 : kTurns;
}

struct ValueText {
  Case& c;
  std::string operator()(const NumberKind& kind) const { return exact(kind.ref(c)); }
  std::string operator()(const OptionalNumberKind& kind) const { return optional(kind.ref(c)); }
  std::string operator()(const CountKind& kind) const { return std::to_string(kind.ref(c)); }
  std::string operator()(const ChoiceKind& kind) const { return kind.names.at(kind.index(c)); }
  std::string operator()(const TextKind& kind) const { return kind.ref(c); }
  std::string operator()(const OptionalTextKind& kind) const { return kind.ref(c).value_or("-"); }
  // How a file is named depends on the folder from which the program is started; its digest is among Case::files.
  std::string operator()(const FileKind& kind) const { return named(!kind.ref(c).empty()); }
  std::string operator()(const OptionalFileKind& kind) const { return named(kind.ref(c).has_value()); }
  std::string operator()(const NumberOrFileKind& kind) const {
    return exact(kind.number(c)) + " " + named(kind.file(c).has_value());
  }
  std::string operator()(const OptionalNumberOrFileKind& kind) const {
    return optional(kind.ref(c).constant) + " " + named(kind.ref(c).file.has_value());
  }
  std::string operator()(const UnitNameKind& kind) const { return exact(kind.ref(c)); }
  std::string operator()(const NumberListKind& kind) const { return listed(kind.ref(c)); }
  std::string operator()(const TemperatureValuesKind& kind) const { return listed_pairs(kind.ref(c)); }
  std::string operator()(const ConstantOrTemperatureValuesKind& kind) const {
    return optional(kind.constant(c)) + " " + (*this)(TemperatureValuesKind{kind.ref});
  }
  std::string operator()(const FourierTermsKind& kind) const {
    std::string text;
    for (const FourierTerm& term : kind.ref(c)) {
      text += std::to_string(term.order) + " " + exact(term.amplitude) + " " + exact(term.phase_deg) + " " +
              optional(term.height) + " ";
    }
    return text;
  }
  std::string operator()(const StrokeValuesKind& kind) const { return listed_pairs(kind.ref(c)); }
  std::string operator()(const CornersKind& kind) const { return listed_pairs(kind.ref(c)); }
  std::string operator()(const DistillationKind& kind) const {
    std::string text;
    for (const models::OilFraction& fraction : kind.ref(c)) {
      text += exact(fraction.share) + " " + exact(fraction.boiling_point) + " " + optional(fraction.molar_mass) + " ";
    }
    return text;
  }
  std::string operator()(const AnglesKind&) const {
    return exact(c.output.crank_angle_step_deg) + " " + listed(c.output.crank_angles_deg);
  }
  std::string operator()(const FieldAnglesKind&) const {
    return std::to_string(static_cast<int>(c.output.fields)) + " " + listed(c.output.field_angles_deg);
  }

  static std::string named(bool is_there) { return is_there ? "file" : "-"; }
  static std::string optional(const std::optional<double>& value) { return value ? exact(*value) : "-"; }
  template <class Pair>
  static std::string listed_pairs(const std::vector<Pair>& values) {
    std::string text;
    for (const auto& [place, value] : values) text.append(exact(place)).append(" ").append(exact(value)).append(" ");
    return text;
  }
  static std::string listed(const std::vector<double>& values) {
    std::string text;
    for (const double value : values) text.append(exact(value)).append(" ");
    return text;
  }
};

std::vector<RuleBreach> rules_broken(const Case& c, Compute compute) {
  std::vector<RuleBreach> all = broken_pack_rules(c);
  for (const Case& ring : c.is_pack() ? c.rings : std::vector{c}) {
    const auto of_ring = compute == Compute::kGas ? broken_gas_rules(ring) : broken_rules(ring);
    all.insert(all.end(), of_ring.begin(), of_ring.end());
  }
  return all;
}

/// Are cells or steps stated, in a file or by a value that is not the usual one?
bool states_resolution(const Case& c) {
  const Solver &solver = c.solver, usual;
  return std::any_of(c.stated.begin(), c.stated.end(), is_chosen_by_accuracy) || solver.cells != usual.cells ||
         solver.tolerance != usual.tolerance || solver.cell_lengths != usual.cell_lengths ||
         solver.crank_step_deg != usual.crank_step_deg || solver.crank_step_control != usual.crank_step_control ||
         solver.time_scheme != usual.time_scheme || solver.step_error != usual.step_error;
}

/// Is it a film of the kind whose accuracy was measured?
bool has_known_accuracy(const Case& c) {
  return c.problem == Problem::kCycle && !c.is_unrolled() && c.film.supply_at_inlet() == cycle::OilSupply::kFlooded &&
         c.solver.method == cycle::Method::kCoupledNewton;
}

/// What a pack has beside its rings is that of the first.
void take_first_ring(Case& pack) {
  Case all = pack.rings.front();
  all.stated = std::move(pack.stated);
  all.files = std::move(pack.files);
  all.notes = std::move(pack.notes);
  all.rings = std::move(pack.rings);
  pack = std::move(all);
}

}  // namespace

const Field* field_of_key(const std::string& key) {
  const auto of_ring = ring_key(key);
  return find_field(of_ring ? of_ring->key : key);
}

std::vector<KeyPlace> places_of_key(Case& c, const std::string& key) {
  const Field* field = field_of_key(key);
  if (field == nullptr) throw std::logic_error("a key that does not exist: " + key);
  if (!c.is_pack()) return {{&c, field}};
  std::vector<KeyPlace> places;
  const auto of_ring = ring_key(key);
  for (std::size_t i = 0; i < c.rings.size(); ++i) {
    if (!of_ring || of_ring->ring == i + 1) places.push_back({&c.rings[i], field});
    const bool is_next = of_ring && of_ring->ring == i && of_ring->key == "ring.pressure_below";
    if (is_next) places.push_back({&c.rings[i], find_field("ring.pressure_above")});
  }
  return places;
}

std::optional<Fault> missing_key(const Case& base, const std::string& key) {
  const auto of_ring = ring_key(key);
  if (!base.is_pack()) {
    if (!of_ring) return std::nullopt;
    return Fault{{}, "a case of one ring has no " + key, "write " + of_ring->key};
  }
  const std::string rings = "a pack of " + std::to_string(base.rings.size()) + " rings has no " + key;
  if (!of_ring && is_of_ring(key)) return Fault{{}, rings, "state the ring, from the chamber: " + pack_key(1, key)};
  if (!of_ring) return std::nullopt;
  if (of_ring->ring < 1 || of_ring->ring > base.rings.size()) {
    return Fault{{}, rings, "its rings are 1 to " + std::to_string(base.rings.size()) + ", from the chamber"};
  }
  if (is_implied_in_pack(of_ring->ring, of_ring->key)) {
    return Fault{
        {}, rings, "it is the pressure below the ring above: " + pack_key(of_ring->ring - 1, "ring.pressure_below")};
  }
  return std::nullopt;
}

Entry entry_of(const Field& field) { return is_file(field) ? Entry::kText : std::visit(EntryOf{}, field.kind); }

bool is_file(const Field& field) {
  return std::holds_alternative<FileKind>(field.kind) || std::holds_alternative<OptionalFileKind>(field.kind) ||
         field.key == kOilFile;
}

bool decides_reading(const Field& field) {
  return entry_of(field) == Entry::kText && !std::holds_alternative<ChoiceKind>(field.kind) && !field.is_for_record;
}

std::string with_unit(double value, const Field& field) {
  return field.unit == "1" || field.unit.empty() ? number_text(value) : number_text(value) + " " + field.unit;
}

std::string range_words(const Field& field) {
  if (!field.range) return "any number";
  const Range& range = *field.range;
  return std::string(range.low_open ? "above " : "") + with_unit(range.low, field) +
         (range.high_open ? " to below " : " to ") + with_unit(range.high, field);
}

Case scenario_case(const Study& study, const Point& point) {
  Case c = study.bases.at(point.base).input;
  std::vector<Fault> faults;
  // What a file brings must not undo what is chosen beside it.
  put_readings(study, point, c);
  for (int now = 1; now <= kTurns; ++now) {
    for (std::size_t j = 0; j < study.factors.size(); ++j) {
      const Factor& factor = study.factors[j];
      if (turn(factor) != now || !point.values.at(j)) continue;
      for (const Target& target : factor.targets) {
        if (target.base && *target.base != point.base) continue;
        for (const auto& [of, field] : places_of_key(c, target.key)) {
          if (decides_reading(*field)) continue;
          if (const auto* choices = std::get_if<Choices>(&factor.variation)) {
            choose(*of, *field, choices->values.at(static_cast<std::size_t>(*point.values[j])));
          } else {
            NumberWriter writer(*of, *field, factor, target.gain * *point.values[j], faults);
            std::visit(writer, field->kind);
          }
          of->stated.insert(field->key);
        }
        c.stated.insert(target.key);
      }
    }
  }
  c = with_accuracy_of_study(std::move(c), study);
  // Rules presume that every number is within its range.
  if (faults.empty()) {
    for (const RuleBreach& breach : rules_broken(c, study.compute)) {
      faults.push_back({{}, breach.message, breach.remedy});
    }
  }
  if (!faults.empty()) throw InputError(faults);
  if (c.is_pack()) take_first_ring(c);
  return c;
}

Case with_accuracy_of_study(Case c, const Study& study) {
  if (study.compute == Compute::kGas || !study.accuracy.asked) return c;
  const auto takes_it = [](const Case& one) {
    return !one.solver.accuracy && !states_resolution(one) && has_known_accuracy(one);
  };
  if (!c.is_pack()) {
    if (takes_it(c)) c.solver.accuracy = study.accuracy.asked;
  } else if (std::all_of(c.rings.begin(), c.rings.end(), takes_it)) {
    for (Case& ring : c.rings) ring.solver.accuracy = study.accuracy.asked;
  }
  return c;
}

std::vector<std::uint64_t> spread_scenarios(const Plan& plan, std::size_t base) {
  constexpr std::uint64_t kMax = 16;
  const std::uint64_t n = plan.n_points(base), tried = std::min(n, kMax);
  std::vector<std::uint64_t> scenarios;
  for (std::uint64_t k = 0; k < tried; ++k) {
    const std::uint64_t p = tried == 1 ? 0 : k * ((n - 1) / (tried - 1)) + std::min(k, (n - 1) % (tried - 1));
    scenarios.push_back(plan.scenario(base, p));
  }
  return scenarios;
}

namespace {

/// Scenarios with a choice that are tried at most before it is refused.
constexpr std::uint64_t kMaxTriedOfChoice = 256;
/// Scenarios that are looked through for them: all of a usual plan.
constexpr std::uint64_t kMaxLookedAt = 100'000;

/// A step through the plan that meets each scenario once, and early ones everywhere: near the golden section.
std::uint64_t scattering_step(std::uint64_t size) {
  auto step = static_cast<std::uint64_t>(0.618 * static_cast<double>(size));
  while (std::gcd(step, size) != 1) ++step;
  return step;
}

/// What is wrong with a choice of a factor with which no scenario of any base can be run; nothing where one can.
std::optional<Fault> useless_choice(const Plan& plan, std::size_t factor, std::size_t choice) {
  const std::uint64_t size = plan.size(), step = scattering_step(size);
  std::string reason;
  std::uint64_t n_tried = 0;
  for (std::uint64_t k = 0; k < std::min(size, kMaxLookedAt) && n_tried < kMaxTriedOfChoice; ++k) {
    const Point point = plan.point(k * step % size);
    const std::optional<double> number = point.values[factor];
    if (!number || static_cast<std::size_t>(*number) != choice) continue;
    ++n_tried;
    try {
      scenario_case(plan.study(), point);
      return std::nullopt;
    } catch (const InputError& refusal) {
      if (reason.empty()) reason = refusal.faults().front().message;
    }
  }
  if (n_tried < 2) return std::nullopt;  // a single scenario is a row with its reason
  const Factor& of = plan.study().factors[factor];
  const Choice& text = std::get<Choices>(of.variation).values[choice];
  return Fault{text.mark.file.empty() ? of.mark : text.mark,
               called(of) + " = \"" + text.text + "\": no scenario with it can be run, of " + std::to_string(n_tried) +
                   " tried; the first is refused because " + reason,
               "remove this value, or the values of other factors that contradict it"};
}

void check_choices(const Plan& plan) {
  std::vector<Fault> faults;
  for (std::size_t j = 0; j < plan.study().factors.size(); ++j) {
    const auto* choices = std::get_if<Choices>(&plan.study().factors[j].variation);
    for (std::size_t k = 0; choices != nullptr && k < choices->values.size(); ++k) {
      if (std::optional<Fault> fault = useless_choice(plan, j, k)) faults.push_back(std::move(*fault));
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

}  // namespace

void check_scenarios(const Plan& plan) {
  for (std::size_t base = 0; base < plan.study().bases.size(); ++base) {
    const std::vector<std::uint64_t> tried = spread_scenarios(plan, base);
    std::vector<Fault> first;
    for (const std::uint64_t i : tried) {
      try {
        scenario_case(plan.study(), plan.point(i));
        first.clear();
        break;
      } catch (const InputError& refusal) {
        if (first.empty()) first = refusal.faults();
      }
    }
    if (first.empty()) continue;
    first.insert(first.begin(), Fault{{},
                                      "no scenario of base \"" + plan.study().bases[base].name + "\" can be run, of " +
                                          std::to_string(tried.size()) + " tried",
                                      "the first of them is refused because"});
    throw InputError(first);
  }
  check_choices(plan);
}

std::string digest_text(const Case& c) {
  if (c.is_pack()) {
    std::string text;
    for (const Case& ring : c.rings) text.append(" ring\n").append(digest_text(ring));
    return text;
  }
  Case own = c;  // the table of keys hands out references to members that may change
  std::string text;
  for (const Field& field : case_fields()) {
    if (!belongs(field, c)) continue;
    const bool is_oil_file = field.key == kOilFile;
    text.append("  ").append(field.key).append(" = ");
    text.append(is_oil_file ? ValueText::named(c.lubricant.file.has_value()) : std::visit(ValueText{own}, field.kind));
    text.append("\n");
  }
  for (const InputFile& file : c.files)
    text.append("  ").append(file.role).append(" ").append(file.sha256).append("\n");
  return text;
}

}  // namespace ringfilm::study
