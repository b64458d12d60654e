#include "source_tree.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>

namespace ringfilm::architecture {
namespace {

namespace fs = std::filesystem;

std::string module_of_path(const std::string& path) {
  static const std::regex in_library("^src/ringfilm/([^/]+)/.*");
  std::smatch match;
  if (std::regex_match(path, match, in_library)) return match[1];
  if (path.rfind("src/ringfilm/", 0) == 0) return "ringfilm";
  return path.substr(0, path.find('/'));
}

/// Blanks comments and the inside of literals; carries the state of a block comment from line to line.
class CodeOnly {
 public:
  std::string strip(const std::string& line) {
    std::string code;
    for (std::size_t i = 0; i < line.size(); ++i) {
      if (in_block_) {
        if (line.compare(i, 2, "*/") == 0) {
          in_block_ = false;
          ++i;
        }
      } else if (line.compare(i, 2, "//") == 0) {
        break;
      } else if (line.compare(i, 2, "/*") == 0) {
        in_block_ = true;
        ++i;
      } else if (line[i] == '"' || is_character_literal(line, i)) {
        const char quote = line[i];
        code += quote;
        for (++i; i < line.size() && line[i] != quote; ++i) {
          if (line[i] == '\\') ++i;
        }
        code += quote;
      } else {
        code += line[i];
      }
    }
    return code;
  }

 private:
  /// A ' that does not separate digits.
  static bool is_character_literal(const std::string& line, std::size_t i) {
    return line[i] == '\'' && (i == 0 || !std::isalnum(static_cast<unsigned char>(line[i - 1])));
  }

  bool in_block_ = false;
};

std::vector<SourceFile> read_below(const std::vector<std::string>& folders) {
  const fs::path root = RINGFILM_SOURCE_FOLDER;
  std::vector<SourceFile> files;
  for (const std::string& folder : folders) {
    if (!fs::is_directory(root / folder)) continue;
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension();
      if (extension != ".cpp" && extension != ".hpp") continue;
      const std::string path = fs::relative(entry.path(), root).generic_string();
      if (path.find("node_modules") != std::string::npos) continue;
      std::stringstream text;
      text << std::ifstream(entry.path()).rdbuf();
      files.push_back(parse_source(path, text.str()));
    }
  }
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) { return a.path < b.path; });
  return files;
}

}  // namespace

const std::map<std::string, int>& layers() {
  static const std::map<std::string, int> layers = {
      {"base", 0},       {"surface", 1}, {"models", 2}, {"film", 3},      {"gas_path", 3}, {"case", 4},
      {"cycle", 5},      {"life", 6},    {"pad", 6},    {"study", 7},     {"io", 8},       {"run", 9},
      {"instrument", 9}, {"report", 9},  {"apps", 10},  {"ringfilm", 10}, {"python", 10}};
  return layers;
}

SourceFile parse_source(const std::string& path, const std::string& text) {
  static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"].*)");
  SourceFile file;
  file.path = path;
  file.module = module_of_path(path);
  CodeOnly code_only;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    file.lines.push_back(line);
    file.code.push_back(code_only.strip(line));
    std::smatch match;
    if (std::regex_match(line, match, include)) {
      file.includes.push_back({match[2], match[1] == "\"", static_cast<int>(file.lines.size())});
    }
  }
  return file;
}

std::vector<SourceFile> product_sources() { return read_below({"src", "apps", "python"}); }

std::vector<SourceFile> all_sources() { return read_below({"src", "apps", "python", "tests", "benchmarks"}); }

std::vector<TextFile> all_scripts_and_sources() {
  static const std::regex written(
      R"(.*\.(cpp|hpp|py|js|mjs|css|cmake|in|m)|(.*/)?CMakeLists\.txt|script/[^.]*|\.ci/.*)");
  static const std::regex by_others(R"((.*/)?(build[^/]*|node_modules|shared|\.(?!ci/)[^/]*|__pycache__)/.*)");
  const fs::path root = RINGFILM_SOURCE_FOLDER;
  std::vector<TextFile> files;
  for (auto entry = fs::recursive_directory_iterator(root); entry != fs::recursive_directory_iterator(); ++entry) {
    const std::string path = entry->path().lexically_relative(root).generic_string();
    if (entry->is_directory() && std::regex_match(path + "/", by_others)) entry.disable_recursion_pending();
    if (!entry->is_regular_file() || !std::regex_match(path, written)) continue;
    TextFile file{path, {}};
    std::ifstream stream(entry->path());
    for (std::string line; std::getline(stream, line);) {
      const bool is_prose = path.rfind("docs/tutorials/", 0) == 0 && line.rfind("# ", 0) == 0;
      file.lines.push_back(is_prose ? "" : line);
    }
    files.push_back(std::move(file));
  }
  return files;
}

std::string module_of_include(const std::string& target) {
  if (target.rfind("ringfilm/", 0) != 0) return "";
  const std::string rest = target.substr(9);
  const std::size_t slash = rest.find('/');
  return slash == std::string::npos ? "ringfilm" : rest.substr(0, slash);
}

}  // namespace ringfilm::architecture
