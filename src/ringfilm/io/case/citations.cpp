#include "ringfilm/io/case/citations.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>
#include <sstream>

#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/storage/shipped.hpp"
#include "ringfilm/io/text/source_text.hpp"

namespace ringfilm::io {
namespace {

constexpr const char* kTable = "data/citations.csv";
constexpr const char* kBibliography = "docs/references.bib";
constexpr const char* kAnyValue = "*";

std::string shipped_text(const char* name) {
  return read_source_text(shipped_folder() + "/" + name, name, kMaxToml).text;
}

/// The entries of the bibliography by key, in its order.
std::vector<std::pair<std::string, std::string>> bibliography() {
  const std::string text = shipped_text(kBibliography);
  const std::regex head(R"(@\w+\{([\w-]+),)");
  std::vector<std::pair<std::string, std::string>> entries;
  for (std::sregex_iterator at(text.begin(), text.end(), head), end; at != end; ++at) {
    const auto begin = static_cast<std::size_t>(at->position());
    const std::size_t close = text.find("\n}", begin);
    entries.emplace_back((*at)[1].str(), text.substr(begin, close == std::string::npos ? close : close + 2 - begin));
  }
  return entries;
}

struct CitedChoice {
  std::string key, value;
  std::vector<std::string> sources;
};

std::vector<CitedChoice> cited_choices() {
  std::vector<CitedChoice> all;
  std::istringstream lines(shipped_text(kTable));
  std::string line;
  std::getline(lines, line);  // its header
  while (std::getline(lines, line)) {
    CitedChoice one;
    std::istringstream cells(line);
    std::string sources, source;
    std::getline(cells, one.key, ',');
    std::getline(cells, one.value, ',');
    std::getline(cells, sources);
    std::istringstream words(sources);
    while (words >> source) one.sources.push_back(source);
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace

std::vector<std::string> citation_keys(const std::vector<CaseEntry>& inputs, const std::vector<std::string>& texts) {
  std::multimap<std::string, std::string> values;
  for (const CaseEntry& entry : inputs) {
    const auto of_ring = cycle::ring_key(entry.key);
    values.emplace(of_ring ? of_ring->key : entry.key, entry.shown);
  }
  std::vector<std::string> keys;
  const auto add = [&](const std::string& key) {
    if (std::ranges::find(keys, key) == keys.end()) keys.push_back(key);
  };
  for (const CitedChoice& choice : cited_choices()) {
    const auto [begin, end] = values.equal_range(choice.key);
    const bool is_made = std::any_of(begin, end, [&](const auto& value) {
      return choice.value == kAnyValue ? value.second != "none" : value.second == choice.value;
    });
    if (!is_made) continue;
    for (const std::string& key : choice.sources) add(key);
  }
  std::set<std::string> words;
  const std::regex word(R"([\w-]+)");
  for (const std::string& text : texts) {
    for (std::sregex_iterator at(text.begin(), text.end(), word), end; at != end; ++at) words.insert(at->str());
  }
  for (const auto& [key, entry] : bibliography()) {
    if (words.contains(key)) add(key);
  }
  return keys;
}

std::string citations_bibtex(const std::vector<std::string>& keys, const std::string& program) {
  std::string text = fmt::format(
      "@software{{ringfilm,\n  author = {{{{The ringfilm authors}}}},\n  title = {{{}: mixed lubrication of the "
      "piston ring-liner conjunction}}\n}}\n",
      program);
  const auto entries = bibliography();
  for (const std::string& key : keys) {
    const auto found = std::ranges::find(entries, key, [](const auto& one) { return one.first; });
    if (found != entries.end()) text += "\n" + found->second + "\n";
  }
  return text;
}

}  // namespace ringfilm::io
