#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/comparison.hpp"

namespace ringfilm::io {

/// Reads published values of a case: the tables [[published]] of a TOML file with case = "<name>", each with
/// source, quantity (name of a cycle value), statement, value (with its unit where it has one) and decided_by.
/// Throws InputError with every fault of the file.
std::vector<study::PublishedValue> read_published(const std::string& path, const std::string& case_name,
                                                  const Units& units);

}  // namespace ringfilm::io
