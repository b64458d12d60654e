#include "ringfilm/io/text/suggestion.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "ringfilm/base/renamed.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/trade_terms.hpp"

namespace ringfilm::io {
namespace {

TEST(Suggestion, ANameOfAnEarlierVersionMeansItsPresentName) {
  for (const RenamedName& name : kRenamedNames) {
    const std::string before(name.before), now(name.now);
    EXPECT_EQ(nearest_word(before, {"quite_another_name", now}), now) << before;
  }
}

TEST(Suggestion, APresentNameIsOnlyProposedWhereItIsKnown) {
  EXPECT_EQ(nearest_word("contact.film_parameter", {"operating.speed"}), "");
}

TEST(Suggestion, WrongLettersAndAWrongSectionCountAsNear) {
  EXPECT_EQ(nearest_word("ring.face_widht", {"ring.face_width", "ring.tension"}), "ring.face_width");
  EXPECT_EQ(nearest_word("engine.speed", {"operating.speed", "engine.bore"}), "operating.speed");
}

TEST(Suggestion, EachTermOfTheTradeLeadsToAKeyOfTheCaseOrIsNotModelled) {
  std::vector<std::string> keys;
  for (const cycle::Field& field : cycle::case_fields()) keys.push_back(field.key);
  for (const char* term : {"closed_gap", "total_free_gap", "tangential_load", "barrel_drop", "unit_pressure",
                           "axial_width", "radial_width", "nominal_diameter", "keystone", "tapered", "twist_angle"}) {
    EXPECT_NE(key_proposal(std::string("ring.") + term, keys).near, "") << term;
  }
  EXPECT_EQ(key_proposal("lubricant.vi", keys).near, "lubricant.viscosity_index");
  EXPECT_EQ(key_proposal("kv100", keys).near, "lubricant.kinematic_viscosity");
  EXPECT_EQ(key_proposal("oil.hths", keys).near, "lubricant.hths_viscosity");
  for (const char* term : {"chamfer", "chamfers"}) {
    const KeyProposal proposal = key_proposal(std::string("ring.") + term, keys);
    EXPECT_EQ(proposal.near, "") << term;
    EXPECT_THAT(proposal.message, ::testing::EndsWith("is not modelled")) << term;
    EXPECT_NE(proposal.remedy, "") << term;
  }
  EXPECT_EQ(trade_term("operating.oil_temperature"), nullptr);
}

}  // namespace
}  // namespace ringfilm::io
