#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/case/case.hpp"

namespace ringfilm::study {

/// Shares cases out among threads such that like cases come together, to fill the lanes of a register, and all threads
/// end at about the same time. @param width lanes of a register
/// @returns for each thread that has something to do the indices of its cases, those that take longest first; no more
/// than `n_threads`
std::vector<std::vector<std::size_t>> shares(const std::vector<cycle::Case>& cases, int n_threads, int width);

}  // namespace ringfilm::study
