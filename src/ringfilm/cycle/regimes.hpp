#pragma once
#include <string_view>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Regimes of lubrication by the share of the load that asperities carry, eq-regime-shares, whatever the contact law.
namespace ringfilm::cycle {

inline constexpr double kBoundaryAbove = 0.9;   ///< load share above which lubrication is boundary, a convention [-]
inline constexpr double kFullFilmBelow = 0.01;  ///< load share below which the film is full, a convention [-]

enum class Regime { kBoundary, kMixed, kFullFilm };

/// "boundary", "mixed" or "full film"
std::string_view regime_name(Regime regime);

/// Sets the nine shares of the regimes in a cycle. @param samples of the cycle, in the order of their crank angles
void put_regime_shares(const std::vector<Sample>& samples, CycleValues& values);

/// The regime in which a ring spends most of its friction energy, eq-predominant-regime. Never kFullFilm where boundary
/// friction takes more than half of the friction power.
Regime predominant_regime(const CycleValues& values);

}  // namespace ringfilm::cycle
