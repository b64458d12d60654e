#pragma once
#include <string>

#include "ringfilm/io/life/life_output.hpp"

namespace ringfilm::report {

/// A life as one self-contained web page: values over the running time with their bands, the face as it wears, what
/// each part of the ring changes, how each number is known, and what to measure next.
std::string life_page(const io::LifeDocument& document);

}  // namespace ringfilm::report
