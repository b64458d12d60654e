#include "ringfilm/io/result/result_document.hpp"

#include <utility>

#include "ringfilm/io/case/case_file.hpp"

namespace ringfilm::io {

ResultDocument result_document(const cycle::Case& c, cycle::CycleResult result) {
  ResultDocument document;
  document.title = c.title;
  document.inputs = case_entries(c);
  document.resolved_case = resolved_case(c);
  document.files = c.files;
  document.input_notes = c.notes;
  document.provenance = this_run();
  document.result = std::move(result);
  return document;
}

}  // namespace ringfilm::io
