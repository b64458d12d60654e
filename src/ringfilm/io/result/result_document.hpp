#pragma once
#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// All that a result file holds of one integration by this program: the case key by key, what it was read from, what
/// computed it, and the result. Ledger, comparison and error estimate remain empty.
ResultDocument result_document(const cycle::Case& c, cycle::CycleResult result);

}  // namespace ringfilm::io
