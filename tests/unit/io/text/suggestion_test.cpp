#include "ringfilm/io/text/suggestion.hpp"

#include <gtest/gtest.h>

#include "ringfilm/base/renamed.hpp"

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

}  // namespace
}  // namespace ringfilm::io
