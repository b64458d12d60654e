#include "ringfilm/io/study/study_result.hpp"

#include <gtest/gtest.h>
#include <netcdf.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>

#include "../case_example.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"
#include "ringfilm/io/study/study_netcdf.hpp"

namespace ringfilm::io {
namespace {

/// Four scenarios of made-up values, of which the third is not solved.
class StudyResult : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_.write("case.toml", CaseText{}.text());
    folder_.write("p.csv", full_trace());
    const std::string path = folder_.write(
        "study.toml",
        "[[base]]\ncase = \"case.toml\"\n[[factor]]\nname = \"engine speed\"\nkey = \"operating.speed\"\n"
        "values = [\"1000 rpm\", \"2000 rpm\"]\n[[factor]]\nname = \"law\"\nkey = \"lubricant.viscosity_pressure\"\n"
        "values = [\"roelands\", \"barus\"]\n[plan]\nmethod = \"grid\"\n");
    const StudyFile file = read_study(path);
    const study::Plan plan(file.study);
    const std::size_t n_values = cycle::cycle_quantities().size();
    {
      ShardWriter writer(folder_ / "rows", {"plan", "inputs", "program", 1, 1, 0, 4, n_values});
      study::ScenarioBlock block{0, {}};
      const double none = std::numeric_limits<double>::quiet_NaN();
      for (const double value : {0.0, 1.0, none, 3.0})
        block.rows.push_back({std::vector<double>(n_values, value), std::isnan(value) ? "no \"film\", none" : ""});
      block.rows[1].notes = {{"shear-rate-high", "up to 1e7 1/s", 5}};
      block.rows[3].notes = {{"film-thin", "of 1 nm", 1}, {"shear-rate-high", "up to 2e7 1/s", 2}};
      writer.append(block);
    }
    std::vector<ShardReader> shards;
    shards.emplace_back(folder_ / "rows");
    const StudyRows rows{file, plan, std::move(shards)};
    write_study_result(folder_ / "study.nc", rows);
    write_study_csv(folder_ / "study.csv", rows);
  }

  ScratchFolder folder_;
};

TEST_F(StudyResult, NetCdfHasFactorsAsCoordinatesOfEveryValue) {
  int file = 0, dimension = 0, variable = 0;
  std::size_t length = 0;
  ASSERT_EQ(nc_open((folder_ / "study.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  ASSERT_EQ(nc_inq_dimid(file, "scenario", &dimension), NC_NOERR);
  nc_inq_dimlen(file, dimension, &length);
  EXPECT_EQ(length, 4u);
  for (const auto& quantity : cycle::cycle_quantities()) {
    ASSERT_EQ(nc_inq_varid(file, quantity.name.c_str(), &variable), NC_NOERR) << quantity.name;
    double values[4] = {};
    char coordinates[100] = {}, unit[100] = {};
    nc_get_var_double(file, variable, values);
    EXPECT_EQ(values[1], 1);
    EXPECT_TRUE(std::isnan(values[2]));
    EXPECT_EQ(values[3], 3);
    nc_get_att_text(file, variable, "coordinates", coordinates);
    nc_get_att_text(file, variable, "units", unit);
    EXPECT_STREQ(coordinates, "base factor_engine_speed factor_law");
    EXPECT_EQ(unit, quantity.unit);
  }
  ASSERT_EQ(nc_inq_varid(file, "factor_engine_speed", &variable), NC_NOERR);
  double speeds[4] = {};
  nc_get_var_double(file, variable, speeds);
  EXPECT_NEAR(speeds[1], 1000 * M_PI / 30, 1e-9);
  EXPECT_NEAR(speeds[2], 2000 * M_PI / 30, 1e-9);
  ASSERT_EQ(nc_inq_varid(file, "solved", &variable), NC_NOERR);
  signed char solved[4] = {};
  nc_get_var_schar(file, variable, solved);
  EXPECT_EQ(std::vector<int>(solved, solved + 4), (std::vector<int>{1, 1, 0, 1}));
  ASSERT_EQ(nc_inq_varid(file, "unsolved_reason", &variable), NC_NOERR);
  char* reason = nullptr;
  ASSERT_EQ(nc_get_var_string(file, variable, &reason), NC_NOERR);
  EXPECT_STREQ(reason, "no \"film\", none");
  nc_free_string(1, &reason);
  nc_close(file);
}

TEST_F(StudyResult, FileOnTheDiskEndsWithItsDigest) {
  std::ifstream stream(folder_ / "study.nc", std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  EXPECT_EQ(content_before_trailer("study.nc", bytes).size(), bytes.size() - kDigestTrailerSize);
}

TEST_F(StudyResult, NetCdfHasTheNotesOfEveryResult) {
  int file = 0, variable = 0;
  ASSERT_EQ(nc_open((folder_ / "study.nc").c_str(), NC_NOWRITE, &file), NC_NOERR);
  const auto texts = [&](const char* name) {
    EXPECT_EQ(nc_inq_varid(file, name, &variable), NC_NOERR) << name;
    char* both[2] = {};
    nc_get_var_string(file, variable, both);
    std::vector<std::string> found = {both[0], both[1]};
    nc_free_string(2, both);
    return found;
  };
  EXPECT_EQ(texts("note_topic"), (std::vector<std::string>{"shear-rate-high", "film-thin"}));
  EXPECT_EQ(texts("note_message"), (std::vector<std::string>{"up to 1e7 1/s", "of 1 nm"}));
  int numbers[2] = {};
  ASSERT_EQ(nc_inq_varid(file, "note_scenario", &variable), NC_NOERR);
  nc_get_var_int(file, variable, numbers);
  EXPECT_EQ(std::vector<int>(numbers, numbers + 2), (std::vector<int>{1, 3}));
  ASSERT_EQ(nc_inq_varid(file, "note_count", &variable), NC_NOERR);
  nc_get_var_int(file, variable, numbers);
  EXPECT_EQ(std::vector<int>(numbers, numbers + 2), (std::vector<int>{2, 1}));
  ASSERT_EQ(nc_inq_varid(file, "has_note", &variable), NC_NOERR);
  signed char carries[8] = {};
  nc_get_var_schar(file, variable, carries);
  EXPECT_EQ(std::vector<int>(carries, carries + 8), (std::vector<int>{0, 0, 1, 0, 0, 0, 1, 1}));
  nc_close(file);
}

/// Scenarios of bases a, b, a, b, ... of which all but the first carry a note on a film of so many nanometres.
StudyRows rows_of_two_bases(const ScratchFolder& folder, const StudyFile& file, const study::Plan& plan,
                            const std::vector<double>& films) {
  const auto& quantities = cycle::cycle_quantities();
  study::ScenarioBlock block{0, {}};
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    study::ScenarioRow row{std::vector<double>(quantities.size(), 1), ""};
    row.values[*cycle::cycle_quantity_index("min_film_thickness")] = films[i];
    row.base = plan.base_of(i);
    const std::string words = std::to_string(films[i]);
    row.notes = {{"film-below-molecules", words, 1}, {"shear-rate-high", words, 1}};
    if (i == 0) row.notes.clear();
    block.rows.push_back(row);
  }
  ShardWriter(folder / "two", {"plan", "inputs", "program", 1, 1, 0, plan.size(), quantities.size()}).append(block);
  std::vector<ShardReader> shards;
  shards.emplace_back(folder / "two");
  return {file, plan, std::move(shards)};
}

TEST_F(StudyResult, NotesOfABaseHaveTheFiguresOfItsWorstElseOfItsFirstScenario) {
  const StudyFile file = read_study(
      folder_.write("two.toml",
                    "[[base]]\nname = \"a\"\ncase = \"case.toml\"\n[[base]]\nname = \"b\"\ncase = \"case.toml\"\n"
                    "[[factor]]\nkey = \"operating.speed\"\nvalues = [\"1000 rpm\", \"2000 rpm\", \"3000 rpm\"]\n"
                    "[plan]\nmethod = \"grid\"\n"));
  const study::Plan plan(file.study);
  ASSERT_EQ(plan.size(), 6u);
  const std::vector<double> films = {1, 8, 7, 6, 3, 5};
  const StudyRows rows = rows_of_two_bases(folder_, file, plan, films);
  ASSERT_EQ(rows.scenario_notes().size(), 2u);
  EXPECT_EQ(rows.scenario_notes()[0].topic, "film-below-molecules") << "the most serious first";
  for (std::size_t b = 0; b < 2; ++b) {
    std::vector<std::uint64_t> carriers;
    for (std::uint64_t i = 1; i < plan.size(); ++i) {
      if (plan.base_of(i) == b) carriers.push_back(i);
    }
    const auto worst = *std::min_element(carriers.begin(), carriers.end(),
                                         [&](std::uint64_t i, std::uint64_t k) { return films[i] < films[k]; });
    const auto& thin = rows.scenario_notes()[0].bases[b];
    const auto& shear = rows.scenario_notes()[1].bases[b];
    EXPECT_EQ(thin.count, carriers.size());
    EXPECT_EQ(thin.shown->scenario, worst);
    EXPECT_EQ(thin.shown->message, std::to_string(films[worst]));
    EXPECT_EQ(shear.count, carriers.size());
    EXPECT_EQ(shear.shown->scenario, carriers.front());
    EXPECT_EQ(shear.shown->message, std::to_string(films[carriers.front()]));
    EXPECT_FALSE(shear.shown->badness);
  }
  EXPECT_EQ(rows.scenario_notes()[0].shown().scenario, 4u);
  EXPECT_EQ(rows.scenario_notes()[0].count(), 5u);
}

TEST_F(StudyResult, NotesWithoutAFiniteValueAreNotTheWorst) {
  const StudyFile file = read_study(
      folder_.write("three.toml",
                    "[[base]]\nname = \"a\"\ncase = \"case.toml\"\n"
                    "[[factor]]\nkey = \"operating.speed\"\nvalues = [\"1000 rpm\", \"2000 rpm\", \"3000 rpm\"]\n"
                    "[plan]\nmethod = \"grid\"\n"));
  const study::Plan plan(file.study);
  const double infinity = std::numeric_limits<double>::infinity();
  const StudyRows rows = rows_of_two_bases(folder_, file, plan, {1, -infinity, 7});
  EXPECT_EQ(rows.scenario_notes()[0].shown().scenario, 2u);
}

TEST_F(StudyResult, CsvHasTheTopicsOfNotes) {
  std::ifstream csv(folder_ / "study.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_TRUE(lines[0].ends_with(",reason,notes"));
  EXPECT_TRUE(lines[1].ends_with(",,"));
  EXPECT_TRUE(lines[2].ends_with(",,\"shear-rate-high\""));
  EXPECT_TRUE(lines[4].ends_with(",,\"shear-rate-high; film-thin\""));
}

TEST_F(StudyResult, CsvHasTheWordsOfChoicesAndReasons) {
  std::ifstream csv(folder_ / "study.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(csv, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_EQ(lines[0].rfind("scenario,base,factor_engine_speed [rad/s],factor_law,energy_per_cycle [J],", 0), 0u);
  EXPECT_NE(lines[2].find(",\"barus\",1,1,"), std::string::npos);
  EXPECT_NE(lines[3].find(",\"roelands\",nan,nan,"), std::string::npos);
  EXPECT_NE(lines[3].find(",\"no \"\"film\"\", none\""), std::string::npos);
}

TEST(FactorVariables, AreNeverAlike) {
  study::Study study;
  study.factors.resize(3);
  study.factors[0].name = "a b";
  study.factors[1].name = "a-b";
  study.factors[2].name = "c";
  EXPECT_EQ(factor_variables(study), (std::vector<std::string>{"factor_a_b", "factor_a_b_2", "factor_c"}));
}

TEST(FactorVariables, LeaveSpaceForTheTextsOfChoices) {
  study::Study study;
  study.factors.resize(4);
  const std::vector<std::string> names = {"oil", "oil choice", "law choice", "law"};
  for (std::size_t i = 0; i < names.size(); ++i) study.factors[i].name = names[i];
  study.factors[0].variation = study.factors[3].variation = study::Choices{};
  EXPECT_EQ(factor_variables(study),
            (std::vector<std::string>{"factor_oil", "factor_oil_choice_2", "factor_law_choice", "factor_law_4"}));
  study.factors[0].name = std::string(1000, 'a');
  EXPECT_LT(factor_variables(study)[0].size(), 240u) << "NetCDF takes 256 with the end of a choice";
}

}  // namespace
}  // namespace ringfilm::io
