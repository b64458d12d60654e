#include "ringfilm/io/result/oil_consumption_json.hpp"

#include <gtest/gtest.h>

#include "../result_example.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_json.hpp"

/// The oil consumption in results.
namespace ringfilm::io {
namespace {

std::vector<cycle::OilLoss> example_losses() {
  return {{"evaporation", "kg/s", 1e-7, 2e-7, 3e-7, "how much renews", "supply.reach"},
          {"total", "kg/s", 1e-7, 2e-7, 3e-7, "all at once"},
          {"fuel_share", "1", 1e-4, 2e-4, 3e-4, "over fuel"}};
}

TEST(OilConsumption, HasEachPartByItsNameWithItsUnit) {
  const nlohmann::ordered_json object = oil_consumption_object(example_losses());
  EXPECT_EQ(object["value"], 2e-7);
  EXPECT_EQ(object["evaporation"]["low"], 1e-7);
  EXPECT_EQ(object["evaporation"]["assumption"], "how much renews");
  EXPECT_EQ(object["fuel_share"]["high"], 3e-4);
  EXPECT_EQ(object["units"]["fuel_share"], "1");
  EXPECT_EQ(object["units"]["low"], "kg/s");
  EXPECT_FALSE(object.contains("total"));
  EXPECT_EQ(object["narrowed_by"][0]["input"], "supply.reach");
  EXPECT_EQ(object["narrowed_by"][0]["band_share"], 1);
  EXPECT_EQ(object["narrowed_by"][0]["high"], 2e-7);
}

TEST(OilConsumption, IsTheSameFromTheFile) {
  ResultDocument ring = example_document();
  ResultDocument pack = pack_document("pack", {example_document(), example_document()});
  for (ResultDocument* document : {&ring, &pack}) {
    document->oil_losses = example_losses();
    const ResultDocument read = result_of_bytes("a result", result_bytes(*document));
    ASSERT_EQ(read.oil_losses.size(), 3U);
    EXPECT_EQ(oil_consumption_object(read.oil_losses), oil_consumption_object(document->oil_losses));
    EXPECT_NE(result_json(*document).find("\"oil_consumption\""), std::string::npos);
  }
}

TEST(OilConsumption, ThatIsNotComputedIsAbsent) {
  const ResultDocument ring = example_document();
  EXPECT_TRUE(result_of_bytes("a result", result_bytes(ring)).oil_losses.empty());
  EXPECT_EQ(result_json(ring).find("\"oil_consumption\""), std::string::npos);
}

}  // namespace
}  // namespace ringfilm::io
