#include "document_tree.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace ringfilm::documents {
namespace {

namespace fs = std::filesystem;

/// The folder of the project, or the copy of it that RINGFILM_DOCUMENTS names.
fs::path root() {
  const char* copy = std::getenv("RINGFILM_DOCUMENTS");
  return copy != nullptr ? copy : RINGFILM_SOURCE_FOLDER;
}

bool ends_with(const std::string& text, const std::string& ending) {
  return text.size() >= ending.size() && text.compare(text.size() - ending.size(), ending.size(), ending) == 0;
}

/// A heading as a link names it: lower case, blanks to hyphens, other signs dropped.
std::string heading_anchor(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (std::isalnum(static_cast<unsigned char>(c)) || c == '-' || c == '_') {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (c == ' ') {
      anchor += '-';
    }
  }
  return anchor;
}

}  // namespace

std::map<std::string, std::string> texts_below(const std::string& folder, const std::vector<std::string>& endings) {
  std::map<std::string, std::string> texts;
  if (!fs::is_directory(root() / folder)) return texts;
  for (const auto& entry : fs::recursive_directory_iterator(root() / folder)) {
    const std::string path = fs::relative(entry.path(), root()).generic_string();
    const bool expected =
        std::any_of(endings.begin(), endings.end(), [&](const std::string& ending) { return ends_with(path, ending); });
    if (!expected || !entry.is_regular_file() || path.find("node_modules") != std::string::npos) continue;
    texts[path] = text_of(path);
  }
  return texts;
}

std::string text_of(const std::string& path) {
  std::stringstream text;
  text << std::ifstream(root() / path).rdbuf();
  return text.str();
}

Mentions mentions(const std::map<std::string, std::string>& texts, const std::string& pattern) {
  const std::regex expected(pattern);
  Mentions found;
  for (const auto& [path, text] : texts) {
    std::istringstream lines(text);
    int number = 0;
    for (std::string line; std::getline(lines, line);) {
      ++number;
      for (auto it = std::sregex_iterator(line.begin(), line.end(), expected); it != std::sregex_iterator(); ++it) {
        found[(*it)[1]].push_back(path + ":" + std::to_string(number));
      }
    }
  }
  return found;
}

std::string places(const std::vector<std::string>& mentioned) {
  std::string text;
  for (const std::string& place : mentioned) text += (text.empty() ? "" : ", ") + place;
  return text;
}

std::set<std::string> anchors(const std::string& markdown) {
  std::set<std::string> found;
  for (const auto& [anchor, where] : mentions({{"", markdown}}, R"re(<a id="([^"]+)">)re")) found.insert(anchor);
  for (const auto& [heading, where] : mentions({{"", markdown}}, "^#+ +(.*)$")) found.insert(heading_anchor(heading));
  return found;
}

}  // namespace ringfilm::documents
