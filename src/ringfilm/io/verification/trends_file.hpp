#pragma once
#include <string>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/verification/trends.hpp"

namespace ringfilm::io {

/// The file of the shipped trends, verification/measured_trends/trends.toml. Throws InputError as shipped_folder().
std::string trends_path();

/// A file with the tables [[base]], [[trend]] and [[inexpressible]]. Cases are not read yet.
/// Throws InputError with every fault.
study::TrendList read_trends(const std::string& path, const Units& units);

}  // namespace ringfilm::io
