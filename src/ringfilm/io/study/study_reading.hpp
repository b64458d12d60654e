#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/text/units.hpp"
#include "ringfilm/study/design/study.hpp"

namespace ringfilm::io {

/// What the factors of a study read from files.
struct StudyReadings {
  std::vector<study::FileReading> readings;
  std::vector<cycle::InputFile> files;  ///< that were read, with their digests; some of them more than once
};

/// Reads each base anew with every combination that the plan uses of the texts that decide what is read from files, as
/// `run --set` does with these texts. Too many combinations are refused before any is read; of a study whose plan has
/// faults nothing is read, since study::Plan refuses it. A text that cannot be read
/// in any combination is refused; a combination that cannot be read refuses its scenarios.
/// @param study its bases, read from files, its factors and its plan  @param folder folder of the study's file
StudyReadings study_readings(const study::Study& study, const std::string& folder, const Units& units,
                             std::vector<Fault>& faults);

}  // namespace ringfilm::io
