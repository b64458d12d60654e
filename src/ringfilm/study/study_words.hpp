#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/study/study.hpp"

/// What kinds and methods are called in the file of a study and in its results.
namespace ringfilm::study {

const std::vector<std::pair<std::string, StudyKind>>& kind_words();
const std::vector<std::pair<std::string, Method>>& method_words();

std::string word_of(StudyKind kind);
std::string word_of(Method method);

}  // namespace ringfilm::study
