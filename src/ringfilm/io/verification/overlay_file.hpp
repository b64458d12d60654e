#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// A measured curve to be laid over a computed one.
struct OverlayCurve {
  std::string name;                     ///< name of the file, without folder and extension
  std::string quantity;                 ///< name from cycle::curve_quantities()
  std::string source;                   ///< the file
  std::vector<double> crank_angle_deg;  ///< [degree], 0 = firing TDC
  std::vector<double> value;            ///< [SI unit of the quantity]
};

/// Reads a CSV with a column `crank_angle [degree]` and columns named and measured like the curves of a result, e.g.
/// `friction_on_liner [N]` or `min_film_thickness [um]`; one curve each, in the order of the file.
/// Throws InputError with every fault of the header: an unknown name, a missing or wrong unit, no curve at all.
std::vector<OverlayCurve> read_overlay(const std::string& path, const Units& units);

}  // namespace ringfilm::io
