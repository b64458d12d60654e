#include "ringfilm/report/study_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numeric>

#include "page_data.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/report/payload/payload_study.hpp"
#include "ringfilm/study/statistics/values_of_base.hpp"
#include "study_example.hpp"

namespace {

using namespace ringfilm;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

TEST(StudyPage, ReportsWhatVariedInTheUnitsThatPeopleRead) {
  const json data = example::data_of(example::uncertainty_page());
  EXPECT_EQ(data.at("kind"), "uncertainty");
  EXPECT_EQ(data.at("scenarios"), 64 * 4 * 2);  // rows of A, B and one for each of two groups, for two bases
  EXPECT_EQ(data.at("factors").at(0).at("words"), "normal, mean 2000 rpm, deviation 100 rpm");
  EXPECT_EQ(data.at("factors").at(1).at("words"), "uniform, -10 K to 10 K");
  EXPECT_EQ(data.at("factors").at(2).at("words"), "lognormal, median 1, deviation of the logarithm 0.1");
  EXPECT_EQ(data.at("factors").at(0).at("origin"), "stated");
  EXPECT_EQ(data.at("groups"), json({"speed and warmth", "roughness"}));
  EXPECT_EQ(data.at("correlations").at(0).at("value"), 0.5);
  EXPECT_EQ(data.at("files").at(0).at("sha256").get<std::string>().size(), 64u);
  EXPECT_EQ(data.at("provenance").at("commit"), "abc");
}

TEST(StudyPage, HasStatisticsOfTheSampleAlone) {
  const json data = example::data_of(example::uncertainty_page());
  EXPECT_EQ(data.at("statistics").size(), cycle::cycle_quantities().size());
  const json& film = data.at("statistics").at("min_film_thickness").at(0);
  EXPECT_EQ(film.at("n"), 128);  // A and B of 64 rows
  // 0.5 um at the speed of 200 rad/s, which is 5 % below the mean of 2000 rpm.
  EXPECT_NEAR(film.at("mean").at(0).get<double>(), 0.5e-6 * std::sqrt(209.4 / 200), 0.01e-6);
  EXPECT_LT(film.at("quantiles").at(0).at(0), film.at("quantiles").at(2).at(0));
  const json& counts = data.at("histograms").at("fmep").at("counts").at(1);
  EXPECT_EQ(std::accumulate(counts.begin(), counts.end(), 0, [](int sum, const json& n) { return sum + n.get<int>(); }),
            128);
  const json& stages = data.at("convergence").at("fmep").at(0).at("n");
  EXPECT_EQ(stages, json({16, 32, 64, 128}));
}

TEST(StudyPage, ReportsWhichInputDecides) {
  const json data = example::data_of(example::uncertainty_page());
  const json& indices = data.at("indices").at("min_film_thickness").at(0);
  EXPECT_EQ(indices.at("rows"), 64);
  // The film of the made-up values does not depend on the roughness.
  EXPECT_GT(indices.at("total").at(0).at(0).get<double>(), 0.8);
  EXPECT_LT(indices.at("total").at(1).at(0).get<double>(), 1e-6);
  const json& sensitivities = data.at("sensitivities").at("min_film_thickness").at(0);
  const json& warmth = sensitivities.at("factors").at(1);
  EXPECT_GT(warmth.at(0), sensitivities.at("middle"));
  EXPECT_LT(warmth.at(1), sensitivities.at("middle"));
}

TEST(StudyPage, ComparesBasesAtTheSamePoints) {
  const json data = example::data_of(example::uncertainty_page());
  EXPECT_EQ(data.at("comparison_groups").at(1).at("name"), "worn");
  const json& difference = data.at("comparison").at("min_film_thickness").at(1).at("difference");
  EXPECT_NEAR(difference.at(0).get<double>(), -0.2, 1e-6);
  EXPECT_NEAR(difference.at(2).get<double>() - difference.at(1).get<double>(), 0, 0.01);
}

TEST(StudyPage, HasBandsOfTheCurvesThatWereKept) {
  const json curves = example::data_of(example::uncertainty_page()).at("curves");
  EXPECT_EQ(curves.at("angles").size(), 72u);
  EXPECT_EQ(curves.at("bands").size(), 4u);
  const json& band = curves.at("bands").at(0).at("values");
  EXPECT_LT(band.at(0).at(36), band.at(4).at(36));
  EXPECT_TRUE(example::data_of(example::map_page()).at("curves").is_null());
}

TEST(StudyPage, PutsAGridInItsPlaces) {
  const json data = example::data_of(example::map_page());
  const json& grid = data.at("grid").at("bases").at(1);
  ASSERT_EQ(grid.at("axes").size(), 3u);
  EXPECT_EQ(grid.at("axes").at(0).at("levels").size(), 11u);
  EXPECT_EQ(grid.at("axes").at(1).at("levels").size(), 7u);
  EXPECT_EQ(grid.at("axes").at(2).at("levels").size(), 2u);
  const json& film = grid.at("values").at("min_film_thickness");
  ASSERT_EQ(film.size(), 11u * 7 * 2);
  // The lowest speed and the warmest oil of either law; next to them there is a value.
  EXPECT_TRUE(film.at(6 * 2).is_null());
  EXPECT_TRUE(film.at(6 * 2 + 1).is_null());
  EXPECT_FALSE(film.at(5 * 2).is_null());
  EXPECT_EQ(data.at("unsolved").at("reasons").at(0).at("reason"), "no film balances the load");
  const json& note = data.at("scenario_notes").at(0);
  EXPECT_EQ(note.at("topic"), "shear-rate-high");
  EXPECT_EQ(note.at("scenario"), 0);
  EXPECT_FALSE(note.at("is_worst").get<bool>());
  EXPECT_FALSE(note.at("serious").get<bool>());
  EXPECT_GT(note.at("count"), 10);
  EXPECT_EQ(note.at("counts").at(0).get<int>() + note.at("counts").at(1).get<int>(), note.at("count"));
  EXPECT_FALSE(data.at("has_sample").get<bool>());
  EXPECT_TRUE(data.at("histograms").empty());
}

TEST(StudyPage, DrawsAnEvenSubsetOfManyPoints) {
  const json data = example::data_of(example::uncertainty_page());
  EXPECT_EQ(data.at("stribeck").at("of"), 512);
  EXPECT_EQ(data.at("stribeck").at("scenario").size(), 512u);
  const std::string large =
      "kind = \"map\"\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n[[factor]]\nname = \"speed\"\n"
      "key = \"operating.speed\"\nrange = [\"1000 rpm\", \"6000 rpm\"]\npoints = 300\n[[factor]]\nname = \"warmth\"\n"
      "key = \"operating.oil_temperature\"\nhow = \"add\"\nrange = [\"-20 K\", \"20 K\"]\npoints = 100\n"
      "[plan]\nmethod = \"grid\"\n";
  const std::string page =
      example::study_page(large, [](const std::string&, const study::Point& point) { return *point.values[0]; });
  const json few = example::data_of(page);
  EXPECT_EQ(few.at("stribeck").at("of"), 30000);
  EXPECT_EQ(few.at("stribeck").at("scenario").size(), report::kMaxDrawnPoints);
  const json& axes = few.at("grid").at("bases").at(0).at("axes");
  EXPECT_LE(axes.at(0).at("levels").size() * axes.at(1).at("levels").size(), report::kMaxGridPoints);
  EXPECT_EQ(axes.at(0).at("of"), 300);
  EXPECT_NEAR(axes.at(0).at("levels").back().get<double>(), 6000 * M_PI / 30, 1e-4);
  EXPECT_LT(page.size(), 2'000'000u);
}

const std::string kTwoBases =
    "[[base]]\nname = \"new\"\ncase = \"case.toml\"\n[[base]]\nname = \"worn\"\ncase = \"case.toml\"\n";
const std::string kSpeed = "[[factor]]\nname = \"speed\"\nkey = \"operating.speed\"\n";
const std::string kEvenSpeed = kSpeed + "distribution = \"uniform\"\nlower = \"1000 rpm\"\nupper = \"3000 rpm\"\n";

double speed_of(const std::string&, const study::Point& point) { return point.values[0].value_or(200); }

TEST(StudyPage, DrawsPointsOfEveryBaseAndOfEveryLevel) {
  const json two = example::data_of(example::study_page(
      "kind = \"uncertainty\"\n" + kTwoBases + kEvenSpeed + "[plan]\nmethod = \"sobol\"\nscenarios = 2048\n",
      speed_of));
  const auto of_base = two.at("stribeck").at("base").get<std::vector<int>>();
  EXPECT_EQ(of_base.size(), report::kMaxDrawnPoints);
  EXPECT_EQ(std::count(of_base.begin(), of_base.end(), 1), report::kMaxDrawnPoints / 2);
  const json grid = example::data_of(
      example::study_page("kind = \"map\"\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n" + kSpeed +
                              "range = [\"1000 rpm\", \"6000 rpm\"]\npoints = 2000\n[[factor]]\nname = \"warmth\"\n"
                              "key = \"operating.oil_temperature\"\nhow = \"add\"\nvalues = [\"-20 K\", \"20 K\"]\n"
                              "[plan]\nmethod = \"grid\"\n",
                          speed_of));
  const auto drawn = grid.at("stribeck").at("scenario").get<std::vector<std::uint64_t>>();
  EXPECT_EQ(drawn.size(), report::kMaxDrawnPoints);
  const auto n_warm = std::count_if(drawn.begin(), drawn.end(), [](std::uint64_t i) { return i % 2 == 1; });
  // Half of them, to five deviations of tossing coins.
  EXPECT_NEAR(static_cast<double>(n_warm), 1000, 5 * std::sqrt(500.0));
}

// At 3000 and 4000 rpm the films are full for most of the energy, at 4000 rpm most of it is boundary friction.
TEST(StudyPage, NamesTheRegimeOfEachPointOfTheStribeckCurve) {
  const example::MadeUp made_up = [](const std::string& name, const study::Point& point) {
    const double speed = std::round(*point.values[0] * 30 / M_PI / 1000);
    if (name == "boundary_regime_energy_share") return speed == 1 ? 0.6 : 0.1;
    if (name == "full_film_energy_share") return speed == 1 ? 0.0 : speed == 2 ? 0.4 : 0.7;
    if (name == "mean_boundary_power") return speed == 4 ? 6.0 : 4.0;
    return name == "mean_power_loss" ? 10.0 : speed;
  };
  const json data = example::data_of(example::study_page(
      "kind = \"map\"\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n" + kSpeed +
          "values = [\"1000 rpm\", \"2000 rpm\", \"3000 rpm\", \"4000 rpm\"]\n[plan]\nmethod = \"grid\"\n",
      made_up));
  EXPECT_EQ(data.at("stribeck").at("regime"), (json{"boundary", "mixed", "full film", "mixed"}));
}

TEST(StudyPage, HasTheWeightedMeanAndTheNamesOfOperatingPoints) {
  const json data = example::data_of(example::points_page());
  EXPECT_EQ(data.at("points").at(1), (json{{"name", "part load"}, {"share", 0.625}}));
  const json& fmep = data.at("statistics").at("fmep");
  // (2 x 1000 + 5 x 2000 + 1 x 5000)/8, and 1000 more; to the digits of the page.
  EXPECT_NEAR(fmep.at(0).at("weighted_mean").get<double>(), 2125, 0.01);
  EXPECT_NEAR(fmep.at(1).at("weighted_mean").get<double>(), 3125, 0.01);
  EXPECT_NEAR(data.at("comparison").at("fmep").at(1).at("weighted_mean").get<double>(), 3125, 0.01);
  EXPECT_EQ(data.at("extremes").at("fmep").at(0), (json{{"lowest", "idle"}, {"highest", "full speed"}}));
  EXPECT_NEAR(data.at("point_values").at("fmep").at(1).at(2).get<double>(), 6000, 0.01);
  EXPECT_TRUE(example::data_of(example::map_page()).at("points").empty());
}

TEST(StudyPage, NamesTheScenariosOfTheExtremesOfAGrid) {
  const json extremes = example::data_of(example::map_page()).at("extremes");
  EXPECT_EQ(extremes.at("min_film_thickness").at(0), (json{{"lowest", "speed 1000 rpm, warmth 13.33 K, law roelands"},
                                                           {"highest", "speed 6000 rpm, warmth -20 K, law roelands"}}));
  EXPECT_TRUE(example::data_of(example::uncertainty_page()).at("extremes").empty());
}

TEST(StudyPage, DrawsTheCurvesOfFewScenariosUnderTheirNames) {
  const json curves = example::data_of(example::sweep_page()).at("curves");
  const json& scenarios = curves.at("scenarios");
  EXPECT_EQ(scenarios.at("of"), 9);
  ASSERT_EQ(scenarios.at("list").size(), report::kMaxDrawnCurves);
  EXPECT_EQ(scenarios.at("list").front().at("name"), "speed 1000 rpm");
  EXPECT_EQ(scenarios.at("list").back().at("name"), "speed 5000 rpm");
  for (const json& one : scenarios.at("list")) ASSERT_EQ(one.at("values").size(), 2u);
  // The made-up curve is the film times 2.5 at firing TDC + 180 degree.
  const double highest = scenarios.at("list").back().at("values").at(0).at(18).get<double>();
  EXPECT_NEAR(highest, 2.5e-6 * 5000 * M_PI / 30 / 100, 1e-10);
  EXPECT_TRUE(example::data_of(example::uncertainty_page()).at("curves").at("scenarios").is_null());
}

/// A full grid of ten factors.
json grid_of_ten(int n_bases, const std::string& levels) {
  std::string lines = "kind = \"map\"\n";
  for (int b = 0; b < n_bases; ++b)
    lines.append("[[base]]\nname = \"b").append(std::to_string(b)).append("\"\ncase = \"case.toml\"\n");
  for (const char* key : {"operating.speed", "contact.roughness", "contact.asperity_density", "contact.asperity_radius",
                          "contact.boundary_shear_strength_coefficient", "ring.face_width", "ring.elastic_pressure",
                          "ring.face.crown_height", "engine.stroke", "engine.connecting_rod_length"}) {
    lines.append("[[factor]]\nkey = \"").append(key).append("\"\nhow = \"scale\"\nvalues = ").append(levels);
    lines.append("\n");
  }
  const auto one = [](const std::string&, const study::Point&) { return 1.0; };
  return example::data_of(example::study_page(lines + "[plan]\nmethod = \"grid\"\n", one)).at("grid");
}

TEST(StudyPage, ThinsAGridOfManyFactorsToTwoLevelsOfEachOrLeavesItOut) {
  const json grid = grid_of_ten(1, "[0.9, 1.0, 1.1]");
  std::size_t n = 1;
  for (const json& axis : grid.at("bases").at(0).at("axes")) {
    n *= axis.at("levels").size();
    EXPECT_EQ(axis.at("levels").front(), 0.9);
    EXPECT_EQ(axis.at("levels").back(), 1.1);
  }
  EXPECT_LE(n, report::kMaxGridPoints);
  EXPECT_EQ(n, grid.at("bases").at(0).at("values").at("fmep").size());
  EXPECT_GT(n, report::kMaxGridPoints / 2);  // no more goes than must
  EXPECT_TRUE(grid_of_ten(20, "[0.9, 1.1]").is_null());
}

TEST(StudyPage, ReportsHowAStudyThatWatchesItsStatisticsEnded) {
  const json data = example::data_of(example::study_page(
      "kind = \"uncertainty\"\n" + kTwoBases + kEvenSpeed +
          "[plan]\nmethod = \"sobol\"\nscenarios = 64\nuntil = { value = \"fmep\", width = \"1 kPa\", most = 128 }\n",
      speed_of));
  EXPECT_THAT(data.at("notes").get<std::vector<std::string>>(),
              testing::Contains(HasSubstr("stopped after 64 points")));
}

TEST(StudyPage, ReportsNoConvergenceOfAListThatAnyoneMayHaveSorted) {
  std::string table = "speed [rpm]\n";
  for (int i = 0; i < 40; ++i) table += std::to_string(1000 + 50 * i) + "\n";
  const json data = example::data_of(example::study_page(
      "kind = \"uncertainty\"\n" + kTwoBases + kSpeed + "[plan]\nmethod = \"list\"\nlist = \"points.csv\"\n", speed_of,
      {{"points.csv", table}}));
  EXPECT_TRUE(data.at("convergence").empty());
  EXPECT_THAT(data.at("notes").get<std::vector<std::string>>(), testing::Contains(HasSubstr("drawn at random")));
}

TEST(StudyPage, TakesFirstAndLastOfListedValuesForASensitivity) {
  const json data =
      example::data_of(example::study_page("kind = \"uncertainty\"\n" + kTwoBases + kSpeed +
                                               "values = [\"1000 rpm\", \"2000 rpm\", \"3000 rpm\", \"4000 rpm\"]\n"
                                               "[plan]\nmethod = \"sobol\"\nscenarios = 64\n",
                                           speed_of));
  EXPECT_TRUE(data.at("factors").at(0).at("listed").get<bool>());
  const json& sensitivity = data.at("sensitivities").at("fmep").at(0).at("factors").at(0);
  EXPECT_NEAR(sensitivity.at(0).get<double>(), 1000 * M_PI / 30, 1e-3);
  EXPECT_NEAR(sensitivity.at(1).get<double>(), 4000 * M_PI / 30, 1e-3);
}

TEST(StudyPage, RanksNoFactorThatMovesNothingInABase) {
  const json effects =
      example::data_of(
          example::study_page("kind = \"screening\"\n" + kTwoBases + kSpeed +
                                  "range = [\"1000 rpm\", \"6000 rpm\"]\n[[factor]]\nname = \"roughness\"\n"
                                  "key = \"contact.roughness\"\nhow = \"scale\"\nbases = [\"worn\"]\n"
                                  "range = [0.5, 1.5]\n[plan]\nmethod = \"morris\"\ntrajectories = 10\n",
                              speed_of))
          .at("effects")
          .at("fmep");
  EXPECT_TRUE(effects.at(0).at(1).is_null());
  EXPECT_FALSE(effects.at(1).at(1).is_null());
}

TEST(StudyPage, ComparesNoSinglePointsOfASample) {
  const json data =
      example::data_of(example::study_page("kind = \"uncertainty\"\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n" +
                                               kEvenSpeed + "[plan]\nmethod = \"sobol\"\nscenarios = 16\n",
                                           speed_of));
  EXPECT_TRUE(data.at("comparison_groups").empty());
}

TEST(StudyPage, CountsReasonsByTheirWords) {
  const json unsolved = example::data_of(example::map_page()).at("unsolved");
  EXPECT_EQ(unsolved.at("count"), 4);
  EXPECT_EQ(unsolved.at("n_reasons"), 1);
  EXPECT_FALSE(unsolved.at("reasons").at(0).at("numbers_differ").get<bool>());
}

TEST(StudyPage, RanksFactorsOfAScreening) {
  const json effects = example::data_of(example::screening_page()).at("effects").at("min_film_thickness").at(0);
  ASSERT_EQ(effects.size(), 3u);
  EXPECT_EQ(effects.at(0).at("count"), 10);
  EXPECT_GT(effects.at(0).at("mean_absolute"), effects.at(1).at("mean_absolute"));
  EXPECT_LT(effects.at(1).at("mean"), 0);
  EXPECT_EQ(effects.at(2).at("mean_absolute"), 0);
}

TEST(StudyPage, SetsChoicesOfEveryBaseSideBySide) {
  const json groups = example::data_of(example::comparison_page()).at("comparison_groups");
  ASSERT_EQ(groups.size(), 4u);
  EXPECT_EQ(groups.at(0).at("name"), "new, roelands");
  EXPECT_EQ(groups.at(3).at("name"), "worn, barus");
}

TEST(StudyPage, LetsNoTextEndItsElement) {
  const std::string page = example::uncertainty_page("</script></title><b>");
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("</title><b>")));
  EXPECT_EQ(example::data_of(page).at("title"), "</script></title><b>");
}

}  // namespace
