#pragma once
#include <string>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::report {

/// A study as one self-contained web page: what varied and how, statistics of the cycle values, and the pictures of its
/// kind. Statistics are those of all scenarios; pictures of single points show an even subset of large studies, which
/// their captions state. Takes memory for a few columns of the study's table.
std::string study_page(const io::StudyRows& rows, const io::Units& units, const io::Provenance& provenance);

}  // namespace ringfilm::report
