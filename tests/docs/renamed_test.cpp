#include "ringfilm/base/renamed.hpp"

#include <gtest/gtest.h>

#include <set>

#include "document_tree.hpp"
#include "ringfilm/case/keys/case_fields.hpp"

namespace ringfilm::documents {
namespace {

TEST(Docs, TheListOfRenamedNamesIsThatOfTheProgram) {
  std::string lines = "kind,old,new,since\n";
  for (const RenamedName& name : kRenamedNames)
    lines += std::string(name.kind) + "," + std::string(name.before) + "," + std::string(name.now) + "," +
             std::string(name.since) + "\n";
  EXPECT_EQ(text_of("docs/renamed.csv"), lines);
}

TEST(Docs, RenamedNamesHaveOneMeaningAndAKnownKind) {
  const std::set<std::string_view> kinds = {"key", "choice", "command", "option", "json", "csv", "netcdf"};
  std::map<std::string_view, std::string_view> present;
  for (const RenamedName& name : kRenamedNames) {
    EXPECT_TRUE(kinds.count(name.kind)) << name.kind;
    EXPECT_EQ(present.emplace(name.before, name.now).first->second, name.now) << name.before;
  }
}

TEST(Docs, RenamedKeysOfCasesExistUnderTheirPresentNamesOnly) {
  for (const RenamedName& name : kRenamedNames) {
    if (name.kind != "key") continue;
    EXPECT_EQ(cycle::find_field(std::string(name.before)), nullptr) << name.before;
    EXPECT_NE(cycle::find_field(std::string(name.now)), nullptr) << name.now;
  }
}

}  // namespace
}  // namespace ringfilm::documents
