#include "ringfilm/io/study/factor_notes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "../case_example.hpp"
#include "ringfilm/io/study/study_file.hpp"

namespace ringfilm::io {
namespace {

TEST(FactorNotes, NameTheRangeInTheUnitsOfPeopleAndJoinTheFactorsOfAValue) {
  ScratchFolder folder;
  folder.write("case.toml", CaseText{}.text());
  folder.write("p.csv", full_trace());
  const StudyFile file = read_study(
      folder.write("study.toml",
                   "[[base]]\ncase = \"case.toml\"\n[[factor]]\nname = \"sigma\"\nkey = \"contact.roughness\"\n"
                   "values = [\"0.1 um\", \"0.2 um\", \"0.3 um\", \"0.4 um\"]\n[[factor]]\nname = \"speed\"\n"
                   "key = \"operating.speed\"\nvalues = [\"1000 rpm\", \"1100 rpm\"]\n[plan]\nmethod = \"grid\"\n"));
  const study::Plan plan(file.study);
  const std::size_t fmep = plan.values().index("fmep").value(),
                    film = plan.values().index("min_film_thickness").value();
  const auto notes =
      flat_notes(plan, {{0, fmep, false, 2e-7, 4e-7}, {1, film, true, 100, 110}, {1, fmep, true, 100, 110}}, 0.02);
  EXPECT_THAT(
      notes,
      ::testing::UnorderedElementsAre(
          "the friction mean effective pressure changes by less than 2 % with \"sigma\" from 0.2 um to 0.4 um, "
          "\"speed\", the other factors "
          "unchanged: such a factor cannot be fitted to a measured one",
          "the minimum film thickness changes by less than 2 % with \"speed\", the other factors unchanged: such a "
          "factor cannot be fitted to a measured one"));
}

}  // namespace
}  // namespace ringfilm::io
