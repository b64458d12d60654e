#include "ringfilm/io/result/result_document.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "ringfilm/base/append_new.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {
namespace {

std::string ring_title(const std::string& pack, std::size_t number, const ResultDocument& ring) {
  std::string title = pack + ": ring " + std::to_string(number);
  for (const CaseEntry& entry : ring.inputs) {
    if (entry.key == "ring.name" && !entry.shown.empty()) title += " (" + entry.shown + ")";
  }
  return title;
}

std::vector<std::size_t> numbers_of(const std::vector<ResultDocument>& rings) {
  std::vector<std::size_t> numbers;
  for (const ResultDocument& ring : rings) {
    const std::size_t before = numbers.empty() ? 0 : numbers.back();
    numbers.push_back(ring.rail > 1 ? before : before + 1);
  }
  return numbers;
}

}  // namespace

std::vector<std::size_t> ring_numbers(const ResultDocument& pack) { return numbers_of(pack.rings); }

ResultDocument result_document(const cycle::Case& c, cycle::CycleResult result) {
  ResultDocument document;
  document.title = c.title;
  document.inputs = case_entries(c);
  document.resolved_case = case_text(document.inputs);
  document.files = c.files;
  document.input_notes = c.notes;
  document.provenance = this_run();
  document.result = std::move(result);
  document.contact = cycle::contact_curves(c);
  return document;
}

ResultDocument pack_document(const std::string& title, std::vector<ResultDocument> rings) {
  ResultDocument pack;
  pack.title = title;
  pack.provenance = rings.front().provenance;
  const std::vector<std::size_t> numbers = numbers_of(rings);
  std::vector<std::vector<CaseEntry>> inputs;
  for (const ResultDocument& ring : rings) inputs.push_back(ring.inputs);
  pack.inputs = pack_entries(inputs);
  pack.resolved_case = case_text(pack.inputs);
  pack.ledger_computed = std::any_of(rings.begin(), rings.end(), [](const auto& ring) { return ring.ledger_computed; });
  for (std::size_t i = 0; i < rings.size(); ++i) {
    ResultDocument& ring = rings[i];
    ring.title = ring_title(title, numbers[i], ring);
    append_new(pack.files, ring.files, [](const auto& a, const auto& b) { return a.path == b.path; });
    append_new(pack.input_notes, ring.input_notes, std::equal_to());
    pack.result.complete = pack.result.complete && ring.result.complete;
    cycle::add_ring(ring.result.values, pack.result.values);
  }
  pack.rings = std::move(rings);
  return pack;
}

std::span<const ResultDocument> rings_of(const ResultDocument& document) {
  return document.is_pack() ? std::span(document.rings) : std::span(&document, 1);
}

}  // namespace ringfilm::io
