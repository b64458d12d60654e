#include "ringfilm/report/payload/unsolved_reasons.hpp"

#include <algorithm>
#include <cctype>

namespace ringfilm::report {
namespace {

constexpr std::size_t kMaxReasons = 1000;

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

/// The text with a # in place of each number.
std::string words_of(const std::string& text) {
  std::string words;
  for (std::size_t i = 0; i < text.size();) {
    const bool is_signed = text[i] == '-' && i + 1 < text.size() && is_digit(text[i + 1]);
    if (!is_digit(text[i]) && !is_signed) {
      words.push_back(text[i++]);
      continue;
    }
    words.push_back('#');
    const auto is_continued = [&text](std::size_t at) {
      if (is_digit(text[at])) return true;
      if (at + 1 == text.size()) return false;
      const char next = text[at + 1];
      if (text[at] == '.') return is_digit(next);
      if (text[at] == 'e') return is_digit(next) || next == '-' || next == '+';
      return (text[at] == '-' || text[at] == '+') && text[at - 1] == 'e' && is_digit(next);
    };
    for (++i; i < text.size() && is_continued(i); ++i) continue;
  }
  return words;
}

}  // namespace

void UnsolvedReasons::add(std::uint64_t scenario, const std::string& text) {
  ++count_;
  std::string words = words_of(text);
  // What numbers are in is bounded, the words of a reason are not.
  const bool is_one_too_many = by_words_.size() >= kMaxReasons && by_words_.find(words) == by_words_.end();
  if (is_one_too_many) words.clear();
  Reason& known = by_words_[words];
  if (known.count++ == 0) {
    known.text = is_one_too_many ? "other reasons" : text;
    known.first = scenario;
  } else if (!is_one_too_many && known.text != text) {
    known.numbers_differ = true;
  }
}

std::vector<UnsolvedReasons::Reason> UnsolvedReasons::most_frequent_first() const {
  std::vector<Reason> reasons;
  for (const auto& [words, reason] : by_words_) reasons.push_back(reason);
  std::stable_sort(reasons.begin(), reasons.end(), [](const Reason& a, const Reason& b) {
    return a.count != b.count ? a.count > b.count : a.first < b.first;
  });
  return reasons;
}

}  // namespace ringfilm::report
