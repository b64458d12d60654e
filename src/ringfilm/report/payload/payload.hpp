#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/report/payload/overlay.hpp"

namespace ringfilm::report {

/// The documents, each ring of a pack by itself, and overlays as JSON, SI, for the script of the page. A number that is
/// not finite becomes null; curves keep 7 significant digits and fields 5, which is more than a screen shows, the
/// result file has all. It has no "<", so that a script element may contain it whatever its texts are.
std::string payload(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays);

/// Inputs of a case, files that were read and the program that computed, as all pages have them.
nlohmann::ordered_json inputs_payload(const std::vector<io::CaseEntry>& entries);
nlohmann::ordered_json files_payload(const std::vector<cycle::InputFile>& files);
nlohmann::ordered_json provenance_payload(const io::Provenance& provenance);

}  // namespace ringfilm::report
