#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "source_tree.hpp"

namespace ringfilm::architecture {
namespace {

TEST(Architecture, EveryFolderHasARank) {
  const auto sources = product_sources();
  ASSERT_GT(sources.size(), 10u) << "the sources were not found in " << RINGFILM_SOURCE_FOLDER;
  for (const SourceFile& file : sources) {
    EXPECT_TRUE(ranks().count(file.room)) << file.path << ": the folder " << file.room
                                          << " has no rank; give it one in tests/architecture/source_tree.cpp";
  }
}

TEST(Architecture, IncludesGoToALowerRankOrStayInTheirFolder) {
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      const std::string room = room_of_include(include.target);
      if (room.empty() || room == file.room) continue;
      ASSERT_TRUE(ranks().count(room)) << file.at(include.line) << ": " << include.target << " lies in no known folder";
      EXPECT_LT(ranks().at(room), ranks().at(file.room))
          << file.at(include.line) << ": " << file.room << " (rank " << ranks().at(file.room) << ") includes "
          << include.target << " of rank " << ranks().at(room);
    }
  }
}

TEST(Architecture, ProjectHeadersAreIncludedFromTheSourceFolder) {
  std::set<std::string> known;
  for (const SourceFile& file : product_sources()) known.insert(file.path);
  for (const SourceFile& file : product_sources()) {
    if (file.room == "apps" || file.room == "python") continue;
    for (const Include& include : file.includes) {
      if (!include.quoted) {
        EXPECT_TRUE(room_of_include(include.target).empty()) << file.at(include.line) << ": ours is written in quotes";
        continue;
      }
      const bool written_by_the_build = include.target.rfind("ringfilm_", 0) == 0;
      EXPECT_TRUE(written_by_the_build || known.count("src/" + include.target))
          << file.at(include.line) << ": \"" << include.target << "\" is no file below src/";
    }
  }
}

TEST(Architecture, NoFolderUsesItselfInACircle) {
  std::map<std::string, std::set<std::string>> uses;
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      if (room_of_include(include.target) == file.room) uses[file.path].insert("src/" + include.target);
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

/// Lowest rank that may include a header of the standard or C library; 11: no one may.
const std::map<std::string, int>& owners() {
  static const std::map<std::string, int> owners = {
      {"thread", 7},  {"mutex", 7},      {"shared_mutex", 7}, {"future", 7},  {"condition_variable", 7},
      {"atomic", 7},  {"stop_token", 7}, {"chrono", 7},       {"ctime", 7},   {"time.h", 7},
      {"fstream", 8}, {"filesystem", 8}, {"iostream", 10},    {"ranges", 11}, {"format", 11},
      {"random", 11}, {"print", 11},     {"locale", 8}};
  return owners;
}

TEST(Architecture, StreamsFilesThreadsAndClocksStayInTheRankThatOwnsThem) {
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      const auto owner = owners().find(include.target);
      if (include.quoted || owner == owners().end() || !ranks().count(file.room)) continue;
      EXPECT_GE(ranks().at(file.room), owner->second)
          << file.at(include.line) << ": <" << include.target << "> is not for rank " << ranks().at(file.room);
    }
  }
}

/// A lock (<mutex>) may also stand in io, around a library that is not made for more than one caller at a time.
TEST(Architecture, ThreadsBelongToStudiesAlone) {
  const std::set<std::string> threads = {"thread", "future", "condition_variable", "stop_token"};
  for (const SourceFile& file : product_sources()) {
    for (const Include& include : file.includes) {
      if (include.quoted || !threads.count(include.target)) continue;
      EXPECT_EQ(file.room, "study") << file.at(include.line) << ": <" << include.target << ">";
    }
  }
}

TEST(Architecture, TheSolverNeedsNoLibraryThatABrowserLacks) {
  const std::set<std::string> outside = {"toml++", "netcdf.h", "udunits2.h", "openssl", "CLI", "nlohmann", "fmt"};
  for (const SourceFile& file : product_sources()) {
    if (!ranks().count(file.room) || ranks().at(file.room) > 6) continue;
    for (const Include& include : file.includes) {
      const std::string first = include.target.substr(0, include.target.find('/'));
      EXPECT_FALSE(outside.count(first)) << file.at(include.line) << ": " << include.target;
    }
  }
}

}  // namespace
}  // namespace ringfilm::architecture
