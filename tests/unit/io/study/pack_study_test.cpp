#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>

#include "../scratch_folder.hpp"
#include "ringfilm/cycle/pack/gas_through_films.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/study/design/kept_curves.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/pack_scenario.hpp"

/// Studies of ring packs, from their files to the rows.
namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

const std::string kSource = RINGFILM_SOURCE_FOLDER;
const std::string kGrid = "[plan]\nmethod = \"grid\"\n";
const std::string kGap = "[[factor]]\nkey = \"ring.1.end_gap\"\nvalues = [\"0.2 mm\", \"0.5 mm\"]\n";

// Coarse, and of rings by themselves: fast.
const std::string kCoarse =
    "[[factor]]\nkey = \"solver.cells\"\nvalues = [40]\n[[factor]]\nkey = \"film.supply\"\nvalues = [\"given\"]\n"
    "[[factor]]\nkey = \"solver.crank_step_control\"\nvalues = [\"fixed\"]\n"
    "[[factor]]\nkey = \"solver.crank_step\"\nvalues = [\"4 degree\"]\n";

/// A study of the shipped pack; `head` comes before its base.
class PackStudy : public ::testing::Test {
 protected:
  study::Plan plan(const std::string& head, const std::string& rest, const std::string& base = "") const {
    const std::string of = base.empty() ? kSource + "/cases/studies/bases/fired_pack.toml" : base;
    return study::Plan(
        read_study(folder_.write("study.toml", head + "[[base]]\nname = \"car\"\ncase = \"" + of + "\"\n" + rest))
            .study);
  }
  std::string refusal(const std::string& head, const std::string& rest, const std::string& base = "") const {
    try {
      plan(head, rest, base);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }
  static std::vector<study::ScenarioRow> rows(const study::Plan& plan) {
    std::vector<study::ScenarioRow> all;
    study::run_scenarios(plan, {0, plan.size()}, [&](const study::ScenarioBlock& block) {
      all.insert(all.end(), block.rows.begin(), block.rows.end());
      return study::Continuation::kYes;
    });
    return all;
  }
  static double value(const study::Plan& plan, const study::ScenarioRow& row, const std::string& name) {
    return row.values.at(plan.values().index(name).value());
  }

  ScratchFolder folder_;
};

TEST_F(PackStudy, OfTheGasAloneHasTheGasOfEachScenario) {
  const study::Plan plan = this->plan("compute = \"gas\"\n", kGap + kGrid);
  const std::vector<study::ScenarioRow> all = rows(plan);
  ASSERT_EQ(all.size(), 2u);
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(all[i].reason, "");
    const cycle::Case c = study::scenario_case(plan.study(), plan.point(i));
    EXPECT_EQ(c.rings.at(0).ring.end_gap, i == 0 ? 0.2e-3 : 0.5e-3);
    EXPECT_EQ(c.ring.end_gap, c.rings.at(0).ring.end_gap);
    const auto gas = cycle::solve_gas_of_case(c).gas.value();
    EXPECT_EQ(value(plan, all[i], "blow_by_per_cycle"), gas.blow_by);
    for (const auto& region : gas.regions) {
      const auto found = plan.values().index(study::region_value_name(region.name, "peak_pressure"));
      EXPECT_EQ(found.has_value(), region.name != "chamber" && region.name != "crankcase") << region.name;
      if (found) {
        EXPECT_EQ(all[i].values[*found], region.peak_pressure) << region.name;
      }
    }
  }
  EXPECT_GT(value(plan, all[1], "land_2_peak_pressure"), 1.5 * value(plan, all[0], "land_2_peak_pressure"));
}

TEST_F(PackStudy, HasTheRingsOfEachScenarioAndTheirSum) {
  const study::Plan plan = this->plan("", kCoarse + kGrid);
  const std::vector<study::ScenarioRow> all = rows(plan);
  ASSERT_EQ(all.size(), 1u);
  ASSERT_EQ(all[0].reason, "");
  const cycle::Case faces = cycle::with_rails(study::scenario_case(plan.study(), plan.point(0)));
  ASSERT_EQ(faces.rings.size(), 4u);  // two rails
  const cycle::Case found = cycle::solve_gas_through_films(faces).input;
  const double temperature[] = {600, 450, 400, 360, 360};  // above and below the rings and rails, as the case states
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(found.rings[i].ring.gas_path.computed_temperature_above, temperature[i]) << i;
    EXPECT_EQ(found.rings[i].ring.gas_path.computed_temperature_below, temperature[i + 1]) << i;
  }
  std::vector<cycle::CycleValues> each;
  for (const cycle::Case& ring : found.rings) each.push_back(cycle::simulate(cycle::prepare(ring)).values);
  EXPECT_EQ(value(plan, all[0], "ring_1_fmep"), each[0].fmep);
  EXPECT_EQ(value(plan, all[0], "ring_2_min_film_thickness"), each[1].min_film_thickness);
  EXPECT_EQ(value(plan, all[0], "ring_3_fmep"), each[2].fmep + each[3].fmep);
  EXPECT_EQ(value(plan, all[0], "ring_3_min_film_thickness"),
            std::min(each[2].min_film_thickness, each[3].min_film_thickness));
  EXPECT_EQ(value(plan, all[0], "fmep"), each[0].fmep + each[1].fmep + each[2].fmep + each[3].fmep);
  EXPECT_GT(value(plan, all[0], "blow_by_flow"), 0);
}

TEST_F(PackStudy, KeepsTheCurvesOfEachRingAndTheirSum) {
  const std::string keep =
      "[keep]\ncurves = \"all\"\nquantities = [\"total_friction\", \"min_film_thickness\"]\n"
      "crank_step = \"4 degree\"\n";
  const study::Plan plan = this->plan("", kCoarse + kGrid + keep);
  std::vector<std::string> names;
  for (const study::KeptCurve& curve : study::kept_curves(plan.study())) names.push_back(curve.quantity.name);
  EXPECT_EQ(names, (std::vector<std::string>{"total_friction", "ring_1_total_friction", "ring_2_total_friction",
                                             "ring_3_total_friction", "ring_1_min_film_thickness",
                                             "ring_2_min_film_thickness", "ring_3_min_film_thickness"}));
  const study::ScenarioRow row = rows(plan).at(0);
  ASSERT_EQ(row.reason, "");
  constexpr std::size_t kAngles = 180;
  ASSERT_EQ(row.curves.size(), names.size() * kAngles);
  const auto curve = [&row](std::size_t i) { return std::span(row.curves).subspan(i * kAngles, kAngles); };
  for (std::size_t k = 0; k < kAngles; ++k) {
    EXPECT_FLOAT_EQ(curve(0)[k], curve(1)[k] + curve(2)[k] + curve(3)[k]);
  }
  for (std::size_t ring = 1; ring <= 3; ++ring) {
    const std::span<const float> film = curve(3 + ring);
    // The value of the cycle is that of the vertex between the steps.
    EXPECT_NEAR(*std::min_element(film.begin(), film.end()) / value(plan, row, names[3 + ring]), 1, 1e-2);
  }
  EXPECT_THAT(refusal("", kCoarse + kGrid + "[keep]\ncurves = \"all\"\nquantities = [\"wetted_begin\"]\n"),
              HasSubstr("wetted_begin is not kept of the rings of a pack"));
}

TEST_F(PackStudy, RefusesKeysThatTheRingsDoNotHave) {
  const auto moving = [&](const std::string& key) {
    return refusal("", "[[factor]]\nkey = \"" + key + "\"\nvalues = [\"0.3 mm\"]\n" + kGrid);
  };
  EXPECT_THAT(moving("ring.4.end_gap"), HasSubstr("its rings are 1 to 3, from the chamber"));
  EXPECT_THAT(moving("ring.end_gap"), HasSubstr("state the ring, from the chamber: ring.1.end_gap"));
  EXPECT_THAT(moving("ring.1.end_gab"), HasSubstr("a case has no key ring.1.end_gab"));
  EXPECT_THAT(refusal("", kGap + kGrid, kSource + "/cases/studies/bases/fired_new_ring.toml"),
              HasSubstr("a case of one ring has no ring.1.end_gap"));
}

TEST_F(PackStudy, RefusesWhatTheGasAloneDoesNotUse) {
  const std::string gas = "compute = \"gas\"\n";
  EXPECT_THAT(refusal(gas, "[[factor]]\nkey = \"ring.1.contact.roughness\"\nvalues = [\"0.3 um\"]\n" + kGrid),
              HasSubstr("which the gas alone does not use"));
  EXPECT_THAT(refusal(gas, kGap + kGrid, kSource + "/cases/studies/bases/fired_new_ring.toml"),
              HasSubstr("gas_path.model is not stated"));
  EXPECT_THAT(refusal(gas, kGap + kGrid + "[keep]\ncurves = \"all\"\n"), HasSubstr("curves are those of films"));
  EXPECT_THAT(refusal("compute = \"oil\"\n", kGap + kGrid), HasSubstr("one of: films, gas"));
}

}  // namespace
}  // namespace ringfilm::io
