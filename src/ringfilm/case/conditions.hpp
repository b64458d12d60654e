#pragma once
#include <string_view>
#include <vector>

#include "ringfilm/base/display.hpp"
#include "ringfilm/case/case.hpp"

namespace ringfilm::cycle {

/// Linear between the points, constant beyond them. @param points one at least
double along_stroke(const std::vector<StrokeValue>& points, double distance);

/// Do the conditions have gas at the edges, oil on the liner and walls of an engine?
bool is_engine(Conditions conditions);

/// Starts a case from the edges, the supply and the temperatures of `conditions`; what it states replaces them.
void set_conditions(Conditions conditions, Case& c);

/// The conditions that the case has now, in place of what it states of edges, supply and walls.
void replace_conditions(Case& c);

/// A case that states one oil temperature has no other walls than those that it states, too.
void keep_own_temperature(Case& c);

/// Do these conditions replace a key that files state, where the command line or a study asks for them?
bool is_replaced_by(Conditions conditions, std::string_view key);

/// Smallest and largest film that the packs of data/packs leave for their first ring at 1000 to 4000 rpm [m].
struct FilmBand {
  double low, high;
};
inline constexpr FilmBand kOilRingFilms{kMicrometre.scale.to_si(0.4), kMicrometre.scale.to_si(0.8)};

}  // namespace ringfilm::cycle
