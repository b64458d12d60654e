#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/report/payload/overlay.hpp"

namespace ringfilm::report {

/// The documents, each ring of a pack by itself, and overlays as JSON, SI, for the script of the page. A number that is
/// not finite becomes null; curves keep 7 significant digits and fields 5, which is more than a screen shows, the
/// result file has all. It has no "<", so that a script element may contain it whatever its texts are.
std::string payload(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays);

}  // namespace ringfilm::report
