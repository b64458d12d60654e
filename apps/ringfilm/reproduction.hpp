#pragma once
#include <filesystem>
#include <string>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {

/// Makes the folder of results unless it is there. Throws InputError.
void make_folder(const std::filesystem::path& folder);

/// A case with film and pressure along the face kept at crank angles that a report can show. Throws InputError, also
/// where the case cannot be set up.
cycle::Case case_for_report(const std::string& path, const io::Units& units);

/// The error of a cycle value, NaN where none was estimated.
double error_of(const io::ResultDocument& document, const std::string& quantity);

}  // namespace ringfilm::app
