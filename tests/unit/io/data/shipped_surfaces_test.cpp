#include "ringfilm/io/data/shipped_surfaces.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <vector>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

using ::testing::HasSubstr;

const std::string kLiner =
    "[[liner]]\nname = \"honed\"\nstate = \"new\"\nRpq = \"0.15 um\"\nRvq = \"1 um\"\nRmq = 0.8\nhardness = \"2.5 "
    "GPa\"\n"
    "source = \"typical, assumed\"\n";
const std::string kRing =
    "[[ring]]\nname = \"nitrided\"\nstate = \"run-in\"\nroughness = \"0.07 um\"\nsource = \"typical, assumed\"\n";

SurfaceClasses classes_of(const std::string& text) {
  const ScratchFolder folder;
  return read_surfaces({folder.write("surfaces.toml", text), "surfaces.toml"}, Units());
}

std::string refusal(const std::string& text) {
  try {
    classes_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string replaced(std::string text, const std::string& before, const std::string& after) {
  return text.replace(text.find(before), before.size(), after);
}

TEST(ShippedSurfaces, ValuesAreReadInSi) {
  const SurfaceClasses all = classes_of(kLiner + kRing);
  ASSERT_EQ(all.liners.size(), 1u);
  ASSERT_EQ(all.rings.size(), 1u);
  EXPECT_EQ(all.liners[0].name, "honed");
  EXPECT_EQ(all.liners[0].state, "new");
  EXPECT_DOUBLE_EQ(all.liners[0].plateau.Rpq, 0.15e-6);
  EXPECT_DOUBLE_EQ(all.liners[0].plateau.Rvq, 1e-6);
  EXPECT_EQ(all.liners[0].plateau.Rmq, 0.8);
  EXPECT_DOUBLE_EQ(all.liners[0].hardness.value(), 2.5e9);
  EXPECT_FALSE(all.liners[0].youngs_modulus);
  EXPECT_DOUBLE_EQ(all.rings[0].roughness, 0.07e-6);
  EXPECT_EQ(all.sha256.size(), 64u);
}

// By hand, eq-plateau-core at s_2 = 0.8416: Rpq = 1.37 um / 3.519, Rvq = 1.83 um 0.2 / (2 0.1116), Rmq = Phi(0.654).
TEST(ShippedSurfaces, TheLinesOfALinerMayBeThoseOfItsCore) {
  const std::string core = "Rk = \"1.12 um\"\nRpk = \"0.25 um\"\nRvk = \"1.83 um\"\nMr2 = 0.8\n";
  const SurfaceClasses all = classes_of(replaced(kLiner, "Rpq = \"0.15 um\"\nRvq = \"1 um\"\nRmq = 0.8\n", core));
  EXPECT_NEAR(all.liners[0].plateau.Rpq, 0.3893e-6, 2e-10);
  EXPECT_NEAR(all.liners[0].plateau.Rvq, 1.639e-6, 2e-9);
  EXPECT_NEAR(all.liners[0].plateau.Rmq, 0.744, 2e-3);
}

TEST(ShippedSurfaces, EachFaultIsReportedWithItsLine) {
  struct Wrong {
    std::string before, after, message;
  };
  const std::string core = "Rk = \"0.3 um\"\nRpk = \"0.1 um\"\nRvk = \"1.2 um\"\nMr2 = ";
  const std::string lines = "Rpq = \"0.15 um\"\nRvq = \"1 um\"\nRmq = 0.8\n";
  const std::vector<Wrong> all = {
      {"hardness", "hardnes", "surfaces.toml:7:1: unknown key hardnes in [[liner]]; did you mean hardness?"},
      {"\"0.15 um\"", "\"2 um\"", "surfaces.toml:4:7: liner.Rpq = \"2 um\" is not below Rvq"},
      {"\"0.15 um\"", "\"1 um\"", "liner.Rpq = \"1 um\" is not below Rvq"},
      {"\"0.15 um\"", "\"0 um\"", "liner.Rpq = \"0 um\" is not above 0"},
      {"\"0.15 um\"", "0.15", "liner.Rpq = 0.15 has no unit"},
      {"Rvq = \"1 um\"\n", "", "[[liner]] has no Rvq"},
      {"Rmq = 0.8", "Rmq = 80", "surfaces.toml:6:7: liner.Rmq = 80 is not above 0 and below 1"},
      {"Rmq = 0.8", "Rmq = 1", "liner.Rmq = 1 is not above 0 and below 1"},
      {"Rmq = 0.8", "Rmq = 0", "liner.Rmq = 0 is not above 0 and below 1"},
      {"2.5 GPa", "-2.5 GPa", "liner.hardness = \"-2.5 GPa\" is not above 0"},
      {"\"new\"", "\"runin\"", "surfaces.toml:3:9: liner.state = \"runin\" is not known; did you mean run-in?"},
      {"source = \"typical, assumed\"\n", "", "[[liner]] has no source"},
      {"Rmq = 0.8\n", "Rmq = 0.8\nRk = \"0.3 um\"\n", "liner.Rpq is not used with Rk, Rpk, Rvk and Mr2"},
      {lines, core + "0.95\n", "liner.Mr2 = 0.95 is not above 0 and below 0.901"},
      {lines, replaced(core, "1.2 um", "0.1 um") + "0.8\n", "liner.Rvk = \"0.1 um\" is not that of valleys deeper"},
      {lines, replaced(core, "Rvk = \"1.2 um\"\n", "") + "0.8\n", "[[liner]] has no Rvk"},
  };
  for (const Wrong& wrong : all) {
    EXPECT_THAT(refusal(replaced(kLiner, wrong.before, wrong.after)), HasSubstr(wrong.message)) << wrong.after;
  }
  EXPECT_THAT(refusal(replaced(kRing, "roughness = \"0.07 um\"\n", "")), HasSubstr("[[ring]] has no roughness"));
  EXPECT_THAT(refusal(replaced(kRing, "0.07", "-0.07")), HasSubstr("ring.roughness = \"-0.07 um\" is not above 0"));
  EXPECT_THAT(refusal(kRing + "Rpq = \"0.1 um\"\n"), HasSubstr("unknown key Rpq in [[ring]]"));
  EXPECT_THAT(refusal("# nothing\n"), HasSubstr("there is no [[liner]] and no [[ring]]"));
}

TEST(ShippedSurfaces, AllFaultsOfAFileAreReportedTogether) {
  const std::string words = refusal(replaced(kLiner, "Rmq = 0.8", "Rmq = 80") + replaced(kRing, "run-in", "old"));
  EXPECT_THAT(words, HasSubstr("liner.Rmq"));
  EXPECT_THAT(words, HasSubstr("ring.state"));
}

TEST(ShippedSurfaces, ANameComesOnceInEachState) {
  EXPECT_EQ(refusal(kLiner + replaced(kLiner, "\"new\"", "\"worn\"")), "");
  EXPECT_THAT(refusal(kLiner + kLiner), HasSubstr("surfaces.toml:9:"));
  EXPECT_THAT(refusal(kLiner + kLiner), HasSubstr("the liner \"honed\" comes twice as new"));
  EXPECT_THAT(refusal(kRing + kRing), HasSubstr("the ring \"nitrided\" comes twice as run-in"));
}

TEST(ShippedSurfaces, ANameOrAStateThatIsAbsentGetsTheNearestOne) {
  const SurfaceClasses all = classes_of(kLiner + kRing);
  EXPECT_EQ(liner_of_name(all, "honed", "new").name, "honed");
  EXPECT_EQ(ring_of_name(all, "nitrided", "run-in").state, "run-in");
  const auto words = [&](const std::string& name, const std::string& state) {
    try {
      ring_of_name(all, name, state);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(words("nitrted", "run-in"), HasSubstr("no ring is called \"nitrted\"; did you mean nitrided?"));
  EXPECT_THAT(words("nitrided", "runin"), HasSubstr("has no state \"runin\"; did you mean run-in?"));
  EXPECT_THAT(words("nitrided", "worn"), HasSubstr("choose one of run-in"));
  EXPECT_THROW(liner_of_name(all, "nitrided", "run-in"), InputError);
}

TEST(ShippedSurfaces, TheShippedFileHasEachClassOfRingInAllStates) {
  ASSERT_EQ(::setenv("RINGFILM_DATA", RINGFILM_SOURCE_FOLDER, 1), 0);
  const SurfaceClasses all = shipped_surfaces(Units());
  for (const RingSurface& ring : all.rings) {
    for (const char* state : {"new", "run-in", "worn"}) EXPECT_NO_THROW(ring_of_name(all, ring.name, state));
  }
  EXPECT_THAT(surfaces_table(all), HasSubstr("plateau-honed-race-engine"));
  ASSERT_EQ(::unsetenv("RINGFILM_DATA"), 0);
}

}  // namespace
}  // namespace ringfilm::io
