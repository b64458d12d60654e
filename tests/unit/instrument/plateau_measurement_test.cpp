#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"
#include "ringfilm/surface/contact/contact_law.hpp"
#include "ringfilm/surface/synthetic/target_surface.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "synthetic_surfaces.hpp"

namespace ringfilm::instrument {
namespace {

constexpr double kModulus = 134.8e9;

SurfaceFile file_of(const std::string& path, surface::HeightMap map) {
  SurfaceFile file;
  file.map = std::move(map);
  file.origin.path = path;
  file.origin.sha256 = "digest of " + path;
  file.plausibility_line = plausibility_line(file.map);
  return file;
}

surface::HeightMap level(surface::HeightMap map) {
  const double mean = height_statistics(map).mean_m;
  for (double& height : map.height_m) height -= mean;
  return map;
}

/// A fine Gaussian surface of rms 0.1 um: a ring, and the second step of honing.
surface::HeightMap fine(std::size_t points, std::uint64_t seed) {
  const surface::SpectralMoments moments = surface::moments_of(0.05e12, 12e-6);
  return surface::surface_with({surface::SigmaRule::rq, 0.1e-6, moments.m2, moments.m4_per_m2},
                               {points, points, 0.5e-6, 0.5e-6}, seed);
}

/// What two independent steps leave: the lower of both, the coarse one of rms 1 um, its mean plane 0.9 um higher.
surface::HeightMap two_steps(std::size_t points, std::uint64_t seed) {
  surface::HeightMap map = fine(points, seed);
  const surface::HeightMap coarse =
      surface::gaussian_surface({points, points, 0.5e-6, 0.5e-6}, surface::gaussian_correlation(20e-6, 20e-6), 1e-6,
                                seed + 2, surface::RmsDefinition::exact);
  for (std::size_t i = 0; i < map.points(); ++i) {
    map.height_m[i] = std::min(map.height_m[i], coarse.height_m[i] + 0.9e-6);
  }
  return level(std::move(map));
}

SurfaceAnalysis of_plateau() {
  SurfaceAnalysis analysis;
  analysis.liner = CarryingPart::kPlateau;
  analysis.sigma_rule = surface::SigmaRule::rq;
  return analysis;
}

/// A case with what the document of a pair states, and the law that comes closest to the measured one.
cycle::Case case_of(const io::Measurement& pair) {
  cycle::Case c;
  cycle::Contact& contact = c.contact;
  contact.model = cycle::ContactLaw::kGreenwoodWilliamson;
  contact.summit_plane = cycle::SummitPlane::kNayak;
  contact.composite_modulus = kModulus;
  contact.asperity_density = value(pair, "asperity_density");
  contact.asperity_radius = value(pair, "asperity_radius");
  contact.plateau.Rpq = value(pair, "Rpq");
  contact.plateau.Rvq = value(pair, "Rvq");
  contact.plateau.Rmq = value(pair, "Rmq");
  contact.plateau.ring_roughness = value(pair, "ring_roughness");
  contact.plateau.surface_roughness = value(pair, "surface_roughness");
  contact.plateau.offset = value(pair, "plateau_offset");
  return c;
}

/// Compares the law of the plateau with that of the maps, at separations of so many composite roughnesses above the
/// plateau. Over seeds and relative positions the ratio is 0.8 to 1.2 there (docs/theory/contact.md#plateau-validity):
/// a map of (200 um)^2 has some thousand summits.
void expect_law_of_maps(const io::Measurement& pair, const SurfaceFile& ring, const SurfaceFile& liner,
                        surface::MapEdges edges, const std::vector<double>& places) {
  const cycle::Case c = case_of(pair);
  std::vector<double> separations;
  for (const double k : places) separations.push_back(value(pair, "plateau_offset") + k * value(pair, "roughness"));
  const surface::ContactLaw measured =
      surface::contact_law({liner.map, ring.map, edges, {kModulus / 2, std::nullopt}}, separations);
  const auto plateau = cycle::asperity_contact(c), whole = cycle::asperity_contact(cycle::without_plateau(c));
  for (std::size_t k = 0; k < separations.size(); ++k) {
    const double h = separations[k], p = measured.points[k].mean.pressure;
    EXPECT_NEAR(plateau->contact(h).pressure / p, 1, 0.2) << h;
    EXPECT_GT(whole->contact(h).pressure / p, 2) << "a Gaussian surface as rough as the whole liner, at " << h;
  }
}

TEST(PlateauMeasurement, ContactOfTwoStepsIsThatOfThePlateauWithin20Percent) {
  const SurfaceFile ring = file_of("ring.x3p", fine(400, 8)), liner = file_of("liner.x3p", two_steps(400, 7));
  const io::Measurement pair = pair_measurement({ring}, {liner}, of_plateau(), nullptr);
  EXPECT_NEAR(value(pair, "Rpq"), 0.1e-6, 0.02e-6);
  EXPECT_NEAR(value(pair, "Rvq"), 1e-6, 0.2e-6);
  EXPECT_NEAR(value(pair, "Rmq"), 0.84, 0.06);
  expect_law_of_maps(pair, ring, liner, surface::MapEdges::periodic, {1, 1.5, 2, 2.5});
}

TEST(PlateauMeasurement, ContactOfAHonedLinerIsThatOfThePlateauWithin20Percent) {
  surface::HonedSurface honed;
  honed.groove_spacing_m = 120e-6;
  const SurfaceFile ring = file_of("ring.x3p", fine(400, 8)),
                    liner = file_of("liner.x3p", level(honed_surface({400, 400, 0.5e-6, 0.5e-6}, honed, 1)));
  expect_law_of_maps(pair_measurement({ring}, {liner}, of_plateau(), nullptr), ring, liner, surface::MapEdges::mirrored,
                     {1, 1.5, 2});
}

TEST(PlateauMeasurement, APairStatesThePlateauInPlaceOfTheRoughness) {
  SurfaceAnalysis analysis = of_plateau();
  analysis.regions.across = 2;
  analysis.regions.down = 1;
  const SurfaceFile ring = file_of("ring.x3p", fine(200, 2)), liner = file_of("liner.x3p", two_steps(200, 1));
  const io::Measurement pair = pair_measurement({ring}, {liner}, analysis, nullptr);
  for (const char* words :
       {"[contact.plateau]", "Rpq = \"", "Rvq = \"", "Rmq = 0.", "ring_roughness = \"", "surface_roughness = \"",
        "offset = \"", "asperity_density_deviation", "Rpq of the plateau"}) {
    EXPECT_TRUE(holds({pair.fragment}, words)) << words << "\n" << pair.fragment;
  }
  for (const char* words : {"\nroughness = ", "roughness_deviation", "radius_roughness_correlation"}) {
    EXPECT_FALSE(holds({pair.fragment}, words)) << words << "\n" << pair.fragment;
  }
  EXPECT_NEAR(value(pair, "roughness"), std::hypot(value(pair, "ring_roughness"), value(pair, "Rpq")), 1e-15);
}

TEST(PlateauMeasurement, IsRefusedForASurfaceMadeInOneStepAndForRa) {
  const SurfaceFile ring = file_of("ring.x3p", fine(200, 2)), liner = file_of("liner.x3p", two_steps(200, 1));
  EXPECT_THROW(pair_measurement({liner}, {ring}, of_plateau(), nullptr), InputError) << "the ring has no plateau";
  SurfaceAnalysis by_ra = of_plateau();
  by_ra.sigma_rule = surface::SigmaRule::ra;
  EXPECT_THROW(pair_measurement({ring}, {liner}, by_ra, nullptr), InputError);
}

TEST(PlateauMeasurement, ASurfaceMadeInTwoStepsHasAFragmentAndAnotherNone) {
  const io::Measurement honed = surface_measurement(file_of("liner.x3p", two_steps(200, 1)), {}, nullptr),
                        plain = surface_measurement(file_of("ring.x3p", fine(200, 2)), {}, nullptr);
  EXPECT_TRUE(holds({honed.fragment}, "[contact.plateau]\nRpq = \""));
  EXPECT_FALSE(holds({honed.fragment}, "ring_roughness = "));
  EXPECT_EQ(plain.fragment, "");
  // The coarse step has less curvature: its slopes and edges are not of the plateau.
  EXPECT_NEAR(value(honed, "plateau_asperity_radius") / 12e-6, 1, 0.2);
}

}  // namespace
}  // namespace ringfilm::instrument
