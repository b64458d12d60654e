#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"

/// Results as one self-contained web page. Reads documents, computes nothing physical.
namespace ringfilm::report {

/// A measured (or otherwise given) trace to lay over the computed curve of the same quantity.
struct Overlay {
  std::string name;                     ///< for the legend, e.g. "floating liner, test 12"
  std::string quantity;                 ///< name from cycle::curve_quantities(), e.g. "friction_on_liner"
  std::string source;                   ///< the file it was read from
  std::vector<double> crank_angle_deg;  ///< [degree], 0 = firing TDC
  std::vector<double> value;            ///< [SI unit of the quantity]
};

/// The page: HTML with its style, script and data inside, no request to anywhere. Cases appear in the order of
/// `documents`. Throws InputError without documents, or where an overlay names no curve quantity or its two columns
/// differ in length.
std::string report_page(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays);

}  // namespace ringfilm::report
