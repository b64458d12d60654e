#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "document_tree.hpp"

namespace ringfilm::documents {
namespace {

const std::vector<std::string> kSources = {".hpp", ".cpp", ".ts", ".js", ".py"};

std::map<std::string, std::string> sources() {
  auto texts = texts_below("src", kSources);
  texts.merge(texts_below("apps", kSources));
  texts.merge(texts_below("python", kSources));
  return texts;
}

std::map<std::string, std::string> documents_of_the_project() {
  auto texts = texts_below("docs", {".md"});
  texts.merge(texts_below("verification", {".md"}));
  texts.merge(texts_below("cases", {".md"}));
  texts.merge(texts_below("data", {".md"}));
  for (const std::string file : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md"}) texts[file] = text_of(file);
  return texts;
}

Mentions labels_of_the_theory() { return mentions(texts_below("docs/theory", {".md"}), R"re(<a id="(eq-[^"]+)">)re"); }

Mentions keys_of_the_bibliography() {
  return mentions({{"docs/references.bib", text_of("docs/references.bib")}}, R"(^@\w+\{(\w+),)");
}

TEST(Docs, EveryEquationThatCodeNamesIsInTheTheory) {
  const Mentions labels = labels_of_the_theory();
  ASSERT_GT(labels.size(), 20u);
  for (const auto& [label, where] : mentions(sources(), R"(\b(eq-[a-z0-9]+(-[a-z0-9]+)*))")) {
    EXPECT_TRUE(labels.count(label)) << label << " is named at " << places(where);
  }
}

TEST(Docs, NoLabelIsRepeated) {
  for (const auto& [label, where] : labels_of_the_theory())
    EXPECT_EQ(where.size(), 1u) << label << ": " << places(where);
}

TEST(Docs, EveryEquationHasANumberOfItsOwn) {
  const Mentions numbers = mentions(texts_below("docs/theory", {".md"}), R"(^\*\*\((\d+\.\d+)\)\*\*)");
  EXPECT_EQ(numbers.size(), labels_of_the_theory().size());
  for (const auto& [number, where] : numbers) EXPECT_EQ(where.size(), 1u) << number << ": " << places(where);
}

TEST(Docs, EveryCitedSourceIsInTheBibliography) {
  const Mentions keys = keys_of_the_bibliography();
  ASSERT_GT(keys.size(), 5u);
  for (const auto& [key, where] : mentions(sources(), R"(@cite (\w+))")) {
    EXPECT_TRUE(keys.count(key)) << key << " is cited at " << places(where);
  }
  // In prose a key is a name and a year without a blank.
  for (const auto& [key, where] : mentions(documents_of_the_project(), R"(\b([a-z]+(?:19|20)\d\d)\b(?![\w/.-]))")) {
    EXPECT_TRUE(keys.count(key)) << key << " is cited at " << places(where);
  }
}

TEST(Docs, NoSourceIsListedTwice) {
  for (const auto& [key, where] : keys_of_the_bibliography())
    EXPECT_EQ(where.size(), 1u) << key << ": " << places(where);
}

TEST(Docs, EveryLinkToAFileLeadsSomewhere) {
  namespace fs = std::filesystem;
  for (const auto& [path, text] : documents_of_the_project()) {
    for (const auto& [target, where] : mentions({{path, text}}, R"(\]\(([^)\s]+)\))")) {
      if (target.find("://") != std::string::npos || target.rfind("mailto:", 0) == 0) continue;
      const std::size_t hash = target.find('#');
      const std::string file = target.substr(0, hash);
      const std::string linked =
          file.empty() ? path : (fs::path(path).parent_path() / file).lexically_normal().generic_string();
      const fs::path absolute = fs::path(RINGFILM_SOURCE_FOLDER) / linked;
      EXPECT_TRUE(fs::exists(absolute)) << target << " at " << places(where);
      if (hash == std::string::npos || !fs::is_regular_file(absolute)) continue;
      EXPECT_TRUE(anchors(text_of(linked)).count(target.substr(hash + 1))) << target << " at " << places(where);
    }
  }
}

TEST(Docs, EveryDocumentThatCodePointsToExists) {
  for (const auto& [target, where] : mentions(sources(), R"((docs/[\w/.-]+\.md(?:#[\w-]+)?))")) {
    const std::size_t hash = target.find('#');
    const std::string text = text_of(target.substr(0, hash));
    EXPECT_FALSE(text.empty()) << target << " is named at " << places(where);
    if (hash == std::string::npos || text.empty()) continue;
    EXPECT_TRUE(anchors(text).count(target.substr(hash + 1))) << target << " is named at " << places(where);
  }
}

/// The ledger links each topic to the page of assumptions.
TEST(Docs, EveryTopicOfTheLedgerIsArgued) {
  const std::set<std::string> argued = anchors(text_of("docs/theory/assumptions.md"));
  const std::string ledger = text_of("src/ringfilm/study/ensemble/assumptions.cpp");
  const std::regex topic(R"re((?:assumption\(|topic =)\s*"([a-z-]+)")re");
  int topics = 0;
  for (auto it = std::sregex_iterator(ledger.begin(), ledger.end(), topic); it != std::sregex_iterator(); ++it) {
    ++topics;
    EXPECT_TRUE(argued.count((*it)[1])) << (*it)[1];
  }
  EXPECT_GT(topics, 10);
}

}  // namespace
}  // namespace ringfilm::documents
