#include <gtest/gtest.h>

#include <string>

#include "document_tree.hpp"
#include "ringfilm/models/oil/viscosity_laws.hpp"

namespace ringfilm::documents {
namespace {

TEST(Docs, EveryViscosityLawHasItsEquationAndNameInTheTheory) {
  const std::string theory = text_of("docs/theory/oil.md");
  for (const models::ViscosityLaw& law : models::viscosity_laws()) {
    const std::size_t label = theory.find("<a id=\"" + law.equation + "\">");
    ASSERT_NE(label, std::string::npos) << law.name << " names " << law.equation << ", which docs/theory/oil.md lacks";
    const std::string entry = theory.substr(label, theory.find("<a id=", label + 1) - label);
    EXPECT_NE(entry.find("`lubricant.viscosity_pressure = \"" + law.name + "\"`"), std::string::npos)
        << "docs/theory/oil.md does not state beside " << law.equation << " how a case chooses " << law.name;
    EXPECT_NE(entry.find("$$"), std::string::npos) << law.equation << " has no equation";
  }
}

TEST(Docs, TheListOfCaseKeysNamesEveryViscosityLawAndItsParameters) {
  const std::string keys = text_of("docs/manual/case-keys.txt");
  for (const models::ViscosityLaw& law : models::viscosity_laws()) {
    EXPECT_NE(keys.find(law.name + ": " + law.meaning), std::string::npos) << law.name;
  }
  for (const models::LawParameter& parameter : models::law_parameters()) {
    EXPECT_NE(keys.find("  " + parameter.key + " "), std::string::npos) << parameter.key;
  }
}

}  // namespace
}  // namespace ringfilm::documents
