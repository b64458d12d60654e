#pragma once
#include <memory>
#include <optional>

#include "ringfilm/film/factors/roughness.hpp"
#include "ringfilm/film/film_state.hpp"
#include "ringfilm/models/contact/measured_flow.hpp"
#include "ringfilm/models/oil/shear_thinning.hpp"
#include "ringfilm/models/patir_cheng.hpp"

namespace ringfilm::film {

/// Oil that thins with the shear rate.
struct ThinningOil {
  models::ShearThinning law;
  double critical_stress;     ///< g_c times the viscosity at its temperature and the reference pressure [Pa]
  double reference_pressure;  ///< absolute, or from the zero of a pad [Pa]
};

/// Factors of the gap of a measured pair, in place of those of the literature; the same object in each that is used.
struct MeasuredFactors {
  using Flow = std::shared_ptr<const models::MeasuredFlow>;
  Flow pressure_flow, shear_flow, stress, average_gap;
  double eyring_stress = 0;  ///< Eyring stress of the oil in thin gaps, above 0 with `stress` [Pa]

  bool are_absent() const { return !pressure_flow && !shear_flow && !stress && !average_gap; }
};

/// The laws from which the factors of a film follow; those that are absent have no influence.
struct FactorLaws {
  std::optional<ThinningOil> thinning;
  std::optional<models::PatirCheng> pressure_flow, shear_flow, stress;
  /// phi_y, the flow factor across the motion: that of the same roughness turned by a quarter, gamma -> 1/gamma.
  std::optional<models::PatirCheng> cross_flow;
  AverageGap average_gap = AverageGap::kNominal;  ///< kMeasured counts where `measured` has it
  double sigma = 0;                               ///< composite roughness [m]
  MeasuredFactors measured;
  double share_difference = 0;  ///< V_r: share of the moving wall in sigma^2 less that of the fixed one [-]

  bool are_of_plain_film() const {
    return !thinning && !pressure_flow && !shear_flow && !stress && average_gap == AverageGap::kNominal &&
           measured.are_absent();
  }
};

/// Directions of the flow by pressure in a film.
enum class FlowDirections {
  kAlong,  ///< along the motion alone
  kBoth    ///< across it as well, in two dimensions
};

/// The factors of a film with the pressures of `state` at the separation h_m [m].
std::shared_ptr<const FlowFactors> flow_factors(const FactorLaws& laws, const FilmProblem& problem,
                                                const FilmInputs& inputs, const FilmState& state, double h_m,
                                                FlowDirections directions = FlowDirections::kAlong);

/// Film thickness at nodes and at faces along the motion [m].
struct FilmHeights {
  std::vector<double> node, face;
};
FilmHeights film_heights(const FilmGrid& grid, double h_m);

/// Largest difference of two sets of factors that move the film, relative to the factor, of lengths to the film [-].
double difference(const FlowFactors& one, const FlowFactors& other, const FilmHeights& film);

}  // namespace ringfilm::film
