#pragma once
#include <map>
#include <string>
#include <vector>

/// What the architecture tests read: the sources of the project as text.
namespace ringfilm::architecture {

struct Include {
  std::string target;  ///< between the quotes or angle brackets
  bool quoted;
  int line;
};

struct SourceFile {
  std::string path;                ///< from the project's folder, e.g. "src/ringfilm/io/text/units.cpp"
  std::string module;              ///< "io"; "ringfilm" for src/ringfilm itself, "apps", "python"
  std::vector<std::string> lines;  ///< as written
  std::vector<std::string> code;   ///< the same without comments and text literals
  std::vector<Include> includes;

  std::string at(int line) const { return path + ":" + std::to_string(line); }
};

/// Layers of the modules; an include goes to a lower layer or stays in its module.
const std::map<std::string, int>& layers();

/// All .cpp and .hpp below src/, apps/ and python/ (read once a call).
std::vector<SourceFile> product_sources();

/// All sources including tests and benchmarks.
std::vector<SourceFile> all_sources();

struct TextFile {
  std::string path;
  std::vector<std::string> lines;
};

/// C++, Python, JavaScript, style sheets, CMake and shell scripts of the whole project. The prose of a tutorial, a
/// paragraph a line, is omitted.
std::vector<TextFile> all_scripts_and_sources();

/// The module that an include such as "ringfilm/io/text/units.hpp" names; empty for anything outside the project.
std::string module_of_include(const std::string& target);

/// Reads one text as if it was at `path`.
SourceFile parse_source(const std::string& path, const std::string& text);

}  // namespace ringfilm::architecture
