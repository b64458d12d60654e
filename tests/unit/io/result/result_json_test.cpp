#include "ringfilm/io/result/result_json.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "../result_example.hpp"

namespace ringfilm::io {
namespace {

TEST(ResultJson, HoldsEveryCycleValueByNameWithItsUnit) {
  const ResultDocument document = example_document();
  const auto object = nlohmann::json::parse(result_json(document));
  for (const auto& quantity : cycle::cycle_quantities()) {
    EXPECT_EQ(object.at(quantity.name).get<double>(), document.result.values.*quantity.value) << quantity.name;
    EXPECT_EQ(object.at("units").at(quantity.name), quantity.unit);
  }
  const std::string derived = cycle::derived_quantities().front().name;
  EXPECT_EQ(object.at(derived).get<double>(), document.result.derived.at(derived));
  EXPECT_EQ(object.at("title"), document.title);
  EXPECT_EQ(object.at("assumed").size(), 1u);
  EXPECT_EQ(object.at("notes").size(), 3u);
  EXPECT_EQ(object.at("complete"), true);
}

TEST(ResultJson, NotANumberIsNull) {
  ResultDocument document = example_document();
  document.result.values.fmep = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(nlohmann::json::parse(result_json(document)).at("fmep").is_null());
}

TEST(ResultJson, ErrorsGoByTheNamesOfTheValuesAndReportTheirGrids) {
  ResultDocument document = example_document();
  const auto object = nlohmann::json::parse(result_json(document));
  EXPECT_EQ(object.at("errors").size(), cycle::cycle_quantities().size());
  EXPECT_EQ(object.at("errors").at("fmep").get<double>(), document.errors->values.fmep);
  const auto& estimate = object.at("error_estimate");
  EXPECT_EQ(estimate.at("runs").at(1).at("reason"), "no balance at 12 degree");
  EXPECT_EQ(estimate.at("order_in_cells").at("fmep").get<double>(), document.errors->order_in_cells.fmep);
  EXPECT_TRUE(estimate.at("order_in_step").at("fmep").is_null());  // not observed
  document.errors.reset();
  EXPECT_FALSE(nlohmann::json::parse(result_json(document)).contains("errors"));
}

}  // namespace
}  // namespace ringfilm::io
