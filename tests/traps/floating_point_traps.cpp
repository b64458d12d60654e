#include "floating_point_traps.hpp"

#include <fenv.h>
#include <gtest/gtest.h>

namespace ringfilm::traps {
namespace {

constexpr int kTraps = FE_INVALID | FE_DIVBYZERO;

class Traps : public ::testing::Environment {
 public:
  void SetUp() override {
    feclearexcept(FE_ALL_EXCEPT);
    ASSERT_NE(feenableexcept(kTraps), -1);
  }
  void TearDown() override { fedisableexcept(kTraps); }
};

const auto* const kEnvironment = ::testing::AddGlobalTestEnvironment(new Traps);

}  // namespace

NoTraps::NoTraps() : were_on_(fedisableexcept(kTraps)) {}

NoTraps::~NoTraps() {
  feclearexcept(FE_ALL_EXCEPT);
  feenableexcept(were_on_ & kTraps);
}

}  // namespace ringfilm::traps
