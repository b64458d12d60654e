#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::io {

/// Names under which the document of a contact law holds what a case reads.
inline constexpr const char* kContactLawKind = "contact";
inline constexpr const char* kContactLawTable = "law";
inline constexpr const char* kLastSupportedSeparation = "last_supported_separation";
inline constexpr const char* kShiftDeviation = "shift_deviation";
inline constexpr const char* kLogPressureDeviation = "log_pressure_deviation";
inline constexpr const char* kShiftPressureCorrelation = "shift_pressure_correlation";
inline constexpr const char* kGapDistribution = "gap_distribution";
/// Name of the shares of the gap at one row of the table.
std::string gap_series(std::size_t row);

/// The contact law of a measured pair.
struct ContactLawFile {
  cycle::ContactLawTable law;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Reads what `ringfilm contact --output` wrote; rows without contact are omitted. Throws InputError: not such a file,
/// altered, fewer than four separations with contact, pressures or areas that do not fall.
ContactLawFile read_contact_law(const NamedFile& file);

/// Is the document of a contact law one that read_contact_law() takes? Throws InputError with what it would refuse.
void check_contact_law(const Measurement& law);

}  // namespace ringfilm::io
