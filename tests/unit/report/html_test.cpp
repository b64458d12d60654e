#include "ringfilm/report/html.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <string>

#include "example_document.hpp"
#include "page_data.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/result_document.hpp"

namespace {

using namespace ringfilm;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) ++n;
  return n;
}

report::Overlay overlay() {
  return {.name = "floating liner",
          .quantity = "friction_on_liner",
          .source = "m.csv",
          .crank_angle_deg = {0, 90},
          .value = {-3, 4}};
}

TEST(ReportPage, CarriesEveryQuantityOfTheTables) {
  const json data = example::data_of(report::report_page({example::document("one")}, {}));
  const json& only = data["cases"][0];
  for (const auto& q : cycle::curve_quantities()) {
    ASSERT_TRUE(only["curves"].contains(q.name)) << q.name;
    EXPECT_EQ(only["curves"][q.name].size(), 720u) << q.name;
  }
  for (const auto& q : cycle::cycle_quantities()) EXPECT_TRUE(only["values"].contains(q.name)) << q.name;
  EXPECT_EQ(data["curve_quantities"].size(), cycle::curve_quantities().size());
  EXPECT_EQ(data["curve_quantities"][0]["name"], "crank_angle");
}

TEST(ReportPage, KeepsValuesInSiUnits) {
  const auto document = example::document("one");
  const json data = example::data_of(report::report_page({document}, {}));
  const json& only = data["cases"][0];
  // Curves are written with 7 significant digits: half a unit of the last one is 5e-7 at worst.
  const double film = document.result.samples[20].min_film_thickness;
  EXPECT_NEAR(only["curves"]["min_film_thickness"][20].get<double>(), film, 5e-7 * film);
  EXPECT_EQ(only["values"]["fmep"].get<double>(), document.result.values.fmep);
  EXPECT_EQ(only["provenance"]["commit"], document.provenance.commit);
  EXPECT_EQ(only["provenance"]["kernels"], document.provenance.kernels);
  EXPECT_EQ(only["ledger"][0]["variants"][0]["values"]["fmep"].get<double>(),
            document.ledger[0].variants[0].values.fmep);
  EXPECT_EQ(only["comparison"][0]["published"].get<double>(), 1.41);
  EXPECT_TRUE(only["inputs"][2]["assumed"].get<bool>());
}

TEST(ReportPage, CarriesTheWholeEffortAndEachGridOfTheErrorEstimate) {
  io::ResultDocument document = example::document("a");
  document.result.effort.relaxation_sweeps = 17;
  study::GridRun unsolved{.cells = 800, .crank_step_deg = 0.5, .step_error = 2e-3, .reason = "no film was found"};
  unsolved.cells_y = 90;
  unsolved.solved = false;
  document.errors->runs.push_back(unsolved);
  const auto data = example::data_of(report::report_page({document}, {}));
  const auto& effort = data["cases"][0]["effort"];
  EXPECT_EQ(effort["relaxation_sweeps"], 17);
  EXPECT_EQ(effort.size(), data["effort_quantities"].size());
  const auto& run = data["cases"][0]["errors"]["runs"].back();
  EXPECT_EQ(run["cells"], 800);
  EXPECT_EQ(run["cells_y"], 90);
  EXPECT_EQ(run["crank_step"], 0.5);
  EXPECT_EQ(run["step_error"], 2e-3);
  EXPECT_EQ(run["solved"], false);
  EXPECT_EQ(run["reason"], "no film was found");
}

TEST(ReportPage, HasTheSumOfTheFrictionOfAPack) {
  EXPECT_TRUE(example::data_of(report::report_page({example::document("one")}, {}))["packs"].empty());
  const auto pack = io::pack_document("pack", {example::document("one"), example::document("two", 0.7)});
  const json data = example::data_of(report::report_page({pack, example::document("three")}, {}));
  ASSERT_EQ(data["packs"].size(), 1u);
  EXPECT_EQ(data["packs"][0]["n_rings"], 2);
  const double sum = pack.rings[0].result.values.fmep + pack.rings[1].result.values.fmep;
  EXPECT_NEAR(data["packs"][0]["values"]["fmep"].get<double>(), sum, 1e-12 * sum);
}

TEST(ReportPage, MarksNotesThatAreOnlyForInformation) {
  auto document = example::document("one");
  document.result.notes = {{"synthetic-trace", "a limit", 1}, {"shorter-steps", "of the solver", 3}};
  const json notes = example::data_of(report::report_page({document}, {}))["cases"][0]["notes"];
  EXPECT_FALSE(notes[0]["for_information"].get<bool>());
  EXPECT_TRUE(notes[1]["for_information"].get<bool>());
}

TEST(ReportPage, CarriesNoFieldsOfPacksThatItCompares) {
  const auto pack = [](const char* title) {
    return io::pack_document(title, {example::document("top"), example::document("second", 0.7)});
  };
  const json one = example::data_of(report::report_page({pack("a")}, {}));
  EXPECT_FALSE(one["cases"][0]["fields"]["film_pressure"].empty());
  const std::string page = report::report_page({pack("a"), pack("b")}, {});
  const json both = example::data_of(page);
  for (const json& of_ring : both["cases"]) {
    EXPECT_TRUE(of_ring["fields"]["film_pressure"].empty());
    EXPECT_TRUE(of_ring["fields"]["crank_angle"].empty());
    EXPECT_FALSE(of_ring["fields"]["face_height"].empty());
    EXPECT_FALSE(of_ring["curves"]["total_friction"].empty());
  }
}

TEST(ReportPage, HasOneScriptAndOneDataElementWhateverTheTextsState) {
  const std::size_t harmless = count(report::report_page({example::document("harmless")}, {}), "</script");
  for (const std::string hostile : {"</script><img src=x onerror=alert(1)>", "<!--<script>",
                                    "</title><script>alert(1)</script>", "\"}</SCRIPT >", "{{DATA}} {{TITLE}}"}) {
    auto document = example::document(hostile);
    document.result.notes.push_back({hostile, hostile, 1});
    document.inputs.push_back({hostile, hostile, hostile, true, hostile});
    document.files.push_back({hostile, hostile, hostile});
    document.ledger.front().statement = hostile;
    auto laid = overlay();
    laid.name = laid.source = hostile;
    const std::string page = report::report_page({document}, {laid});
    EXPECT_EQ(count(page, "</script"), harmless) << hostile;
    EXPECT_THAT(page, Not(HasSubstr("</SCRIPT"))) << hostile;
    const json data = example::data_of(page);
    EXPECT_EQ(data["cases"][0]["title"], hostile);
    EXPECT_EQ(data["overlays"][0]["name"], hostile);
  }
}

TEST(ReportPage, EscapesTheTitle) {
  EXPECT_THAT(report::report_page({example::document("a < b & \"c\"")}, {}),
              HasSubstr("<title>a &lt; b &amp; &quot;c&quot;</title>"));
}

TEST(ReportPage, WritesNullForAMissingNumber) {
  auto document = example::document("one");
  document.result.samples[3].rupture_position = kNaN;
  document.result.samples[4].power_loss = std::numeric_limits<double>::infinity();
  document.result.values.fmep = kNaN;
  document.comparison[0].deviation = kNaN;
  const json only = example::data_of(report::report_page({document}, {}))["cases"][0];
  EXPECT_TRUE(only["curves"]["rupture_position"][3].is_null());
  EXPECT_TRUE(only["curves"]["power_loss"][4].is_null());
  EXPECT_TRUE(only["values"]["fmep"].is_null());
  EXPECT_TRUE(only["comparison"][0]["deviation"].is_null());
  EXPECT_TRUE(only["comparison"][1]["with_strongest_setting"].is_null());
}

TEST(ReportPage, ShowsTextsThatAreNoUtf8) {
  const std::string broken = "motor\xff\xc3";
  const std::string page = report::report_page({example::document(broken)}, {});
  EXPECT_THAT(example::data_of(page)["cases"][0]["title"].get<std::string>(), HasSubstr("motor\xEF\xBF\xBD"));
}

TEST(ReportPage, KeepsTheOrderOfTheCases) {
  const json data =
      example::data_of(report::report_page({example::document("b"), example::document("a")}, {overlay()}));
  ASSERT_EQ(data["cases"].size(), 2u);
  EXPECT_EQ(data["cases"][0]["title"], "b");
  EXPECT_EQ(data["cases"][1]["title"], "a");
  EXPECT_EQ(data["overlays"][0]["value"], (json{-3.0, 4.0}));
}

TEST(ReportPage, AcceptsAResultWithoutAnything) {
  io::ResultDocument empty;
  const json only = example::data_of(report::report_page({empty}, {}))["cases"][0];
  EXPECT_TRUE(only["fields"]["crank_angle"].empty());
  EXPECT_TRUE(only["ledger"].empty());
  EXPECT_TRUE(only["curves"]["crank_angle"].empty());
}

TEST(ReportPage, ThinsOutFieldsThatAPageCannotCarry) {
  auto document = example::document("all angles");
  auto& f = document.result.fields;
  const std::size_t n_nodes = f.x.size();
  f.crank_angle_deg.clear();
  for (auto* field : {&f.film_thickness, &f.film_pressure, &f.asperity_pressure, &f.film_content})
    field->assign(720 * n_nodes, 1e-6);
  for (int k = 0; k < 720; ++k) f.crank_angle_deg.push_back(k);
  f.film_thickness[2 * n_nodes] = 7e-6;  // first node of the angle 2 degree
  const json fields = example::data_of(report::report_page({document}, {}))["cases"][0]["fields"];
  EXPECT_EQ(fields["stored_angles"], 720);
  // 60000 numbers of 121 nodes are 495 angles: every second one is kept.
  ASSERT_EQ(fields["crank_angle"].size(), 360u);
  EXPECT_EQ(fields["crank_angle"][1].get<double>(), 2);
  EXPECT_EQ(fields["film_thickness"][1][0].get<double>(), 7e-6);
  EXPECT_EQ(fields["film_thickness"].size(), 360u);
}

TEST(ReportPage, ReportsAtWhichPressureAFilmWithoutFilmContentIsRuptured) {
  auto document = example::document("around");
  example::add_unrolled_film(document, example::CircumferentialGrid::kFields);
  const auto rupture_pressure = [&document](const std::string& cavitation, double pressure) {
    document.inputs = {{"film.cavitation", "", cavitation, false, ""},
                       {"film.cavitation_pressure", "", "", true, "", pressure, "Pa"}};
    return example::data_of(report::report_page({document}, {}))["cases"][0]["unrolled"]["rupture_pressure"];
  };
  EXPECT_EQ(rupture_pressure("reynolds-exit", 5e4).get<double>(), 5e4);
  EXPECT_TRUE(rupture_pressure("mass-conserving", 5e4).is_null());
  EXPECT_TRUE(rupture_pressure("reynolds-exit", std::nan("")).is_null());
}

TEST(ReportPage, CarriesTheUnrolledFilmWithinBounds) {
  auto document = example::document("around");
  EXPECT_TRUE(example::data_of(report::report_page({document}, {}))["cases"][0]["unrolled"].is_null());
  example::add_unrolled_film(document, example::CircumferentialGrid::kFields);
  const std::string page = report::report_page({document}, {});
  const json data = example::data_of(page);
  const json& unrolled = data["cases"][0]["unrolled"];
  EXPECT_EQ(unrolled["stored"]["x"], 121);
  EXPECT_EQ(unrolled["x"].size(), 61u);  // every second one
  EXPECT_EQ(unrolled["y"].size(), document.result.unrolled.y.size());
  EXPECT_EQ(unrolled["crank_angle"].size(), 24u);
  EXPECT_EQ(unrolled["end_gap"].get<double>(), 0.3e-3);
  const std::size_t n_words = 24 * 61 * document.result.unrolled.y.size();
  EXPECT_EQ(unrolled["fields"]["film_content"]["data"].get<std::string>().size(), (2 * n_words + 2) / 3 * 4);
  for (const auto& q : cycle::unrolled_quantities()) {
    EXPECT_EQ(data["cases"][0]["curves"][q.name].size(), 720u) << q.name;
  }
  EXPECT_EQ(data["unrolled_fields"].size(), cycle::unrolled_fields().size());
  // Many more strips, angles and nodes make no larger page than the limits: three fields of 25 x 201 x 81 words.
  auto& f = document.result.unrolled;
  f.x.resize(301);
  f.y.resize(501);
  f.crank_angle_deg.resize(30);
  for (const auto& field : cycle::unrolled_fields()) (f.*field.values).assign(301u * 501 * 30, 1);
  EXPECT_LT(report::report_page({document}, {}).size(), page.size() + 3u * 25 * 201 * 81 * 2 * 4 / 3 + 100000);
}

TEST(ReportPage, NamesNoOutsideAddress) {
  const std::string page = report::report_page({example::document("one")}, {overlay()});
  EXPECT_THAT(page, HasSubstr("default-src 'none'"));
  for (const char* asking :
       {"src=\"http", "href=\"http", "url(http", "@import", "<link rel=\"stylesheet\"", "<script src"}) {
    EXPECT_THAT(page, Not(HasSubstr(asking))) << asking;
  }
}

TEST(ReportPage, IsReproducible) {
  EXPECT_EQ(report::report_page({example::document("one")}, {overlay()}),
            report::report_page({example::document("one")}, {overlay()}));
}

TEST(ReportPage, RefusesOverlaysThatFitNothing) {
  auto unknown = overlay();
  unknown.quantity = "frictoin";
  auto uneven = overlay();
  uneven.value.pop_back();
  try {
    report::report_page({example::document("one")}, {unknown, uneven});
    FAIL() << "an overlay of no known quantity was laid";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 2u);
    EXPECT_THAT(error.faults()[0].message, HasSubstr("frictoin"));
    EXPECT_THAT(error.faults()[1].message, HasSubstr("2 crank angles, but 1 values"));
    EXPECT_EQ(error.faults()[0].mark.file, "m.csv");
  }
}

TEST(ReportPage, RefusesToShowNothing) { EXPECT_THROW(report::report_page({}, {}), InputError); }

}  // namespace
