#include "ringfilm/report/verification_page.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

const char* verdict_word(study::Verdict verdict) { return verdict == study::Verdict::kHolds ? "holds" : "fails"; }

ordered_json row_object(const study::VerificationRow& row) {
  const bool relative = row.tolerance.kind == study::Tolerance::Kind::kRelative;
  return {{"label", row.label},
          {"quantity", row.quantity},
          {"unit", row.unit},
          {"display_unit", row.display_unit},
          {"expected", exact(row.expected)},
          {"got", exact(row.got)},
          {"error", exact(row.error)},
          {"tolerance", row.tolerance.value},
          {"tolerance_kind", relative ? "relative" : "absolute"},
          {"verdict", verdict_word(row.verdict)},
          {"source", row.source},
          {"because", row.because}};
}

ordered_json line_object(const study::ConvergenceLine& line) {
  return {{"label", line.label},
          {"refinement", line.refinement == study::Refinement::kCells ? "cells" : "time"},
          {"step_unit", line.step_unit},
          {"levels", exact_list(line.levels)},
          {"errors", exact_list(line.errors)},
          {"expected_order", line.expected_order},
          {"observed_order", line.observed_order ? exact(*line.observed_order) : ordered_json(nullptr)},
          {"bound", line.bound ? exact(*line.bound) : ordered_json(nullptr)}};
}

ordered_json case_object(const study::VerificationOutcome& outcome) {
  ordered_json rows = ordered_json::array(), lines = ordered_json::array();
  for (const auto& row : outcome.rows) rows.push_back(row_object(row));
  for (const auto& line : outcome.lines) lines.push_back(line_object(line));
  return {{"name", outcome.name},     {"title", outcome.title},
          {"claim", outcome.claim},   {"verdict", verdict_word(outcome.verdict())},
          {"stops", outcome.stops},   {"rows", std::move(rows)},
          {"lines", std::move(lines)}};
}

ordered_json result_object(const VerificationResult& result) {
  ordered_json cases = ordered_json::array(), not_covered = ordered_json::array();
  for (const auto& outcome : result.cases) cases.push_back(case_object(outcome));
  for (const auto& [what, reason] : result.not_covered) not_covered.push_back({{"what", what}, {"reason", reason}});
  return {{"cases", std::move(cases)},
          {"not_covered", std::move(not_covered)},
          {"program", result.provenance.program},
          {"commit", result.provenance.commit}};
}

}  // namespace

std::string verification_json(const VerificationResult& result) {
  return result_object(result).dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string verification_page(const VerificationResult& result) {
  const page_template::PageTemplate parts = page_template::verification();
  std::string page(parts.before_title);
  page += "Verification of ringfilm";
  page += parts.before_data;
  page += script_text(result_object(result).dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
