#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/study/design/study.hpp"

/// What kinds and methods are called in the file of a study and in its results.
namespace ringfilm::study {

const std::vector<std::pair<std::string, StudyKind>>& kind_words();
const std::vector<std::pair<std::string, Method>>& method_words();

std::string word_of(StudyKind kind);
std::string word_of(Method method);

/// Values of the column "sample" of a study's rows.
inline constexpr const char* kSampleWords =
    "1 where the scenario is one of a sample, of which means and quantiles may be taken";

}  // namespace ringfilm::study
