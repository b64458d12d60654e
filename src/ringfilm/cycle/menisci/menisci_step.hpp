#pragma once
#include <Eigen/Core>
#include <vector>

#include "ringfilm/cycle/setup/ring_conditions.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/film/menisci/menisci_film.hpp"
#include "ringfilm/film/menisci/meniscus.hpp"

namespace ringfilm::cycle {

/// Pressure that the oil of a film serves at most, over the highest that was found [-].
inline constexpr double kServedOverPeak = 1.5;

/// The face of a ring on the cells on which the pressure of a film between menisci is integrated.
film::FilmGrid menisci_grid(const Setup& setup);
/// The asperities of a ring on the cells on which their load is summed.
film::FilmProblem menisci_contact(const Setup& setup);

/// What acts at one crank angle.
struct MenisciConditions {
  RingConditions at;
  film::MenisciInputs inputs;
};

/// @param direction 1 in upstrokes  @param highest_pressure that the oil serves at the least [Pa]
MenisciConditions menisci_conditions(const Setup& setup, double width, double crank_angle_deg, double direction,
                                     double highest_pressure, const HeatBefore& heat);

/// Oil on the liner beyond a film [kg/m2].
struct OilBeyond {
  film::OnLiner next;                                ///< next to the menisci
  double left_edge = 0, middle = 0, right_edge = 0;  ///< at the edges of the face and halfway, as far as gas is there
};

/// A step that was taken: unknowns with their rates at both ends, between which they are cubics.
struct MenisciStep {
  double from_deg = 0, to_deg = 0;
  double direction = 0;                ///< 1 in upstrokes
  film::MenisciState from, to;         ///< with the places that held during the step
  Eigen::Vector4d rate_from, rate_to;  ///< rates of the unknowns, per degree
  double lift_rate = 0;                ///< speed of the film at its begin [m/s]
  double highest_pressure = 0;         ///< that its oil serves [Pa]
  OilBeyond beyond_from, beyond_to;
  HeatBefore heat;  ///< heat of the film that the step began with

  double length_deg() const { return to_deg - from_deg; }
  /// Were the menisci of both steps free, at the edges or at the throat?
  bool has_places_of(const MenisciStep& other) const {
    return from.left.place == other.from.left.place && from.right.place == other.from.right.place;
  }
  film::MenisciState state_at(double crank_angle_deg) const;  ///< the film within the step
  OilBeyond beyond_at(double crank_angle_deg) const;          ///< linear over the step
};

/// Replaces rates that are far from the slopes of the curve through the ends of the steps. They are those of a film
/// that comes to its balance at once, within a small part of the step.
void limit_rates(std::vector<MenisciStep>& steps);

/// A film at one crank angle with what it does.
struct MenisciSample {
  double crank_angle_deg = 0;
  RingConditions at;              ///< what acts on the ring there
  double h_m = 0;                 ///< [m]
  film::FilmIntegrals integrals;  ///< without cavities
  double bead = 0;                ///< oil ahead of the ring [kg/m]
  bool is_dry = false;            ///< is there no full film?
};

}  // namespace ringfilm::cycle
