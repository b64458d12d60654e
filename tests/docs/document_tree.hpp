#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

/// What the tests of the documents read.
namespace ringfilm::documents {

/// Every hit of a pattern's first group, with the places "file:line" where it is.
using Mentions = std::map<std::string, std::vector<std::string>>;

/// Texts of the files below `folder` (from the project's folder) whose name ends in one of `endings`, by path.
std::map<std::string, std::string> texts_below(const std::string& folder, const std::vector<std::string>& endings);

/// One file; empty if it is not there.
std::string text_of(const std::string& path);

/// Looks for `pattern` line by line.
Mentions mentions(const std::map<std::string, std::string>& texts, const std::string& pattern);

/// "a:1, b:7" for a message.
std::string places(const std::vector<std::string>& mentioned);

/// Anchors `<a id="...">` and headings (as links name them) of one Markdown text.
std::set<std::string> anchors(const std::string& markdown);

}  // namespace ringfilm::documents
