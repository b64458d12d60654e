#pragma once
#include <string>

#include "ringfilm/io/result/result_file.hpp"

/// A result that no solver made: simple formulas with the shape of an engine cycle, every part of a document filled.
namespace example {

/// @param friction scales boundary friction, so that several cases differ
ringfilm::io::ResultDocument document(const std::string& title, double friction = 1.0);

enum class CircumferentialGrid { kFields, kStripsOnly };

/// Gives the document an unrolled film with a gap of 0.3 mm: thinner pressure towards the ends, a cavity that ends
/// before them. 24 angles in full or 240 of strips.
void add_unrolled_film(ringfilm::io::ResultDocument& document, CircumferentialGrid expected);

}  // namespace example
