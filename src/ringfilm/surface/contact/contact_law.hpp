#pragma once
#include <optional>
#include <span>
#include <vector>

#include "ringfilm/surface/contact/law_scatter.hpp"
#include "ringfilm/surface/contact/rough_contact.hpp"

namespace ringfilm::surface {

/// Two surfaces that meet, or one against a smooth flat.
struct SurfacePair {
  HeightMap first;                  ///< levelled
  std::optional<HeightMap> second;  ///< levelled; nothing: a smooth flat
  MapEdges edges = MapEdges::mirrored;
  ContactMaterial material;
  std::size_t shifts = 1;  ///< relative positions over which the law is the mean
  /// Equal parts of the first position, whose laws at the separation of the whole scatter; 1 x 1: none.
  std::size_t regions_across = 1, regions_down = 1;
  bool has_flow = false;  ///< with the flow through the gap, and for separations beyond the highest point, too
};

/// Factors of the flow through the true gap over that through a smooth one of the separation h.
struct FlowFactorsOfLaw {
  double phi_x = 0.0, phi_y = 0.0;  ///< pressure flow along and across the rows, K/h^3, eq-flow-cell [-]
  /// Shear flow along the rows, (<H> - 2 Q/U)/Sq with the first surface at rest, eq-shear-cell [-].
  double phi_s = 0.0;
  double phi_fp = 0.0;  ///< factor of the shear stress that pressure drives along the rows, eq-stress-cell [-]
  /// Share of the measured area at each of ContactLaw::gap_places_m; the rest is contact [-].
  std::vector<double> gap_share;
  double residual = 0.0;  ///< relative residual of the cell problems [-]
};

/// Contact at one separation, the mean over relative positions.
struct ContactLawPoint {
  ContactAtSeparation mean;                    ///< the largest residual of all, and all iterations
  double pressure_deviation = 0.0;             ///< standard deviation over relative positions [Pa]; 0 of one
  double area_deviation = 0.0;                 ///< standard deviation of the area share over relative positions [-]
  double pressure_deviation_of_regions = 0.0;  ///< standard deviation of the pressure over regions [Pa]
  double area_deviation_of_regions = 0.0;      ///< standard deviation of the area share over regions [-]
  FlowFactorsOfLaw flow;                       ///< where it was asked for
};

/// The contact law of a pair of measured surfaces.
struct ContactLaw {
  std::vector<ContactLawPoint> points;  ///< in the order asked for
  double Sq_m = 0.0;                    ///< rms of the sum of both, of the first position [m]
  double highest_m = 0.0;               ///< largest separation with contact, of all positions [m]
  double missing_share = 0.0;           ///< share of the points of the first position that have no height [-]
  double last_supported_m = 0.0;        ///< largest separation with five spots on all maps, or the smallest of all [m]
  LawScatter scatter;  ///< scatter of the law for one relative position and one region, up to last_supported_m
  std::vector<double> first_pressure;  ///< mean pressure of the first position, in the order of `points` [Pa]
  std::vector<double> pressure;      ///< pressure of the first position at the smallest separation, point by point [Pa]
  std::vector<double> gap_m;         ///< true gap of the first position at the smallest separation, 0 in contact [m]
  std::vector<double> gap_places_m;  ///< places of the distribution of the true gap, rising; empty without the flow [m]
  ContactGrid grid;                  ///< common grid of both surfaces
};

/// Relative position k of the second surface: the first is where the map lies, the others fill the map evenly.
struct Shift {
  std::size_t x = 0, y = 0;  ///< columns and rows
};
Shift shift_of(std::size_t k, const HeightMap& second, MapEdges edges);

/// The law at these separations. Throws InputError where a separation is not above 0, lies beyond the highest point of
/// every position (but with the flow), or lets more than half of the area touch.
ContactLaw contact_law(const SurfacePair& pair, std::span<const double> separations_m);

/// Contact of the first position at these separations; beyond the highest point nothing touches, and the area is not
/// limited.
std::vector<ContactAtSeparation> contact_of_first_position(const SurfacePair& pair,
                                                           std::span<const double> separations_m);

/// Separations for a table where none are stated: evenly from the highest point down as far as contact is not more than
/// a third of the area, at the most to 0.4 Sq.
std::vector<double> usual_separations(const SurfacePair& pair);

/// Largest size up to `points` that the transforms divide into small factors.
std::size_t fast_size(std::size_t points);

}  // namespace ringfilm::surface
