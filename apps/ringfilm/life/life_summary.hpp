#pragma once
#include <string>

#include "ringfilm/io/life/life_output.hpp"

namespace ringfilm::app {

/// The table that `ringfilm life` prints: a row for each running time, how it is known, and what to consider.
std::string life_summary(const io::LifeDocument& document);

}  // namespace ringfilm::app
