#include "ringfilm/io/measurement/measurement_json.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "../measurement_example.hpp"

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

TEST(MeasurementJson, ThinsALongCurveToItsLowsAndHighsAndReportsIt) {
  Measurement document = example::measurement();
  MeasuredCurve curve;
  curve.name = "long_profile";
  curve.x_axis = {"x", "place", "m", "mm"};
  curve.y_axis = {"z", "height", "m", "um"};
  curve.series = {{"height", "height", {}}, {"waviness", "waviness", {}}};
  constexpr int kPoints = 100000;
  for (int i = 0; i < kPoints; ++i) {
    curve.x.push_back(1e-6 * i);
    curve.series[0].y.push_back(1e-9 * (i % 7));
    curve.series[1].y.push_back(0);
  }
  curve.series[0].y[70001] = 5e-6;
  curve.series[1].y[31117] = -3e-6;
  document.curves.push_back(curve);
  const json curves = json::parse(measurement_json(document, {}, kProgram)).at("curves");
  const json& few = curves.at("long_profile");
  EXPECT_EQ(few.at("thinned_from"), kPoints);
  const auto x = few.at("x").at("values").get<std::vector<double>>();
  EXPECT_LE(x.size(), 20000U);
  EXPECT_GT(x.size(), 5000U);
  const auto value_at = [&](const char* series, int i) {
    const json& values = few.at("series").at(series).at("values");
    EXPECT_EQ(values.size(), x.size());
    const auto place = std::find(x.begin(), x.end(), curve.x[static_cast<std::size_t>(i)]);
    return place == x.end() ? 0 : values.at(static_cast<std::size_t>(place - x.begin())).get<double>();
  };
  EXPECT_EQ(value_at("height", 70001), 5e-6);
  EXPECT_EQ(value_at("waviness", 31117), -3e-6);
  EXPECT_FALSE(curves.at("spectrum").contains("thinned_from"));
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
