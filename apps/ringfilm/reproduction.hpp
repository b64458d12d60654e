#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/run/run.hpp"
#include "text/engineering_text.hpp"

namespace ringfilm::app {

/// Makes the folder of the report unless it is there, and claims the report. Throws InputError.
[[nodiscard]] io::OutputClaim claimed_report(const std::filesystem::path& report);

/// A case with film and pressure along the face kept at crank angles that a report can show. Throws InputError, also
/// where the case cannot be set up.
cycle::Case case_for_report(const std::string& path, const io::Units& units);

/// Integrates all cycles. @returns a document for each. Throws ConvergenceError where one stopped
std::vector<io::ResultDocument> computed(const std::vector<run::Request>& requests, int jobs);

/// A cell of a table for each document: the cycle value of that name with its error.
std::string cells(const std::string& name, const std::vector<io::ResultDocument>& documents,
                  const EngineeringText& in_words);

/// The error of a cycle value, NaN where none was estimated.
double error_of(const io::ResultDocument& document, const std::string& quantity);

}  // namespace ringfilm::app
