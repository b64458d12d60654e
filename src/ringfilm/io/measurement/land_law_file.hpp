#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/measurement/measurement.hpp"
#include "ringfilm/io/text/source_text.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// Names under which the document of a land holds what a case reads.
inline constexpr const char* kLandLawKind = "land";
inline constexpr const char* kLandLawTable = "land";
inline constexpr const char* kLogLiftDeviation = "log_lift_deviation";

/// The lift of a land.
struct LandLawFile {
  cycle::LandLawTable law;
  std::string sha256;
  std::vector<std::string> notes;
};

/// Standard deviation of ln lift over patches, rms over the rows with lift; NaN without one.
/// @param scatter standard deviation of the lift, a number for each row [Pa], or none
double log_lift_deviation(const std::vector<double>& lift, const std::vector<double>& scatter);

/// Reads what `ringfilm land --output` wrote, or a .csv with the same columns; rows without lift are omitted. Throws
/// InputError: not such a file, altered, fewer than three separations with lift, a lift that does not fall.
LandLawFile read_land_law(const NamedFile& file, const Units& units);

/// Is the document of a land one that read_land_law() takes? Throws InputError with what it would refuse.
void check_land_law(const Measurement& law);

}  // namespace ringfilm::io
