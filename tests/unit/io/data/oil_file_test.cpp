#include "ringfilm/io/data/oil_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "../case_example.hpp"

namespace ringfilm::io {
namespace {

std::string refusal(const std::string& density) {
  const ScratchFolder folder;
  write_text(folder / "oil.csv",
             "temperature [degC],pressure [Pa],viscosity [Pa s],density [kg/m3]\n"
             "40,0,0.05,830\n40,1e8,0.2," +
                 density + "\n");
  try {
    read_oil_table({folder / "oil.csv", "oil.csv"}, Units());
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

// The same range as that of lubricant.density.
TEST(OilFile, ADensityOfAnotherUnitIsRefusedWithItsCell) {
  EXPECT_EQ(refusal("850"), "");
  for (const char* density : {"0.83", "8300", "-830", "0"}) {
    EXPECT_THAT(refusal(density), ::testing::HasSubstr("oil.csv:3:")) << density;
    EXPECT_THAT(refusal(density), ::testing::HasSubstr("above 100 to below 5000 kg/m3")) << density;
  }
}

}  // namespace
}  // namespace ringfilm::io
