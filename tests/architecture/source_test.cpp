#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "source_tree.hpp"

namespace ringfilm::architecture {
namespace {

TEST(Architecture, NoFileIsLongerThan600Lines) {
  for (const SourceFile& file : all_sources()) {
    EXPECT_LE(file.lines.size(), 600u) << file.path << ": split it by what its parts are about";
  }
}

/// Number of characters of a text in UTF-8.
std::size_t width_of(const std::string& line) {
  return static_cast<std::size_t>(
      std::count_if(line.begin(), line.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

TEST(Architecture, NoLineIsLongerThan120Characters) {
  const std::vector<TextFile> files = all_scripts_and_sources();
  ASSERT_GT(files.size(), 500u);
  for (const TextFile& file : files) {
    for (std::size_t i = 0; i < file.lines.size(); ++i) {
      EXPECT_LE(width_of(file.lines[i]), 120u) << file.path << ":" << i + 1;
    }
  }
}

TEST(Architecture, NoFileHasAnAtticName) {
  static const std::regex attic(R"((^|[_/.-])(utils?|commons?|helpers?|misc|managers?|old|v2)([_/.-]|$))");
  for (const SourceFile& file : product_sources()) {
    EXPECT_FALSE(std::regex_search(file.path, attic)) << file.path << ": name it after what it holds";
  }
}

TEST(Architecture, EverySourceImplementsAHeaderOfItsFolder) {
  for (const SourceFile& file : product_sources()) {
    if (file.path.rfind("src/", 0) != 0 || file.path.substr(file.path.size() - 4) != ".cpp") continue;
    EXPECT_TRUE(std::any_of(file.includes.begin(), file.includes.end(), [&](const Include& include) {
      return module_of_include(include.target) == file.module;
    })) << file.path;
  }
}

/// Does a line of code declare state that outlives a call and can be written? A lock keeps nothing and is let through.
bool declares_writable_state(const std::string& code) {
  static const std::regex of_a_function(
      R"(^\s*((inline|static|thread_local)\s+)+(?!const\b|constexpr\b|std::mutex\b)[^()]*(=|;|\{).*)");
  static const std::regex across_files(R"(^\s*extern\s+(?!const\b|template\b)[^(){]*;.*)");
  return std::regex_match(code, of_a_function) || std::regex_match(code, across_files);
}

TEST(Architecture, NoWritableStaticsOrGlobals) {
  for (const SourceFile& file : product_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(declares_writable_state(file.code[i]))
          << file.at(static_cast<int>(i) + 1) << ": two solves at once would share this";
    }
  }
}

TEST(SourceTree, WritableStateIsReported) {
  EXPECT_TRUE(declares_writable_state("  static int calls = 0;"));
  EXPECT_TRUE(declares_writable_state("static std::map<int, double> cache;"));
  EXPECT_TRUE(declares_writable_state("thread_local Workspace work{};"));
  EXPECT_TRUE(declares_writable_state("extern int verbosity;"));
  EXPECT_FALSE(declares_writable_state("  static const std::vector<int> table = {1};"));
  EXPECT_FALSE(declares_writable_state("static constexpr double kLimit = 2;"));
  EXPECT_FALSE(declares_writable_state("  static RingFace points(std::vector<double> x);"));
  EXPECT_FALSE(declares_writable_state("inline double square(double x) { return x * x; }"));
}

/// Does a line of code print or convert by hand? A small factor in front is a tolerance: 1e-9 * length.
bool converts_by_hand(const std::string& code) {
  static const std::regex by_hand(R"(\bv?sn?printf\b|\b273\.15\b|\b60?e[34]\b|[*/] *1e-?\d|\b1e\d+ *\*)");
  return std::regex_search(code, by_hand);
}

TEST(Architecture, TextsOfNumbersAndUnitsHaveOnePlace) {
  // The coefficients of a face polynomial are in um and mm by definition.
  static const std::regex exempt(R"(/base/(number_text\.cpp|constants\.hpp|display\.hpp)$|/face_polynomial\.cpp$)");
  for (const SourceFile& file : product_sources()) {
    if (std::regex_search(file.path, exempt)) continue;
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(converts_by_hand(file.code[i]))
          << file.at(static_cast<int>(i) + 1)
          << ": base/display.hpp, base/number_text.hpp, base/constants.hpp or io/text/units.hpp has it";
    }
  }
}

TEST(SourceTree, ConversionsByHandAreReported) {
  for (const char* code : {"f(x * 1e6)", "p / 1e5", "1e3 * width", "p * 1e-5", "T - 273.15", "snprintf(to, n, f)"}) {
    EXPECT_TRUE(converts_by_hand(code)) << code;
  }
  for (const char* code : {"away <= 1e-9 * length", "x + 1e6", "2.5 * 3.48e-17", "100 * share"}) {
    EXPECT_FALSE(converts_by_hand(code)) << code;
  }
}

TEST(Architecture, BoundsAreNamedMinAndMax) {
  static const std::regex other(
      R"(\bk(Least|Fewest|Smallest|Shortest|Lowest|Most|Largest|Longest|Highest)([A-Z]\w*)?\b)");
  for (const SourceFile& file : product_sources()) {
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.code[i], other))
          << file.at(static_cast<int>(i) + 1) << ": name it kMin... or kMax...";
    }
  }
}

TEST(Architecture, TheSolverUsesNothingThatAnOlderLibraryLacks) {
  static const std::regex lacking(
      R"(std::(bit_cast|views|ranges|format|print|cout|cerr|clog|fopen|printf|puts|FILE|from_chars)\b)");
  for (const SourceFile& file : product_sources()) {
    if (!layers().count(file.module) || layers().at(file.module) > 6) continue;
    for (std::size_t i = 0; i < file.code.size(); ++i) {
      EXPECT_FALSE(std::regex_search(file.code[i], lacking))
          << file.at(static_cast<int>(i) + 1) << ": " << file.lines[i];
    }
  }
}

TEST(Architecture, HeadersGuardThemselves) {
  for (const SourceFile& file : all_sources()) {
    if (file.path.substr(file.path.size() - 4) != ".hpp" || file.lines.empty()) continue;
    EXPECT_EQ(file.lines.front(), "#pragma once") << file.path;
  }
}

// The reader of sources itself.

TEST(SourceTree, CommentsAndTextAreNoCode) {
  const auto file = parse_source("src/ringfilm/film/a.cpp",
                                 "int a; // static int b;\nf(\"static \\\" int\"); /* x\nstatic int y;\n*/ z\n");
  EXPECT_EQ(file.code[0], "int a; ");
  EXPECT_EQ(file.code[1], "f(\"\"); ");
  EXPECT_EQ(file.code[2], "");
  EXPECT_EQ(file.code[3], " z");
  EXPECT_EQ(file.module, "film");
}

TEST(SourceTree, IncludesAreFoundHoweverTheyAreSpaced) {
  const auto file =
      parse_source("apps/ringfilm/main.cpp", "#include <vector>\n  # include \"ringfilm/io/text/units.hpp\" // why\n");
  ASSERT_EQ(file.includes.size(), 2u);
  EXPECT_FALSE(file.includes[0].quoted);
  EXPECT_EQ(file.includes[1].target, "ringfilm/io/text/units.hpp");
  EXPECT_EQ(module_of_include(file.includes[1].target), "io");
  EXPECT_EQ(file.module, "apps");
}

}  // namespace
}  // namespace ringfilm::architecture
