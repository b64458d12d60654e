#pragma once

namespace ringfilm::cycle {

/// Nodes of a film in two dimensions at the most: its solver needs about a kilobyte for each.
inline constexpr double kMaxFilm2dNodes = 2e6;

}  // namespace ringfilm::cycle
