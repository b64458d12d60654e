#include "ringfilm/io/text/suggestion.hpp"

#include <algorithm>

#include "ringfilm/base/renamed.hpp"
#include "ringfilm/io/text/trade_terms.hpp"

namespace ringfilm::io {
namespace {

std::size_t edit_distance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> two_back(b.size() + 1), back(b.size() + 1), now(b.size() + 1);
  for (std::size_t j = 0; j <= b.size(); ++j) back[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    now[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t changed = back[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      now[j] = std::min({back[j] + 1, now[j - 1] + 1, changed});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
        now[j] = std::min(now[j], two_back[j - 2] + 1);
    }
    two_back.swap(back);
    back.swap(now);
  }
  return back[b.size()];
}

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

}  // namespace

std::string nearest_word(const std::string& written, const std::vector<std::string>& known) {
  constexpr std::size_t kMaxWord = 200;
  if (written.size() > kMaxWord) return "";
  const std::string_view present = present_name(written);
  if (!present.empty() && std::find(known.begin(), known.end(), present) != known.end()) return std::string(present);
  std::string nearest;
  std::size_t least = std::max<std::size_t>(2, written.size() / 4) + 1;
  for (const std::string& word : known) {
    std::size_t distance = edit_distance(written, word);
    if (last_part(written) == last_part(word)) distance = std::min<std::size_t>(distance, 2);
    if (distance < least) {
      least = distance;
      nearest = word;
    }
  }
  return nearest;
}

std::string did_you_mean(const std::string& written, const std::vector<std::string>& known) {
  const std::string near = nearest_word(written, known);
  return near.empty() ? "" : "; did you mean " + near + "?";
}

KeyProposal key_proposal(const std::string& written, const std::vector<std::string>& known) {
  const TradeTerm* const term = trade_term(written);
  if (term != nullptr && term->key.empty()) {
    return {"", ": " + std::string(term->word) + " is not modelled", std::string(term->remedy)};
  }
  const bool is_term = term != nullptr && std::find(known.begin(), known.end(), term->key) != known.end();
  const std::string near = is_term ? std::string(term->key) : nearest_word(written, known);
  if (near.empty()) return {"", "", "`ringfilm fields` lists all keys"};
  return {near, "; did you mean " + near + "?", is_term ? std::string(term->remedy) : ""};
}

}  // namespace ringfilm::io
