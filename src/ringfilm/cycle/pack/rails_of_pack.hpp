#pragma once
#include <cstddef>
#include <string>

#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

/// The pack with an oil ring of several rails as one ring for each of them: narrow faces at the distance of the rails,
/// which share the force of the expander and have the drained groove between them. The gas passes their end gap once.
/// Cases without such a ring as they are.
Case with_rails(Case pack);

/// Number of the rail of a ring that with_rails() made, from 1, the one next to the chamber; 0 for other rings.
/// @param ring index in the rings of that pack
std::size_t rail_number(const Case& pack_without_rails, std::size_t ring);

/// Label of that ring for readers: "2", or "3, rail 1".
std::string ring_label(const Case& pack_without_rails, std::size_t ring);

}  // namespace ringfilm::cycle
