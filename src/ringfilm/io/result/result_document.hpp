#pragma once
#include <string>
#include <vector>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// All that a result file holds of one integration by this program: the case key by key, what it was read from, what
/// computed it, and the result. Ledger, comparison and error estimate remain empty.
ResultDocument result_document(const cycle::Case& c, cycle::CycleResult result);

/// The result of a ring pack from those of its rings, whose titles become "TITLE: ring 1 (NAME)" unless they have names
/// in a pack already. @param title of the pack
ResultDocument pack_document(const std::string& title, std::vector<ResultDocument> rings);

/// Each ring by itself, with the result files of single rings as they are.
std::vector<ResultDocument> single_rings(const std::vector<ResultDocument>& documents);

}  // namespace ringfilm::io
