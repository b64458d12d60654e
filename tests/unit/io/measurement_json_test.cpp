#include "ringfilm/io/measurement_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "measurement_example.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::json;

const Provenance kProgram{"ringfilm 0.0.0", "abc", "g++", ""};

TEST(MeasurementJson, HoldsEveryValueInSiByItsName) {
  const Measurement document = example::measurement();
  const json object = json::parse(measurement_json(document, {}, kProgram));
  for (const MeasuredGroup& group : document.groups) {
    for (const MeasuredValue& value : group.values) {
      const json& entry = object.at("values").at(value.name);
      const bool has_value = value.value == value.value;
      EXPECT_EQ(entry.at("value").is_null(), !has_value) << value.name;
      EXPECT_EQ(has_value ? entry.at("value").get<double>() : 0, has_value ? value.value : 0);
      EXPECT_EQ(entry.at("standard_error").is_null(), value.standard_error != value.standard_error) << value.name;
      EXPECT_EQ(entry.at("unit"), value.unit);
      EXPECT_EQ(entry.at("remark"), value.remark);
      EXPECT_EQ(entry.at("group"), group.title);
    }
  }
  EXPECT_EQ(object.at("title"), document.title);
  EXPECT_EQ(object.at("fragment"), document.fragment);
  EXPECT_EQ(object.at("notes").size(), document.notes.size());
  EXPECT_EQ(object.at("commit"), "abc");
}

TEST(MeasurementJson, HoldsTablesAndCurvesWithGapsAsNull) {
  const Measurement document = example::measurement();
  const json object = json::parse(measurement_json(document, {}, kProgram));
  const json& radii = object.at("tables").at("regions").at("columns").at("asperity_radius");
  EXPECT_EQ(radii.at("values").at(0).get<double>(), 5.1e-6);
  EXPECT_TRUE(radii.at("values").at(1).is_null());
  EXPECT_EQ(radii.at("unit"), "m");
  const json& spectrum = object.at("curves").at("spectrum");
  EXPECT_EQ(spectrum.at("x").at("values").get<std::vector<double>>(), document.curves[2].x);
  EXPECT_EQ(spectrum.at("series").at("along").at("values").get<std::vector<double>>(), document.curves[2].series[0].y);
  EXPECT_TRUE(spectrum.at("series").at("across").at("values").at(19).is_null());
  EXPECT_EQ(spectrum.at("marks").at(0).at("x").get<double>(), 4e5);
  EXPECT_EQ(object.at("maps").at("surface_height").at("points_x"), 60);
  EXPECT_FALSE(object.at("maps").at("surface_height").contains("values"));
}

TEST(MeasurementJson, PutsTheNumbersOfTheCallerFirstAndCountsAsCounts) {
  const std::string text = measurement_json(
      example::measurement(), {{"points_x", 512}, {"Sq", 0.41e-6}, {"min", std::numeric_limits<double>::quiet_NaN()}},
      kProgram);
  EXPECT_NE(text.find("\"points_x\": 512,"), std::string::npos);
  const json object = json::parse(text);
  EXPECT_EQ(object.at("Sq").get<double>(), 0.41e-6);
  EXPECT_TRUE(object.at("min").is_null());
  EXPECT_LT(text.find("\"Sq\""), text.find("\"values\""));
}

TEST(MeasurementJson, LetsNoNumberHideAPart) {
  EXPECT_THROW(measurement_json(example::measurement(), {{"values", 1}}, kProgram), std::logic_error);
  EXPECT_THROW(measurement_json(example::measurement(), {{"Sq", 1}, {"Sq", 2}}, kProgram), std::logic_error);
}

TEST(MeasurementJson, TakesTextsOfAnotherEncoding) {
  Measurement document = example::measurement();
  document.sources = {"l\xE4ufer.sur"};
  EXPECT_NO_THROW(json::parse(measurement_json(document, {}, kProgram)));
}

}  // namespace
}  // namespace ringfilm::io
