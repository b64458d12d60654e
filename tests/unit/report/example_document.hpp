#pragma once
#include <string>

#include "ringfilm/io/result_file.hpp"

/// A result that no solver made: simple formulas with the shape of an engine cycle, every part of a document filled.
namespace example {

/// @param friction scales boundary friction, so that several cases differ
ringfilm::io::ResultDocument document(const std::string& title, double friction = 1.0);

}  // namespace example
