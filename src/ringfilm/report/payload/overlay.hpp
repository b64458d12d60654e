#pragma once
#include <string>
#include <vector>

namespace ringfilm::report {

/// A measured (or otherwise given) trace to lay over the computed curve of the same quantity.
struct Overlay {
  std::string name;                     ///< for the legend, e.g. "floating liner, test 12"
  std::string quantity;                 ///< name from cycle::curve_quantities(), e.g. "friction_on_liner"
  std::string source;                   ///< the file it was read from
  std::vector<double> crank_angle_deg;  ///< [degree], 0 = firing TDC
  std::vector<double> value;            ///< [SI unit of the quantity]
};

}  // namespace ringfilm::report
