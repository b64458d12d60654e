#include "ringfilm/io/study/study_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "../case_example.hpp"
#include "ringfilm/study/design/plan.hpp"
#include "ringfilm/study/design/scenario.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

const std::string kPlan = "[plan]\nmethod = \"sobol\"\nscenarios = 8\n";

/// A study beside a case; tests put their own words between.
class StudyFolder {
 public:
  explicit StudyFolder(const CaseText& text = {}) {
    folder_.write("case.toml", text.text());
    folder_.write("p.csv", full_trace());
  }

  const ScratchFolder& folder() const { return folder_; }

  StudyFile read(const std::string& factors, const std::string& plan = kPlan) const {
    return read_study(folder_.write(
        "study.toml",
        "title = \"a study\"\nseed = 3\n[[base]]\nname = \"new\"\ncase = \"case.toml\"\n" + factors + plan));
  }

  /// What is stated of a study that is refused.
  std::string refusal(const std::string& factors, const std::string& plan = kPlan) const {
    try {
      study::Plan(read(factors, plan).study);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  }

 private:
  ScratchFolder folder_;
};

const std::string kSpeed = "[[factor]]\nname = \"speed\"\nkey = \"operating.speed\"\n";

TEST(StudyFile, GivesEveryNumberInSi) {
  const study::Study study =
      StudyFolder()
          .read(kSpeed +
                "values = [\"60 rpm\", \"120 rpm\"]\n"
                "[[factor]]\nkey = \"contact.roughness\"\ndistribution = \"normal\"\n"
                "mean = \"0.5 um\"\nrelative_deviation = 0.1\ntruncate = [\"0.1 um\", \"1 um\"]\n")
          .study;
  EXPECT_EQ(study.seed, 3u);
  EXPECT_EQ(study.title, "a study");
  ASSERT_EQ(study.factors.size(), 2u);
  const auto& speeds = std::get<study::Levels>(study.factors[0].variation).values;
  ASSERT_EQ(speeds.size(), 2u);
  EXPECT_NEAR(speeds[1], 4 * M_PI, 1e-12);  // 2 turns a second
  EXPECT_EQ(study.factors[1].name, "contact.roughness");
  const auto& d = std::get<study::Distribution>(study.factors[1].variation);
  EXPECT_DOUBLE_EQ(d.mean, 0.5e-6);
  EXPECT_DOUBLE_EQ(d.deviation, 0.05e-6);
  EXPECT_DOUBLE_EQ(d.lowest.value(), 0.1e-6);
  EXPECT_DOUBLE_EQ(d.highest.value(), 1e-6);
}

TEST(StudyFile, ADifferenceOfTemperaturesIsNone) {
  const study::Study study = StudyFolder()
                                 .read(
                                     "[[factor]]\nkey = \"operating.oil_temperature\"\nhow = \"add\"\n"
                                     "values = [\"0 degC\", \"5 degC\", \"5 K\", \"9 degF\"]\n")
                                 .study;
  const auto& warmer = std::get<study::Levels>(study.factors[0].variation).values;
  ASSERT_EQ(warmer.size(), 4u);
  EXPECT_EQ(warmer[0], 0);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_NEAR(warmer[i], 5, 1e-9) << i;
}

TEST(StudyFile, PutsTheContentOfAFileIntoScenarios) {
  const StudyFolder folder;
  const StudyFile file =
      folder.read("[[factor]]\nname = \"gas\"\nkey = \"gas.cylinder_pressure\"\nvalues = [\"p.csv\"]\n",
                  "[plan]\nmethod = \"grid\"\n");
  const study::Plan plan(file.study);
  const cycle::Case c = study::scenario_case(plan.study(), plan.point(0));
  EXPECT_EQ(c.gas.cylinder_pressure->value, file.study.bases[0].input.gas.cylinder_pressure->value);
  // The study, its case and its trace, each reported once.
  EXPECT_EQ(file.files.size(), 3u);
}

// The file of an oil brings the whole table; what is chosen or set beside it must be in the scenario all the same,
// whatever the order of the factors.
TEST(StudyFile, AFileThatIsChosenUndoesNoOtherFactor) {
  CaseText text;
  text.lubricant = "[lubricant]\nfile = \"a.toml\"\n";
  const StudyFolder folder(text);
  const std::string oil =
      "name = \"NAME\"\nkinematic_viscosity = [{ temperature = \"40 degC\", value = \"50 mm2/s\" }, "
      "{ temperature = \"100 degC\", value = \"8 mm2/s\" }]\n"
      "density = [{ temperature = \"15 degC\", value = \"850 kg/m3\" }]\n";
  folder.folder().write("a.toml", oil);
  folder.folder().write("b.toml", oil);
  const std::string file = "[[factor]]\nname = \"oil\"\nkey = \"lubricant.file\"\nvalues = [\"a.toml\", \"b.toml\"]\n";
  const std::string gas = "[[factor]]\nname = \"gas\"\nkey = \"gas.cylinder_pressure\"\nvalues = [\"p.csv\"]\n";
  const std::string law =
      "[[factor]]\nname = \"law\"\nkey = \"lubricant.viscosity_pressure\"\nvalues = [\"roelands\", \"barus\"]\n";
  const std::string alpha =
      "[[factor]]\nname = \"alpha\"\nkey = \"lubricant.pressure_viscosity_coefficient\"\nvalues = [\"2e-8 1/Pa\"]\n";
  for (const std::string& factors : {file + law + alpha + gas, gas + alpha + law + file}) {
    const study::Plan plan(folder.read(factors, "[plan]\nmethod = \"grid\"\n").study);
    std::set<std::pair<std::string, int>> seen;
    for (std::uint64_t i = 0; i < plan.size(); ++i) {
      const cycle::Case c = study::scenario_case(plan.study(), plan.point(i));
      EXPECT_EQ(c.lubricant.law_parameters.at("pressure_viscosity_coefficient"), 2e-8);
      EXPECT_TRUE(c.stated.contains("lubricant.viscosity_pressure"));
      EXPECT_TRUE(c.stated.contains("gas.cylinder_pressure"));
      seen.insert({c.lubricant.file.value(), static_cast<int>(c.lubricant.viscosity_pressure)});
      std::size_t n_oils = 0;
      for (const cycle::InputFile& input : c.files) n_oils += input.role.rfind("lubricant", 0) == 0;
      EXPECT_EQ(n_oils, 1u) << "the file of another scenario or of none is reported";
    }
    EXPECT_EQ(seen.size(), 4u);
  }
}

/// The highest pressure of the trace in each scenario [bar].
std::vector<double> peaks_of_scenarios(const StudyFolder& folder, const std::string& factors) {
  const study::Plan plan(folder.read(factors, "[plan]\nmethod = \"grid\"\n").study);
  std::vector<double> peaks;
  for (std::uint64_t i = 0; i < plan.size(); ++i) {
    const cycle::Case c = study::scenario_case(plan.study(), plan.point(i));
    const auto& p = c.gas.cylinder_pressure->value;
    peaks.push_back(std::round(*std::max_element(p.begin(), p.end()) / 1e5));
  }
  return peaks;
}

/// A cycle of 720 degree with a column for each peak.
std::string trace_of_columns(const std::vector<std::pair<std::string, double>>& columns) {
  std::string text = "crank_angle [degree]";
  for (const auto& [header, peak] : columns) text += "," + header;
  for (int angle = 0; angle < 720; angle += 5) {
    text += "\n" + std::to_string(angle);
    for (const auto& [header, peak] : columns) text += "," + std::to_string(angle == 15 ? peak : 1.0);
  }
  return text + "\n";
}

TEST(StudyFile, AColumnThatIsChosenIsReadFromTheTrace) {
  CaseText text;
  text.gas += "pressure_column = \"low\"\n";
  const StudyFolder folder(text);
  folder.folder().write("p.csv", trace_of_columns({{"low [bar]", 20}, {"high [bar]", 80}}));
  folder.folder().write("q.csv", trace_of_columns({{"high [bar]", 90}, {"low [bar]", 30}, {"only_here [bar]", 40}}));
  const auto column = [](const std::string& values) {
    return "[[factor]]\nkey = \"gas.pressure_column\"\nvalues = [" + values + "]\n";
  };
  EXPECT_THAT(peaks_of_scenarios(folder, column("\"low\", \"high\"")), ::testing::ElementsAre(20, 80));
  const std::string file = "[[factor]]\nkey = \"gas.cylinder_pressure\"\nvalues = [\"p.csv\", \"q.csv\"]\n";
  for (const bool file_first : {false, true}) {
    const std::string columns = column("\"low\", \"high\"");
    EXPECT_THAT(peaks_of_scenarios(folder, file_first ? file + columns : columns + file),
                ::testing::UnorderedElementsAre(20, 80, 30, 90))
        << "a column is that of the file beside which it is chosen";
  }
  EXPECT_THAT(folder.refusal(column("\"low\", \"nonsense\"")),
              ::testing::AllOf(HasSubstr("the file has no column nonsense (gas.pressure_column)"), HasSubstr("p.csv")));
  // In one of the two files only: the study runs, and the scenarios of the other have their reason.
  const study::Plan plan(folder.read(file + column("\"only_here\""), "[plan]\nmethod = \"grid\"\n").study);
  EXPECT_THROW(study::scenario_case(plan.study(), plan.point(0)), InputError);
  EXPECT_NO_THROW(study::scenario_case(plan.study(), plan.point(1)));
}

/// A factor with the texts PREFIX0, PREFIX1, ...
std::string many_texts(const std::string& key, const std::string& prefix, const std::string& ending, int n) {
  std::string text = "[[factor]]\nname = \"" + prefix + "\"\nkey = \"" + key + "\"\nvalues = [";
  for (int i = 0; i < n; ++i) text += (i == 0 ? "\"" : ", \"") + prefix + std::to_string(i) + ending + "\"";
  return text + "]\n";
}

TEST(StudyFile, ReadsTheCombinationsOfTextsThatThePlanUses) {
  CaseText text;
  text.gas += "pressure_column = \"c0\"\n";
  const StudyFolder folder(text);
  folder.folder().write("p.csv", trace_of_columns({{"c0 [bar]", 20}, {"c1 [bar]", 80}}));
  folder.folder().write("f7.csv", trace_of_columns({{"c0 [bar]", 27}, {"c1 [bar]", 87}}));
  // There is no file but f7.csv, and no column but c0 and c1: a file that is read although the plan leaves it out is
  // refused.
  const std::string both =
      many_texts("gas.cylinder_pressure", "f", ".csv", 150) + many_texts("gas.pressure_column", "c", "", 100);
  const std::string refusal = folder.refusal(both, "[plan]\nmethod = \"grid\"\n");
  EXPECT_THAT(refusal, HasSubstr("the plan uses more than 10000 combinations of the texts of [gas]"));
  EXPECT_THAT(refusal, ::testing::Not(HasSubstr("no such file")));
  folder.folder().write("plan.csv", "c,f\n0,7\n1,7\n");
  const StudyFile listed = folder.read(both, "[plan]\nmethod = \"list\"\nlist = \"plan.csv\"\n");
  const study::Plan plan(listed.study);
  EXPECT_EQ(study::scenario_case(plan.study(), plan.point(0)).gas.cylinder_pressure->value[3], 27e5);
  EXPECT_EQ(study::scenario_case(plan.study(), plan.point(1)).gas.cylinder_pressure->value[3], 87e5);
  const std::string few = "[[factor]]\nkey = \"gas.cylinder_pressure\"\nvalues = [\"p.csv\", \"f7.csv\"]\n" +
                          many_texts("gas.pressure_column", "c", "", 2);
  const study::Plan single(folder.read(few, "[plan]\nmethod = \"one-at-a-time\"\n").study);
  std::set<double> peaks;
  for (std::uint64_t i = 0; i < single.size(); ++i)
    peaks.insert(study::scenario_case(single.study(), single.point(i)).gas.cylinder_pressure->value[3] / 1e5);
  EXPECT_THAT(peaks, ::testing::ElementsAre(20, 27, 80)) << "the column c1 of f7.csv is not used";
}

TEST(StudyFile, ReadsNoMoreCombinationsThanThePlanHasPoints) {
  CaseText text;
  text.gas += "pressure_column = \"c0\"\nangle_column = \"a0\"\n";
  const StudyFolder folder(text);
  std::string rows = "a0 [degree]";
  for (int i = 0; i < 30; ++i) rows += ",a" + std::to_string(i + 1) + " [degree],c" + std::to_string(i) + " [bar]";
  for (int angle = 0; angle < 720; angle += 5) {
    rows += "\n" + std::to_string(angle);
    for (int i = 0; i < 30; ++i) rows += "," + std::to_string(angle) + "," + std::to_string(20 + i);
  }
  folder.folder().write("p.csv", rows + "\n");
  for (int i = 0; i < 30; ++i) folder.folder().write("f" + std::to_string(i) + ".csv", rows + "\n");
  const std::string all = many_texts("gas.cylinder_pressure", "f", ".csv", 30) +
                          many_texts("gas.pressure_column", "c", "", 30) + many_texts("gas.angle_column", "a", "", 30);
  for (const char* plan_text :
       {"[plan]\nmethod = \"sobol\"\nscenarios = 16\n", "[plan]\nmethod = \"latin-hypercube\"\nscenarios = 16\n",
        "[plan]\nmethod = \"morris\"\ntrajectories = 4\n",
        "[plan]\nmethod = \"sobol\"\nscenarios = 16\n"
        "until = { value = \"fmep\", width = \"1 Pa\", most = 64 }\n"}) {
    const study::Plan plan(folder.read(all, plan_text).study);
    for (std::uint64_t i = 0; i < plan.most(); ++i) {
      const auto column = *plan.point(i).values.at(1);
      EXPECT_EQ(study::scenario_case(plan.study(), plan.point(i)).gas.cylinder_pressure->value[3], (20 + column) * 1e5);
    }
  }
  EXPECT_THAT(folder.refusal(all, "[plan]\nmethod = \"sobol\"\nscenarios = 100000\n"),
              HasSubstr("the plan uses more than 10000 combinations of the texts of [gas]"));
}

TEST(StudyFile, AUnitThatIsChosenScalesTheTrace) {
  CaseText text;
  text.gas += "pressure_unit = \"bar\"\n";
  const StudyFolder folder(text);
  folder.folder().write("p.csv", trace_of_columns({{"pressure", 20}}));
  EXPECT_THAT(peaks_of_scenarios(folder, "[[factor]]\nkey = \"gas.pressure_unit\"\nvalues = [\"bar\", \"atm\"]\n"),
              ::testing::ElementsAre(20, std::round(20 * 1.01325)));
  EXPECT_THAT(folder.refusal("[[factor]]\nkey = \"gas.pressure_unit\"\nvalues = [\"bar\", \"N\"]\n"),
              HasSubstr("the column pressure"));
}

TEST(StudyFile, TakesAListWithItsUnitsInAnyOrder) {
  const StudyFolder folder;
  folder.folder().write("plan.csv", "roughness [um],speed [rpm]\n0.5,60\n0.25,120\n");
  const study::Study study = folder
                                 .read(kSpeed + "[[factor]]\nname = \"roughness\"\nkey = \"contact.roughness\"\n",
                                       "[plan]\nmethod = \"list\"\nlist = \"plan.csv\"\n")
                                 .study;
  ASSERT_EQ(study.sampling.list.size(), 2u);
  EXPECT_NEAR(study.sampling.list[1][0], 4 * M_PI, 1e-12);
  EXPECT_DOUBLE_EQ(study.sampling.list[1][1], 0.25e-6);
}

TEST(StudyFile, ReportsWhereAFaultLiesAndWhatMayBeMeant) {
  const StudyFolder folder;
  EXPECT_THAT(folder.refusal("[[factor]]\nkey = \"operating.sped\"\nvalues = [\"60 rpm\"]\n"),
              ::testing::AllOf(HasSubstr("study.toml:7:"), HasSubstr("did you mean operating.speed?")));
  EXPECT_THAT(folder.refusal(kSpeed + "values = [60]\n"), HasSubstr("has no unit"));
  EXPECT_THAT(folder.refusal(kSpeed + "values = [\"60 N\"]\n"), HasSubstr("study.toml:9:"));
  EXPECT_THAT(folder.refusal(kSpeed + "values = [\"60 rpm\"]\nrange = [\"1 rpm\", \"2 rpm\"]\n"),
              HasSubstr("both values and range"));
  EXPECT_THAT(folder.refusal(kSpeed + "values = [\"60 rpm\"]\nmean = \"60 rpm\"\n"), HasSubstr("means nothing"));
  EXPECT_THAT(folder.refusal(kSpeed + "distribution = \"normal\"\nmean = \"60 rpm\"\n"),
              HasSubstr("requires deviation"));
  EXPECT_THAT(folder.refusal(kSpeed + "distribution = \"normal\"\nmean = \"60 rpm\"\ndeviation = \"-1 rpm\"\n"),
              HasSubstr("standard deviation"));
  EXPECT_THAT(folder.refusal(kSpeed + "values = [\"60 rpm\"]\nbases = [\"nw\"]\n"), HasSubstr("did you mean new?"));
  EXPECT_THAT(
      folder.refusal(kSpeed + "values = [\"60 rpm\"]\n[[correlation]]\nfactors = [\"speed\", \"sped\"]\nvalue = 1\n"),
      HasSubstr("did you mean speed?"));
  EXPECT_THAT(folder.refusal("[[measured]]\n"), HasSubstr("states no scatter"));
  EXPECT_THAT(folder.refusal("", ""), HasSubstr("no plan"));
}

TEST(StudyFile, RefusesKeysOfThePlanThatNobodyReads) {
  const StudyFolder folder;
  folder.folder().write("plan.csv", "speed [rpm],note\n60,1\n120,2\n");
  const std::string values = kSpeed + "values = [\"60 rpm\", \"120 rpm\"]\n";
  const auto plan = [](const std::string& method, const std::string& key) {
    return "[plan]\nmethod = \"" + method + "\"\n" + key + "\n";
  };
  for (const auto& [method, key] : std::vector<std::pair<std::string, std::string>>{{"grid", "scenarios = 8"},
                                                                                    {"one-at-a-time", "scenarios = 8"},
                                                                                    {"morris", "scenarios = 8"},
                                                                                    {"sobol", "trajectories = 8"},
                                                                                    {"grid", "levels = 4"},
                                                                                    {"sobol", "list = \"plan.csv\""}}) {
    EXPECT_THAT(folder.refusal(values, plan(method, key)),
                ::testing::AllOf(HasSubstr("study.toml:12:1"), HasSubstr("means nothing with method = \"" + method)));
  }
  EXPECT_EQ(folder.refusal(values, plan("morris", "trajectories = 8\nlevels = 4")), "");
  EXPECT_THAT(folder.refusal(kSpeed, plan("list", "list = \"plan.csv\"")),
              ::testing::AllOf(HasSubstr("plan.csv:1:"), HasSubstr("the column note is of no factor")));
}

TEST(StudyFile, ReportsAWidthAsItIsWrittenAndCountsWhatIsWhole) {
  const StudyFolder folder;
  const auto until = [&](const std::string& width, const std::string& most) {
    return folder.refusal(kSpeed + "range = [\"60 rpm\", \"120 rpm\"]\n",
                          kPlan + "until = { value = \"fmep\", width = " + width + ", most = " + most + " }\n");
  };
  EXPECT_EQ(until("\"2 kPa\"", "1e3"), "");
  EXPECT_THAT(until("\"-2 kPa\"", "1000"), ::testing::AllOf(HasSubstr("study.toml:13:"), HasSubstr("\"-2 kPa\"")));
  EXPECT_THAT(until("\"2 kPa\"", "4"),
              ::testing::AllOf(HasSubstr("study.toml:13:"), HasSubstr("below plan.scenarios")));
  EXPECT_THAT(until("\"2 kPa\"", "1000.5"), HasSubstr("is not a whole number"));
}

TEST(StudyFile, RefusesEveryValueOfTheWrongKind) {
  const StudyFolder folder;
  const std::string base = "[[base]]\ncase = \"case.toml\"\n";
  const std::vector<std::string> texts = {"base = 1\n",
                                          "[base]\n",
                                          "[[base]]\ncase = 3\n",
                                          "factor = [1, \"a\"]\n" + base,
                                          base + "[[factor]]\nkey = []\n",
                                          base + "[[factor]]\nkeys = \"a\"\n",
                                          base + "[[factor]]\n",
                                          "plan = 3\n" + base,
                                          "keep = []\n" + base + kPlan};
  for (const std::string& text : texts)
    EXPECT_THROW(read_study(folder.folder().write("hostile.toml", text)), InputError) << text;
}

}  // namespace
}  // namespace ringfilm::io
