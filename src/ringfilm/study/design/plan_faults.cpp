#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::study {
namespace {

using Faults = std::vector<Fault>;

bool is_number(const Variation& variation) { return !std::holds_alternative<Choices>(variation); }

/// Goes through the factors one after the other.
class FactorCheck {
 public:
  FactorCheck(const Study& study, const Factor& factor, Faults& faults)
      : study_(study), factor_(factor), faults_(faults) {}

  void run() {
    if (factor_.name.empty()) refuse("has no name", "give it one, or leave it to be the key");
    if (factor_.targets.empty()) refuse("moves no key", "name a key of the case, for example operating.speed");
    check_variation();
    for (const Target& target : factor_.targets) check_target(target);
  }

 private:
  void refuse(const std::string& predicate, const std::string& remedy) {
    faults_.push_back({factor_.mark, called(factor_) + " " + predicate, remedy});
  }

  void check_variation() {
    if (const auto* d = std::get_if<Distribution>(&factor_.variation)) {
      for (const Complaint& one : complaints(*d)) refuse(one.predicate, one.remedy);
    } else if (const auto* span = std::get_if<Span>(&factor_.variation)) {
      check_span(*span);
    } else if (std::holds_alternative<Listed>(factor_.variation)) {
      if (!is_listed(study_.sampling.method)) {
        refuse("has no values", "state values, a range or a distribution; only a list of scenarios brings its own");
      }
    } else if (n_levels(factor_.variation) == 0) {
      refuse("has no values", "list at least one");
    } else if (const auto* levels = std::get_if<Levels>(&factor_.variation)) {
      check_levels(levels->values);
    } else {
      check_texts(std::get<Choices>(factor_.variation));
    }
  }

  void check_span(const Span& span) {
    if (!std::isfinite(span.low) || !std::isfinite(span.high)) {
      refuse("has a range that is not finite", "state two finite numbers");
    } else if (span.low >= span.high) {
      refuse("has a range from " + number_text(span.low) + " to " + number_text(span.high),
             "the first must be below the second");
    } else if (span.spacing == Spacing::kLogarithmic && span.low <= 0) {
      refuse("has a logarithmic range from " + number_text(span.low), "both ends must be above 0");
    }
    if (span.points < 2)
      refuse("has a range of " + std::to_string(span.points) + " points", "two or more are required");
  }

  void check_levels(std::vector<double> values) {
    if (std::any_of(values.begin(), values.end(), [](double x) { return !std::isfinite(x); })) {
      refuse("has a value that is not finite", "state finite numbers");
      return;
    }
    std::sort(values.begin(), values.end());
    const auto twice = std::adjacent_find(values.begin(), values.end());
    if (twice != values.end()) refuse("has the value " + number_text(*twice) + " twice", "keep one of them");
  }

  void check_texts(const Choices& choices) {
    std::set<std::string> seen;
    for (const Choice& choice : choices.values) {
      if (!seen.insert(choice.text).second) refuse("has \"" + choice.text + "\" twice", "keep one of them");
    }
    if (factor_.how != FactorMode::kSet) refuse("scales or adds to a choice", "a choice can only be set");
  }

  void check_target(const Target& target) {
    if (target.base && *target.base >= study_.bases.size()) {
      refuse("moves a base that does not exist", "name one of the bases of the study");
      return;
    }
    const cycle::Field* field = field_of_key(target.key);
    if (field == nullptr) {
      refuse("names the key " + target.key + ", which does not exist", "`ringfilm fields` lists all keys");
      return;
    }
    for (std::size_t b = 0; b < study_.bases.size(); ++b) {
      if (target.base && *target.base != b) continue;
      if (const auto fault = missing_key(study_.bases[b].input, target.key)) {
        faults_.push_back({factor_.mark, called(factor_) + ": " + fault->message, fault->remedy});
        return;
      }
    }
    if (!std::isfinite(target.gain)) refuse("has a gain that is not finite", "state a finite number");
    if (is_number(factor_.variation)) {
      check_number(target, *field);
    } else {
      check_choices(*field);
    }
    if (field->is_for_record) {
      refuse("varies " + target.key + ", which does not enter the computation: all its scenarios would be alike",
             "remove this factor; the names of bases and factors label the scenarios");
      return;
    }
    check_in_use(target, *field);
  }

  void check_number(const Target& target, const cycle::Field& field) {
    const bool drawn =
        std::holds_alternative<Distribution>(factor_.variation) || std::holds_alternative<Span>(factor_.variation);
    switch (entry_of(field)) {
      case Entry::kNone:
      case Entry::kText:
        refuse("has numbers for " + field.key + ", which is not a number", "list the values of the key as text");
        return;
      case Entry::kWholeNumber:
        if (drawn) refuse("draws " + field.key + ", which is a whole number", "list whole numbers as values");
        break;
      case Entry::kScaleOnly:
        if (factor_.how != FactorMode::kScale) {
          refuse("sets or adds to " + field.key + ", which is a list", "it can be scaled: how = \"scale\"");
          return;
        }
        break;
      case Entry::kAnyNumber:
        break;
    }
    if (factor_.how == FactorMode::kSet) check_range(target, field);
  }

  /// What is set must lie where the key allows; of a distribution its ends, or its median where it has none.
  void check_range(const Target& target, const cycle::Field& field) {
    if (!field.range) return;
    std::vector<double> set;
    cycle::Range range = *field.range;
    if (const auto* levels = std::get_if<Levels>(&factor_.variation)) set = levels->values;
    if (const auto* span = std::get_if<Span>(&factor_.variation)) set = {span->low, span->high};
    if (const auto* d = std::get_if<Distribution>(&factor_.variation)) {
      if (!complaints(*d).empty()) return;
      const bool is_bounded = d->shape == Shape::kUniform || d->shape == Shape::kTriangular;
      set = {quantile(*d, 0.5)};
      if (is_bounded || d->lowest) set.push_back(quantile(*d, 0x1.0p-53));
      if (is_bounded || d->highest) set.push_back(quantile(*d, 1 - 0x1.0p-53));
      range.low_open = range.high_open = false;  // the ends themselves are never drawn
    }
    for (const double number : set) {
      const double x = target.gain * number;
      if (range.contains(x)) continue;
      refuse("has the value " + with_unit(x, field) + " for " + field.key + ", which is out of range",
             "allowed is " + range_words(field));
      return;
    }
  }

  void check_choices(const cycle::Field& field) {
    const auto is_along_stroke = [](const Choice& choice) { return !choice.along_stroke.empty(); };
    if (std::holds_alternative<cycle::StrokeValuesKind>(field.kind) &&
        std::ranges::all_of(std::get<Choices>(factor_.variation).values, is_along_stroke)) {
      return;
    }
    if (entry_of(field) != Entry::kText) {
      refuse("has texts for " + field.key + ", which is a number", "list numbers");
      return;
    }
    const auto* names = std::get_if<cycle::ChoiceKind>(&field.kind);
    if (decides_reading(field) && !is_read()) {
      refuse("varies " + field.key + ", which decides what is read from a file, and no file was read for it",
             "read the study from its own file, or film content Study::readings");
    }
    for (const Choice& choice : std::get<Choices>(factor_.variation).values) {
      if (names && std::find(names->names.begin(), names->names.end(), choice.text) == names->names.end()) {
        std::string all;
        for (const std::string& name : names->names) all.append(all.empty() ? "" : ", ").append(name);
        refuse("has \"" + choice.text + "\", which " + field.key + " does not accept", "choose among " + all);
      }
    }
  }

  bool is_read() const {
    const auto own = static_cast<std::size_t>(&factor_ - study_.factors.data());
    return std::any_of(study_.readings.begin(), study_.readings.end(), [own](const FileReading& reading) {
      return std::find(reading.factors.begin(), reading.factors.end(), own) != reading.factors.end();
    });
  }

  void check_in_use(const Target& target, const cycle::Field& field) {
    // A choice may bring a key into use.
    const bool any_choice = std::any_of(study_.factors.begin(), study_.factors.end(),
                                        [](const Factor& factor) { return !is_number(factor.variation); });
    for (std::size_t b = 0; b < study_.bases.size(); ++b) {
      const Base& base = study_.bases[b];
      if (target.base && *target.base != b) continue;
      cycle::Case own = base.input;
      const std::vector<KeyPlace> places = places_of_key(own, target.key);
      const auto is_idle = [&](const KeyPlace& place) { return !is_active(*place.field, *place.of); };
      if (!belongs(field, base.input)) {
        refuse("moves " + target.key + ", which base \"" + base.name + "\" does not have",
               "it belongs to another kind of problem");
      } else if (study_.compute == Compute::kGas && !field.uses.gas) {
        refuse("moves " + target.key + ", which the gas alone does not use",
               "remove the factor, or compute the films too: leave compute = \"gas\" out");
      } else if (!any_choice && std::all_of(places.begin(), places.end(), is_idle)) {
        refuse("moves " + target.key + ", which is not in use in base \"" + base.name + "\"",
               field.active_when.empty() ? "" : "it is with " + field.active_when);
      } else if (base.input.is_pack() && decides_reading(field)) {
        refuse("varies " + target.key + ", which decides what is read from a file, in a pack",
               "write a base for each file");
      }
    }
  }

  const Study& study_;
  const Factor& factor_;
  Faults& faults_;
};

void check_names(const Study& study, Faults& faults) {
  std::set<std::string> seen;
  for (const Factor& factor : study.factors) {
    if (!seen.insert(factor.name).second) {
      faults.push_back({factor.mark, called(factor) + " is repeated", "give each factor a name of its own"});
    }
  }
  std::set<std::string> bases;
  for (const Base& base : study.bases) {
    if (!bases.insert(base.name).second) {
      faults.push_back({{}, "base \"" + base.name + "\" is repeated", "give each base a name of its own"});
    }
  }
}

/// A file brings all of its table, so that of two chosen for one table only the last would count.
void check_one_file_a_table(const Study& study, Faults& faults) {
  std::map<std::pair<std::size_t, std::string>, std::pair<const Factor*, std::string>> by;
  for (const Factor& factor : study.factors) {
    if (is_number(factor.variation)) continue;
    for (const Target& target : factor.targets) {
      const cycle::Field* field = field_of_key(target.key);
      if (field == nullptr || !is_file(*field)) continue;
      for (std::size_t b = 0; b < study.bases.size(); ++b) {
        if (target.base && *target.base != b) continue;
        const std::string table = target.key.substr(0, target.key.rfind('.'));
        const auto [found, is_first] = by.try_emplace({b, table}, &factor, target.key);
        // check_set_once reports repeated choices of one key
        if (is_first || found->second.second == target.key) continue;
        faults.push_back({factor.mark,
                          called(factor) + " chooses files for " + target.key + ", as " + called(*found->second.first) +
                              " does for " + found->second.second,
                          "both bring all of [" + table + "]; make it two studies"});
        return;
      }
    }
  }
}

/// Two factors that set one key would leave the first without effect.
void check_set_once(const Study& study, Faults& faults) {
  std::map<std::pair<std::size_t, std::string>, std::string> by;
  for (const Factor& factor : study.factors) {
    if (factor.how != FactorMode::kSet) continue;
    for (const Target& target : factor.targets) {
      bool reported = false;
      for (std::size_t b = 0; b < study.bases.size(); ++b) {
        if (target.base && *target.base != b) continue;
        const auto [found, is_first] = by.try_emplace({b, target.key}, factor.name);
        if (is_first || reported) continue;
        reported = true;
        faults.push_back({factor.mark,
                          called(factor) + " sets " + target.key + ", as factor \"" + found->second + "\" does",
                          "leave one out, or let it scale or add"});
      }
    }
  }
}

void check_correlation(const Study& study, const Correlation& one, Faults& faults) {
  const auto& a = study.factors[one.first];
  const auto& b = study.factors[one.second];
  const std::string pair = "the correlation of " + called(a) + " and " + called(b);
  if (one.first == one.second) {
    faults.push_back({one.mark, called(a) + " is correlated with itself", "name two factors"});
  } else if (!(std::abs(one.value) < 1)) {
    faults.push_back({one.mark, pair + " is " + number_text(one.value),
                      "it must be above -1 and below 1; a factor that follows from another is not a separate factor"});
  }
  for (const Factor* factor : {&a, &b}) {
    if (std::holds_alternative<Distribution>(factor->variation) || std::holds_alternative<Span>(factor->variation))
      continue;
    faults.push_back({one.mark, called(*factor) + " is correlated, but has no distribution and no range",
                      "listed values cannot be correlated"});
  }
}

void check_correlations(const Study& study, Faults& faults) {
  const std::size_t before = faults.size();
  std::set<std::pair<std::size_t, std::size_t>> seen;
  for (const Correlation& one : study.correlations) {
    if (one.first >= study.factors.size() || one.second >= study.factors.size()) {
      faults.push_back({one.mark, "a correlation names a factor that does not exist", "name two factors of the study"});
      continue;
    }
    check_correlation(study, one, faults);
    if (!seen.insert(std::minmax(one.first, one.second)).second) {
      faults.push_back({one.mark,
                        "the correlation of " + called(study.factors[one.first]) + " and " +
                            called(study.factors[one.second]) + " is repeated",
                        "keep one of them"});
    }
  }
  if (study.correlations.empty() || faults.size() > before) return;
  const Method method = study.sampling.method;
  if (method == Method::kGrid || method == Method::kList || method == Method::kMorris) {
    faults.push_back({study.correlations.front().mark,
                      "correlations have no place on a grid, in a list or in a plan of Morris",
                      "leave them out, or sample: method = \"sobol\""});
    return;
  }
  for (const FactorGroup& group : factor_groups(study)) {
    const Triangle found = triangle(group.factors.size(), correlation_matrix(study, group));
    if (!found.failed_row) continue;
    const Factor& factor = study.factors[group.factors[*found.failed_row]];
    faults.push_back({factor.mark,
                      "the correlations of " + group.name +
                          " cannot hold at once: their matrix is not positive definite, as " + called(factor) +
                          " shows",
                      "check the signs, and state every correlation of these factors: what is not stated is 0"});
  }
}

/// Points of a grid, to a rounding that does not matter.
double grid_points(const Study& study) {
  double most = 0;
  for (std::size_t b = 0; b < study.bases.size(); ++b) {
    double n = 1;
    for (const Factor& factor : study.factors) {
      if (applies(factor, b)) n *= static_cast<double>(n_levels(factor.variation));
    }
    most += n;
  }
  return most;
}

void check_until(const Study& study, Faults& faults) {
  const Sampling& sampling = study.sampling;
  if (!sampling.until) return;
  const StoppingRule& until = *sampling.until;
  const auto refuse = [&](const std::string& message, const std::string& remedy) {
    faults.push_back({until.mark, message, remedy});
  };
  if (sampling.method != Method::kSobol) {
    refuse("plan.until: this plan cannot be extended", "only Sobol points can: method = \"sobol\"");
  }
  if (!study_values(study, study.bases.front().input).index(until.value)) {
    refuse("plan.until: there is no value " + until.value, "for example fmep");
  }
  if (!(until.width > 0)) refuse("plan.until: the width is " + number_text(until.width), "it must be above 0");
  if (until.quantile && !(*until.quantile > 0 && *until.quantile < 1)) {
    refuse("plan.until: the quantile is " + number_text(*until.quantile), "it lies between 0 and 1, for example 0.95");
  }
  if (until.most < sampling.scenarios) {
    refuse("plan.until: most = " + std::to_string(until.most) + " is below plan.scenarios", "state more");
  }
}

void check_list(const Study& study, Faults& faults) {
  const auto& list = study.sampling.list;
  if (list.empty()) faults.push_back({{}, "the list of scenarios is empty", "give one line for each scenario"});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const std::string line = "scenario " + std::to_string(i + 1) + " of the list ";
    if (list[i].size() != study.factors.size()) {
      faults.push_back({{},
                        line + "has " + std::to_string(list[i].size()) + " values",
                        "one is required for each of " + std::to_string(study.factors.size()) + " factors"});
      return;
    }
    for (std::size_t j = 0; j < list[i].size(); ++j) {
      const Factor& factor = study.factors[j];
      const auto n = static_cast<double>(n_levels(factor.variation));
      const double x = list[i][j];
      const bool good = is_number(factor.variation) ? std::isfinite(x) : x >= 0 && x < n && x == std::floor(x);
      if (!good) faults.push_back({factor.mark, line + "has no value of " + called(factor), "state one"});
    }
  }
}

/// Pictures of a kind that the plan cannot give would be missing without a word.
void check_kind(const Study& study, Faults& faults) {
  const Method method = study.sampling.method;
  if (study.kind == StudyKind::kMap && method != Method::kGrid) {
    faults.push_back({{}, "kind = \"map\" without a grid", "a map is drawn over method = \"grid\""});
  }
  if (study.kind == StudyKind::kScreening && method != Method::kMorris && method != Method::kOneAtATime) {
    faults.push_back(
        {{}, "kind = \"screening\" without trajectories", "write method = \"morris\", or \"one-at-a-time\""});
  }
}

void check_sampling(const Study& study, Faults& faults) {
  check_kind(study, faults);
  const Sampling& sampling = study.sampling;
  const auto refuse = [&faults](const std::string& message, const std::string& remedy) {
    faults.push_back({{}, message, remedy});
  };
  constexpr double kMax = static_cast<double>(SobolPoints::kMaxPoints);
  const bool is_sample = sampling.method == Method::kLatinHypercube || sampling.method == Method::kSobol;
  if (is_sample && (sampling.scenarios == 0 || static_cast<double>(sampling.scenarios) > kMax)) {
    refuse("plan.scenarios = " + std::to_string(sampling.scenarios), "at least 1 and at most 2^32 are required");
  }
  if (sampling.until && static_cast<double>(sampling.until->most) > kMax) {
    refuse("plan.until: most = " + std::to_string(sampling.until->most), "at most 2^32 points can be distinguished");
  }
  if (sampling.indices != Indices::kNone && sampling.method != Method::kSobol) {
    refuse("plan.indices require Sobol points", "method = \"sobol\"");
  }
  const std::size_t n_sets = sampling.indices == Indices::kNone ? 1 : 2;
  if (sampling.method == Method::kSobol && n_sets * study.factors.size() > SobolPoints::kMaxDimensions) {
    refuse(std::to_string(study.factors.size()) + " factors are more than there are direction numbers for",
           "at most " + std::to_string(SobolPoints::kMaxDimensions / n_sets) + ", or a Latin hypercube");
  }
  if (sampling.method == Method::kGrid) {
    for (const Factor& factor : study.factors) {
      if (!std::holds_alternative<Distribution>(factor.variation)) continue;
      faults.push_back({factor.mark, called(factor) + " has a distribution, which a grid cannot lay out",
                        "state values or a range, or sample: method = \"sobol\""});
    }
    if (grid_points(study) > kMax) {
      refuse("the grid has " + number_text(grid_points(study)) + " points", "at most 2^32 can be distinguished");
    }
  }
  if (sampling.method == Method::kMorris) {
    if (sampling.levels < 2 || sampling.levels % 2 != 0 || sampling.levels > 1000) {
      refuse("plan.levels = " + std::to_string(sampling.levels), "an even number from 2 to 1000 is required");
    }
    if (sampling.trajectories < 2 || static_cast<double>(sampling.trajectories) > 1e6) {
      refuse("plan.trajectories = " + std::to_string(sampling.trajectories), "2 to 10^6 are required");
    }
  }
  if (is_listed(sampling.method)) check_list(study, faults);
  check_until(study, faults);
}

}  // namespace

std::vector<Fault> faults_of(const Study& study) {
  Faults faults;
  if (study.bases.empty()) faults.push_back({{}, "the study has no base case", "name one in [[base]]"});
  if (study.factors.empty() && study.sampling.method != Method::kGrid && study.sampling.method != Method::kOneAtATime) {
    faults.push_back({{}, "the study has no factor", "state what varies in [[factor]]"});
  }
  check_names(study, faults);
  for (const Factor& factor : study.factors) FactorCheck(study, factor, faults).run();
  check_set_once(study, faults);
  check_one_file_a_table(study, faults);
  check_correlations(study, faults);
  check_sampling(study, faults);
  const Faults of_keep = faults_of_keep(study);
  faults.insert(faults.end(), of_keep.begin(), of_keep.end());
  return faults;
}

}  // namespace ringfilm::study
