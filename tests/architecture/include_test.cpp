#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "source_tree.hpp"

namespace ringfilm::architecture {
namespace {

TEST(Architecture, EveryFolderHasALayer) {
  const auto sources = product_sources();
  ASSERT_GT(sources.size(), 10u) << "the sources were not found in " << RINGFILM_SOURCE_FOLDER;
  for (const SourceFile& file : sources) {
    EXPECT_TRUE(layers().count(file.module)) << file.path << ": the folder " << file.module
                                             << " has no layer; give it one in tests/architecture/source_tree.cpp";
  }
}

TEST(Architecture, IncludesGoToALowerLayerOrStayInTheirFolder) {
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      const std::string module = module_of_include(include.target);
      if (module.empty() || module == file.module) continue;
      ASSERT_TRUE(layers().count(module))
          << file.at(include.line) << ": " << include.target << " lies in no known folder";
      EXPECT_LT(layers().at(module), layers().at(file.module))
          << file.at(include.line) << ": " << file.module << " (layer " << layers().at(file.module) << ") includes "
          << include.target << " of layer " << layers().at(module);
    }
  }
}

TEST(Architecture, ProjectHeadersAreIncludedFromTheSourceFolder) {
  std::set<std::string> known;
  for (const SourceFile& file : product_sources()) known.insert(file.path);
  for (const SourceFile& file : product_sources()) {
    if (file.module == "apps" || file.module == "python") continue;
    for (const Include& include : file.includes) {
      if (!include.quoted) {
        EXPECT_TRUE(module_of_include(include.target).empty())
            << file.at(include.line) << ": ours is written in quotes";
        continue;
      }
      const bool written_by_the_build = include.target.rfind("ringfilm_", 0) == 0;
      EXPECT_TRUE(written_by_the_build || known.count("src/" + include.target))
          << file.at(include.line) << ": \"" << include.target << "\" is not a file below src/";
    }
  }
}

TEST(Architecture, NoFolderUsesItselfInACircle) {
  std::map<std::string, std::set<std::string>> uses;
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      if (module_of_include(include.target) == file.module) uses[file.path].insert("src/" + include.target);
    }
  }
  std::set<std::string> done;
  std::vector<std::string> path;
  const std::function<void(const std::string&)> walk = [&](const std::string& node) {
    const auto seen = std::find(path.begin(), path.end(), node);
    if (seen != path.end()) {
      std::string circle;
      for (auto it = seen; it != path.end(); ++it) circle += *it + " -> ";
      ADD_FAILURE() << "circle: " << circle << node;
      return;
    }
    if (!done.insert(node).second) return;
    path.push_back(node);
    for (const std::string& next : uses[node]) walk(next);
    path.pop_back();
  };
  std::vector<std::string> nodes;
  for (const auto& [node, targets] : uses) nodes.push_back(node);
  for (const std::string& node : nodes) walk(node);
}

std::string folder_of(const std::string& path) { return path.substr(0, path.rfind('/')); }

TEST(Architecture, NoTwoFoldersOfAModuleIncludeEachOther) {
  std::map<std::string, std::map<std::string, std::string>> uses;  // by folder, with the first place
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      if (module_of_include(include.target) != file.module) continue;
      const std::string from = folder_of(file.path), to = folder_of("src/" + include.target);
      if (from != to) uses[from].emplace(to, file.at(include.line));
    }
  }
  ASSERT_GT(uses.size(), 20u);
  for (const auto& [from, targets] : uses) {
    for (const auto& [to, place] : targets) {
      const auto back = uses.find(to);
      if (from > to || back == uses.end() || !back->second.count(from)) continue;
      ADD_FAILURE() << from << " and " << to << " include each other: " << place << " and " << back->second.at(from);
    }
  }
}

/// Lowest layer that may include a header of the standard or C library; 11: none.
const std::map<std::string, int>& owners() {
  static const std::map<std::string, int> owners = {
      {"thread", 7},  {"mutex", 7},      {"shared_mutex", 7}, {"future", 7},  {"condition_variable", 7},
      {"atomic", 7},  {"stop_token", 7}, {"chrono", 7},       {"ctime", 7},   {"time.h", 7},
      {"fstream", 8}, {"filesystem", 8}, {"iostream", 10},    {"ranges", 11}, {"format", 11},
      {"random", 11}, {"print", 11},     {"locale", 8}};
  return owners;
}

TEST(Architecture, StreamsFilesThreadsAndClocksStayInTheLayerThatOwnsThem) {
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      const auto owner = owners().find(include.target);
      if (include.quoted || owner == owners().end() || !layers().count(file.module)) continue;
      EXPECT_GE(layers().at(file.module), owner->second)
          << file.at(include.line) << ": <" << include.target << "> is not for layer " << layers().at(file.module);
    }
  }
}

/// A lock (<mutex>) may also are in io, around a library that is not made for more than one caller at a time.
TEST(Architecture, ThreadsBelongToStudiesAlone) {
  const std::set<std::string> threads = {"thread", "future", "condition_variable", "stop_token"};
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      if (include.quoted || !threads.count(include.target)) continue;
      EXPECT_EQ(file.module, "study") << file.at(include.line) << ": <" << include.target << ">";
    }
  }
}

TEST(Architecture, TheSolverNeedsNoLibraryThatABrowserLacks) {
  const std::set<std::string> outside = {"toml++", "netcdf.h", "udunits2.h", "openssl", "CLI", "nlohmann", "fmt"};
  for (const SourceFile& file : product_sources()) {
    if (!layers().count(file.module) || layers().at(file.module) > 6) continue;
    for (const Include& include : file.includes) {
      const std::string first = include.target.substr(0, include.target.find('/'));
      EXPECT_FALSE(outside.count(first)) << file.at(include.line) << ": " << include.target;
    }
  }
}

}  // namespace
}  // namespace ringfilm::architecture
