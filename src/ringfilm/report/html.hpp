#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/report/payload/overlay.hpp"

/// Results as one self-contained web page. Reads documents, computes nothing physical.
namespace ringfilm::report {

/// The page: HTML with its style, script and data inside, no request to anywhere. Cases appear in the order of
/// `documents`. Throws InputError without documents, or where an overlay names no curve quantity or its two columns
/// differ in length.
std::string report_page(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays);

}  // namespace ringfilm::report
