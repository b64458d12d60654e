#include <algorithm>
#include <array>
#include <vector>

#include "ringfilm/cycle/integration/cycle_film.hpp"
#include "ringfilm/cycle/menisci_cycle.hpp"
#include "ringfilm/film/gas_reach.hpp"

namespace ringfilm::cycle {
namespace {

/// No other low place of a face is lower than this share of its highest one: the film does not reach there [-].
constexpr double kFarAbove = 0.2;

/// Has a face one lowest place, rounded and between its edges, to which all else falls?
bool has_one_lowest_place(const Setup& setup, const film::FilmGrid& grid) {
  film::FilmInputs inputs;
  inputs.left.fluid = inputs.right.fluid = film::EdgeFluid::kGas;
  inputs.h_m_before = setup.ring.sigma;
  const film::GasReach reach(grid, inputs);
  if (!reach.is_place()) return false;
  const std::vector<double>& height = grid.node_height;
  const double least = kFarAbove * *std::max_element(height.begin(), height.end());
  for (int i = 0; i <= grid.n_cells(); ++i) {
    const bool is_low = (i == 0 || height[i] <= height[i - 1]) && (i == grid.n_cells() || height[i] < height[i + 1]);
    const bool is_lowest = i >= reach.end() - 1 && i <= reach.begin() + 1;
    if (is_low && !is_lowest && height[i] < least) return false;
  }
  return true;
}

}  // namespace

std::optional<std::string> no_menisci_since(const Setup& setup) {
  const Case& c = setup.input;
  struct Obstacle {
    bool is_there;
    const char* reason;
  };
  const std::array obstacles{
      Obstacle{c.is_unrolled(), "the film is that of the unrolled ring"},
      Obstacle{c.film.cavitation != Cavitation::kMassConserving, "film.cavitation is not \"mass-conserving\""},
      Obstacle{c.film.chamber_edge != EdgeFluid::kGas || c.film.crankcase_edge != EdgeFluid::kGas,
               "an edge of the face meets oil"},
      Obstacle{c.film.supply_at_inlet() != OilSupply::kFilmOnLiner, "film.supply is not \"film-on-liner\""},
      Obstacle{c.film.outlet != Outlet::kHalfGap, "film.outlet is not \"half-gap\""},
      Obstacle{c.ring.face.orientation == Orientation::kLeadingEdge, "the face turns over with the stroke"},
      Obstacle{c.ring.local_deformation != LocalDeformation::kNone, "the face deforms under its film"},
      Obstacle{setup.ring.twisting.has_value(), "the face turns with the section of its ring"},
      Obstacle{!setup.ring.factors.are_of_plain_film(),
               "flow factors, the average gap or an oil that thins change with the film"},
      Obstacle{setup.ring.land != nullptr, "film.land_lift adds the lift of the honing"},
      Obstacle{setup.surfaces != Surfaces::kRigid, "the surfaces flatten"},
      Obstacle{c.output.fields != FieldOutput::kNone, "output.fields asks for pressures on cells"}};
  const auto found = std::find_if(obstacles.begin(), obstacles.end(), [](const Obstacle& one) { return one.is_there; });
  if (found != obstacles.end()) return found->reason;
  const film::FilmGrid grid = face_grid(setup);
  if (!grid.jumps.empty() || !has_one_lowest_place(setup, grid)) {
    return "the face has not one rounded lowest place between its edges";
  }
  return std::nullopt;
}

}  // namespace ringfilm::cycle
