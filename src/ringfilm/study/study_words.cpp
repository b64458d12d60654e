#include "ringfilm/study/study_words.hpp"

#include <stdexcept>

namespace ringfilm::study {
namespace {

template <class Choice>
std::string word_among(const std::vector<std::pair<std::string, Choice>>& words, Choice requested) {
  for (const auto& [word, choice] : words) {
    if (choice == requested) return word;
  }
  throw std::logic_error("a choice of a study without a word");
}

}  // namespace

const std::vector<std::pair<std::string, StudyKind>>& kind_words() {
  static const std::vector<std::pair<std::string, StudyKind>> words = {{"map", StudyKind::kMap},
                                                                       {"uncertainty", StudyKind::kUncertainty},
                                                                       {"compare", StudyKind::kCompare},
                                                                       {"screening", StudyKind::kScreening}};
  return words;
}

const std::vector<std::pair<std::string, Method>>& method_words() {
  static const std::vector<std::pair<std::string, Method>> words = {{"grid", Method::kGrid},
                                                                    {"one-at-a-time", Method::kOneAtATime},
                                                                    {"latin-hypercube", Method::kLatinHypercube},
                                                                    {"sobol", Method::kSobol},
                                                                    {"list", Method::kList},
                                                                    {"morris", Method::kMorris},
                                                                    {"operating-points", Method::kOperatingPoints}};
  return words;
}

std::string word_of(StudyKind kind) { return word_among(kind_words(), kind); }

std::string word_of(Method method) { return word_among(method_words(), method); }

}  // namespace ringfilm::study
