#include "ringfilm/gas_path/composition.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "ringfilm/base/constants.hpp"
#include "ringfilm/models/gas/water_vapour.hpp"

namespace ringfilm::gas_path {
namespace {

constexpr std::size_t kCycleAngles = static_cast<std::size_t>(base::kCycleDeg);
/// A step begins at a whole degree if it is so near to it [degree].
constexpr double kAtDegree = 1e-9;
/// Gases that the flow carries: fresh charge, burnt gas and the air of the crankcase.
constexpr Eigen::Index kNGases = 3;

/// The scalars of a mixture of the gases.
class Scalars {
 public:
  explicit Scalars(const Composition& of) : of_(of) {}

  /// Mass shares of the species. @param gases mass shares of the gases
  models::Shares species(const Eigen::RowVectorXd& gases) const {
    models::Shares all{};
    for (std::size_t i = 0; i < models::kNSpecies; ++i) {
      all[i] = gases[0] * of_.fresh[i] + gases[1] * of_.burnt[i] + gases[2] * of_.air[i];
    }
    return all;
  }

  /// Mass of each scalar in masses of the gases, in the order of CompositionResult.
  std::array<double, 5> masses(const Eigen::RowVectorXd& gases) const {
    const models::Shares all = species(gases);
    return {gases[0], gases[1], gases[2], share(all, models::fuel_species(of_.fuel)),
            share(all, models::Species::kWater)};
  }

  std::array<double, 5> molar_masses() const {
    return {models::molar_mass(of_.fresh), models::molar_mass(of_.burnt), models::molar_mass(of_.air),
            models::molar_mass(models::fuel_species(of_.fuel)), models::molar_mass(models::Species::kWater)};
  }

  std::array<std::string, 5> names() const {
    return {"fresh charge", "burnt gas", "air", models::fuel_name(of_.fuel), "water"};
  }

 private:
  const Composition& of_;
};

Eigen::RowVectorXd gases_of_chamber(const Composition& of, double angle_deg) {
  const double angle = angle_deg - base::kCycleDeg * std::floor(angle_deg / base::kCycleDeg);
  const auto before = static_cast<std::size_t>(angle) % kCycleAngles;
  const double part = angle - static_cast<double>(before);
  const double burnt = (1 - part) * of.burnt_share[before] + part * of.burnt_share[(before + 1) % kCycleAngles];
  return Eigen::RowVector3d(1 - burnt, burnt, 0);
}

/// Net mass of the gases into the crankcase, and what returns to the chamber [kg].
std::pair<Eigen::RowVectorXd, Eigen::RowVectorXd> exchanged(const Network& network, const ScalarCycle& cycle) {
  Eigen::RowVectorXd to_crankcase = Eigen::RowVectorXd::Zero(kNGases), to_chamber = to_crankcase;
  for (std::size_t k = 0; k < network.paths().size(); ++k) {
    const Path& path = network.paths()[k];
    const auto row = static_cast<Eigen::Index>(k);
    if (path.to + 1 == network.n_regions()) to_crankcase += cycle.forward.row(row) - cycle.back.row(row);
    if (path.from == 0) to_chamber += cycle.back.row(row);
  }
  return {to_crankcase, to_chamber};
}

/// Adds the water of a region at a crank angle. @param mass of the gas in the region; 0: not known [kg]
void add_moisture(const models::Shares& species, double p, double wall, double mass, RegionValues& region) {
  const double water = share(species, models::Species::kWater);
  const double M = models::molar_mass(species);
  const auto dew = models::dew_point(water * M / models::molar_mass(models::Species::kWater) * p);
  if (dew) region.peak_dew_point = std::max(region.peak_dew_point.value_or(0), *dew);
  region.wall_temperature = std::min(region.wall_temperature.value_or(wall), wall);
  region.condensing_share =
      region.condensing_share.value_or(0) + (dew && *dew > wall ? 1 / static_cast<double>(kCycleAngles) : 0);
  if (mass == 0) return;
  region.condensable_water =
      std::max(region.condensable_water.value_or(0), mass * models::condensable_water(water, M, p, wall));
}

}  // namespace

void add_composition(const Network& network, const std::vector<FlowStep>& steps, GasPathResult& result) {
  const std::size_t n_regions = network.n_regions();
  if (!network.pack().composition || network.inner().size() + 2 != n_regions) return;
  const Composition& of = *network.pack().composition;
  const Scalars scalars(of);
  CompositionResult composition;
  composition.share.resize(kCycleAngles * n_regions * scalars.names().size());
  const auto record = [&](const FlowStep& step, const ScalarTable& gases) {
    const double degree = std::round(step.begin_deg);
    if (std::abs(step.begin_deg - degree) > kAtDegree) return;
    const std::size_t angle = static_cast<std::size_t>(degree) % kCycleAngles;
    double* share = composition.share.data() + angle * n_regions * scalars.names().size();
    for (std::size_t r = 0; r < n_regions; ++r) {
      const Eigen::RowVectorXd row = gases.row(static_cast<Eigen::Index>(r));
      const auto masses = scalars.masses(row);
      share = std::copy(masses.begin(), masses.end(), share);
      const Region& region = network.regions()[r];
      const double p = result.pressure[angle][r];
      const bool is_crankcase = r + 1 == n_regions;
      const double wall = r == 0         ? of.chamber_wall[angle]
                          : is_crankcase ? region.temperature
                                         : std::min(region.temperature, of.liner_wall);
      add_moisture(scalars.species(row), p, wall, r == 0 || is_crankcase ? 0 : region.capacity * p, result.regions[r]);
    }
  };
  const double air_mass = of.ventilation * result.duration;
  const ScalarCycle cycle = periodic_scalars(
      network.paths(), steps, [&of](double angle) { return gases_of_chamber(of, angle); }, air_mass,
      Eigen::RowVector3d(0, 0, 1), record);
  const auto [to_crankcase, to_chamber] = exchanged(network, cycle);
  const auto entering = scalars.masses(to_crankcase), returning = scalars.masses(to_chamber),
             of_crankcase = scalars.masses(cycle.crankcase), molar_mass = scalars.molar_masses();
  const models::Shares species = scalars.species(cycle.crankcase);
  const double M = models::molar_mass(species);
  const auto names = scalars.names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    composition.scalars.push_back({names[i], entering[i] / result.duration, entering[i], returning[i], of_crankcase[i],
                                   of_crankcase[i] * M / molar_mass[i]});
  }
  const double leaves = std::max(to_crankcase.sum() / result.duration + of.ventilation, 0.0);
  composition.condensate_flow =
      leaves * models::condensable_water(share(species, models::Species::kWater), M,
                                         result.regions.back().mean_pressure, network.regions().back().temperature);
  composition.defect = cycle.defect;
  result.composition = std::move(composition);
}

}  // namespace ringfilm::gas_path
