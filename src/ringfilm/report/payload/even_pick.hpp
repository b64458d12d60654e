#pragma once
#include <cstdint>
#include <vector>

namespace ringfilm::report {

/// Places of `most` among `n` in order, all of them where there are no more: one of each of `most` equal stretches, at
/// random within it, so that no period of what is picked from hides anything. Equal numbers give equal places.
std::vector<std::uint64_t> evenly_picked(std::uint64_t n, std::uint64_t most);

}  // namespace ringfilm::report
