#include "ringfilm/report/measurement_page.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "measurement_example.hpp"
#include "page_data.hpp"

namespace {

using namespace ringfilm;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

std::string page_of(const io::Measurement& measurement) {
  return report::measurement_page(measurement, io::Units(), {"ringfilm 0.0.0", "abc", "g++", ""});
}

TEST(MeasurementPage, GivesNumbersInTheUnitsThatPeopleRead) {
  const json data = example::data_of(page_of(io::example::measurement()));
  const json& sq = data.at("groups").at(0).at("values").at(1);
  EXPECT_EQ(sq.at("name"), "Sq");
  EXPECT_EQ(sq.at("unit"), "um");
  EXPECT_NEAR(sq.at("value").get<double>(), 0.41234, 1e-12);
  EXPECT_NEAR(sq.at("error").get<double>(), 0.0123, 1e-12);
  EXPECT_TRUE(data.at("groups").at(1).at("values").at(4).at("value").is_null());
  const json& spectrum = data.at("curves").at(2);
  EXPECT_EQ(spectrum.at("x").at("unit"), "mm-1");
  EXPECT_NEAR(spectrum.at("series").at(0).at("x").at(0).get<double>(), 1.1, 1e-6);
  EXPECT_NEAR(spectrum.at("marks").at(0).at("at").get<double>(), 400, 1e-9);
  EXPECT_TRUE(spectrum.at("series").at(1).at("y").at(19).is_null());
  const json& map = data.at("maps").at(0);
  EXPECT_EQ(map.at("unit"), "um");
  EXPECT_NEAR(map.at("highest").at("value").get<double>(), 9.5, 1e-9);
  EXPECT_EQ(map.at("frames").size(), 2u);
  EXPECT_EQ(data.at("fragment"), io::example::measurement().fragment);
}

TEST(MeasurementPage, ReportsWhenALongCurveWasThinned) {
  const json profile = example::data_of(page_of(io::example::measurement())).at("curves").at(0);
  EXPECT_EQ(profile.at("points"), 12000);
  EXPECT_LT(profile.at("drawn").get<int>(), 6000);
  EXPECT_EQ(profile.at("drawn").get<std::size_t>(), profile.at("series").at(0).at("x").size());
}

TEST(MeasurementPage, StaysSmallWithSeveralLargeMapsAndManyCurves) {
  io::Measurement document = io::example::measurement(1500, 1400);
  for (int i = 0; i < 4; ++i) {
    document.maps.push_back(document.maps[0]);
    document.maps.back().name = "map_" + std::to_string(i);
  }
  for (int i = 0; i < 30; ++i) {
    document.curves.push_back(document.curves[0]);
    document.curves.back().name = "curve_" + std::to_string(i);
  }
  EXPECT_LT(page_of(document).size(), 2'500'000u);  // 31 curves of 12,000 points are more than any command draws
  document.curves.resize(8);
  EXPECT_LT(page_of(document).size(), 2'000'000u);
}

TEST(MeasurementPage, LetsNoTextEndItsElement) {
  io::Measurement document = io::example::measurement();
  document.title = document.notes[0] = document.fragment = "</script></title><b>\xE4";
  const std::string page = page_of(document);
  EXPECT_THAT(page, HasSubstr("<title>&lt;/script&gt;"));
  EXPECT_THAT(page, Not(HasSubstr("</title><b>")));
  EXPECT_THAT(example::data_of(page).at("notes").at(0).get<std::string>(), HasSubstr("</script></title><b>"));
}

TEST(MeasurementPage, TakesADocumentWithoutAnyPart) {
  io::Measurement document;
  document.title = "nothing";
  EXPECT_EQ(example::data_of(page_of(document)).at("maps").size(), 0u);
}

}  // namespace
