#pragma once
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

/// Notes on numbers of the contact that no pair of ring and liner has (docs/theory/contact.md).
void append_contact_notes(const Case& c, std::vector<Note>& notes);

}  // namespace ringfilm::cycle
