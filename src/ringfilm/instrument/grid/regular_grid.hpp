#pragma once
#include <string>
#include <vector>

#include "ringfilm/instrument/grid/channel.hpp"

namespace ringfilm::instrument {

/// Single points in any order, as a file lists them.
struct ListedPoints {
  std::vector<double> x, y;
  std::vector<double> value;  ///< NaN where nothing was measured
};

/// Puts listed points on the even grid that they lie on: row 0 at the smallest y. Places of the grid that no point
/// claims are missing. The name and the units are left to the caller. Throws InputError, which names the point counted
/// from 1, if a point lies off the grid by more than 2 % of a step and more than the last digit of the places, if two
/// share a place or if nine of ten places would be empty. @param file name for messages
ChannelValues on_regular_grid(const std::string& file, const ListedPoints& points);

/// Do the places x and y, whatever their values, fill an even grid without a hole or a second point?
bool fills_grid(const ListedPoints& points);

/// The step of places that rise evenly, to 2 % of a step or to their last digit; 0 if they do not.
double even_step(const std::vector<double>& places);

}  // namespace ringfilm::instrument
