#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/cycle/advice/note_topics.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_study.hpp"
#include "ringfilm/report/payload/unsolved_reasons.hpp"
#include "ringfilm/study/statistics/one_at_a_time.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"
#include "ringfilm/study/study_words.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

/// Listed values that are reported in words, reasons that are reported.
constexpr std::size_t kListedValues = 12, kListedReasons = 12;
/// Scenarios whose reasons are held in memory at once.
constexpr std::uint64_t kBlock = 4096;

/// How a factor varies, in words and in the units that people read.
class VariationText {
 public:
  VariationText(const study::Factor& factor, const io::Units& units) : factor_(factor), units_(units) {}

  std::string operator()(const study::Levels& levels) const {
    std::string words;
    for (std::size_t i = 0; i < std::min(levels.values.size(), kListedValues); ++i)
      words.append(i == 0 ? "" : ", ").append(value(levels.values[i]));
    return cut(words, levels.values.size());
  }
  std::string operator()(const study::Choices& choices) const {
    std::string words;
    for (std::size_t i = 0; i < std::min(choices.values.size(), kListedValues); ++i)
      words.append(i == 0 ? "" : ", ").append(choices.values[i].text);
    return cut(words, choices.values.size());
  }
  std::string operator()(const study::Span& span) const {
    const bool is_logarithmic = span.spacing == study::Spacing::kLogarithmic;
    return fmt::format("{} to {}{}", value(span.low), value(span.high),
                       is_logarithmic ? ", even in the logarithm" : "");
  }
  std::string operator()(const study::Listed&) const { return "as listed"; }
  std::string operator()(const study::Distribution& d) const {
    std::string words;
    switch (d.shape) {
      case study::Shape::kNormal:
        words = fmt::format("normal, mean {}, deviation {}", value(d.mean), difference(d.deviation));
        break;
      case study::Shape::kLognormal:
        words =
            fmt::format("lognormal, median {}, deviation of the logarithm {:.4g}", value(d.median), d.log_deviation);
        break;
      case study::Shape::kUniform:
        words = fmt::format("uniform, {} to {}", value(d.lower), value(d.upper));
        break;
      case study::Shape::kTriangular:
        words = fmt::format("triangular, {} to {}, most likely {}", value(d.lower), value(d.upper), value(d.mode));
        break;
    }
    if (d.lowest && d.highest)
      return fmt::format("{}; cut off at {} and {}", words, value(*d.lowest), value(*d.highest));
    if (d.lowest) return fmt::format("{}; cut off below {}", words, value(*d.lowest));
    if (d.highest) return fmt::format("{}; cut off above {}", words, value(*d.highest));
    return words;
  }

 private:
  std::string value(double x) const { return units_.shown(x, factor_.unit, factor_.display_unit, 5); }
  /// A difference of temperatures is one in kelvin.
  std::string difference(double x) const {
    return units_.shown(x, factor_.unit, factor_.unit == "K" ? "K" : factor_.display_unit, 5);
  }
  static std::string cut(const std::string& words, std::size_t n) {
    return n > kListedValues ? fmt::format("{}, ... ({} values)", words, n) : words;
  }

  const study::Factor& factor_;
  const io::Units& units_;
};

const char* how_word(study::FactorMode how) {
  switch (how) {
    case study::FactorMode::kSet:
      return "set";
    case study::FactorMode::kScale:
      return "scale";
    case study::FactorMode::kAdd:
      return "add";
  }
  return "";
}

ordered_json factor_object(const study::Study& study, const study::Factor& factor, const io::Units& units) {
  ordered_json keys = ordered_json::array(), bases = ordered_json::array(), choices = ordered_json::array();
  for (const study::Target& target : factor.targets) {
    if (std::find(keys.begin(), keys.end(), target.key) == keys.end()) keys.push_back(target.key);
  }
  for (std::size_t b = 0; b < study.bases.size(); ++b) {
    if (study::applies(factor, b)) bases.push_back(b);
  }
  if (const auto* listed = std::get_if<study::Choices>(&factor.variation)) {
    for (const study::Choice& choice : listed->values) choices.push_back(choice.text);
  }
  // Factors that [[measured]] adds are in no line of the study's file.
  const bool is_measured = factor.mark.line == 0;
  return {{"name", factor.name},
          {"keys", std::move(keys)},
          {"bases", std::move(bases)},
          {"how", how_word(factor.how)},
          {"unit", factor.unit},
          {"display_unit", factor.display_unit},
          {"words", std::visit(VariationText(factor, units), factor.variation)},
          {"choices", std::move(choices)},
          {"listed", study::sensitivity_ends(factor.variation) == study::SensitivityEnds::kValues},
          {"logarithmic", std::holds_alternative<study::Span>(factor.variation) &&
                              std::get<study::Span>(factor.variation).spacing == study::Spacing::kLogarithmic},
          {"origin", is_measured ? "measured" : "stated"},
          {"source", factor.source}};
}

ordered_json unsolved_object(const io::StudyRows& rows) {
  UnsolvedReasons reasons;
  for (std::uint64_t first = 0; first < rows.plan.size(); first += kBlock) {
    for (const auto& one : rows.unsolved({first, std::min(first + kBlock, rows.plan.size())}))
      reasons.add(one.scenario, one.reason);
  }
  ordered_json reported = ordered_json::array();
  const std::vector<UnsolvedReasons::Reason> ordered = reasons.most_frequent_first();
  for (std::size_t i = 0; i < std::min(ordered.size(), kListedReasons); ++i) {
    reported.push_back({{"reason", ordered[i].text},
                        {"count", ordered[i].count},
                        {"first", ordered[i].first},
                        {"numbers_differ", ordered[i].numbers_differ}});
  }
  return {{"count", reasons.count()}, {"n_reasons", ordered.size()}, {"reasons", std::move(reported)}};
}

ordered_json scenario_notes_object(const io::StudyRows& rows) {
  ordered_json reported = ordered_json::array();
  for (const auto& note : rows.scenario_notes()) {
    ordered_json counts = ordered_json::array();
    for (const auto& base : note.bases) counts.push_back(base.count);
    const cycle::NoteTopic* entry = cycle::note_topic(note.topic);
    reported.push_back({{"topic", note.topic},
                        {"serious", entry != nullptr && entry->trust == cycle::Trust::kNone},
                        {"message", note.shown().message},
                        {"scenario", note.shown().scenario},
                        {"is_worst", note.shown().badness.has_value()},
                        {"count", note.count()},
                        {"counts", std::move(counts)}});
  }
  return reported;
}

/// null where no error was estimated.
ordered_json error_object(const io::StudyRows& rows) {
  if (!rows.error) return nullptr;
  const study::SampledError& error = *rows.error;
  constexpr int kDigits = 3;
  const auto& quantities = rows.plan.values().quantities;
  ordered_json quantiles = ordered_json::object();
  for (std::size_t i = 0; i < quantities.size(); ++i) {
    if (error.quantiles[i]) quantiles[quantities[i].name] = rounded(*error.quantiles[i], kDigits);
  }
  const auto coverage = error.coverage();
  return {{"count", error.scenarios.size()},
          {"unsolved", error.n_unsolved},
          {"asked", exact_list(error.asked)},
          {"values", error.n_values},
          {"coverage", coverage ? rounded(*coverage, kDigits + 1) : ordered_json(nullptr)},
          {"quantiles", std::move(quantiles)}};
}

}  // namespace

ordered_json study_head(const io::StudyRows& rows, const io::Units& units, const io::Provenance& provenance) {
  const study::Study& study = rows.plan.study();
  ordered_json bases = ordered_json::array(), factors = ordered_json::array(), correlations = ordered_json::array(),
               groups = ordered_json::array(), quantities = described_all(rows.plan.values().quantities);
  for (std::size_t b = 0; b < study.bases.size(); ++b) {
    bases.push_back(
        {{"name", study.bases[b].name}, {"title", study.bases[b].input.title}, {"points", rows.plan.n_points(b)}});
  }
  for (const study::Factor& factor : study.factors) factors.push_back(factor_object(study, factor, units));
  for (const study::Correlation& one : study.correlations)
    correlations.push_back({{"factors", {one.first, one.second}}, {"value", exact(one.value)}});
  for (const study::FactorGroup& group : rows.plan.groups()) groups.push_back(group.name);
  return {{"title", study.title},
          {"kind", study::word_of(study.kind)},
          {"method", study::word_of(study.sampling.method)},
          {"seed", study.seed},
          {"scenarios", rows.plan.size()},
          {"points_per_row", rows.plan.points_per_row()},
          {"has_sample", study::has_sample(rows.plan)},
          {"has_indices", study.sampling.indices != study::Indices::kNone},
          {"unsolved", unsolved_object(rows)},
          {"notes", rows.notes()},
          {"scenario_notes", scenario_notes_object(rows)},
          {"error", error_object(rows)},
          {"usual_accuracy", *study::Accuracy{}.asked / 100},
          {"bases", std::move(bases)},
          {"factors", std::move(factors)},
          {"correlations", std::move(correlations)},
          {"groups", std::move(groups)},
          {"quantities", std::move(quantities)},
          {"main_values", rows.plan.values().main},
          {"files", io::record_array(rows.file.files)},
          {"provenance", io::record_object(provenance)}};
}

}  // namespace ringfilm::report
