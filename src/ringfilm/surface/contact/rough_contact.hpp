#pragma once
#include <optional>
#include <span>
#include <vector>

#include "ringfilm/surface/contact/half_space.hpp"
#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// What carries the load where two surfaces touch.
struct ContactMaterial {
  double E_star = 0.0;             ///< contact modulus, 1/E* = sum (1 - nu^2)/E [Pa]
  std::optional<double> hardness;  ///< pressure at which the softer face flows [Pa]; nothing: elastic
};

/// Contact of a pair of surfaces at one separation.
struct ContactAtSeparation {
  double separation_m = 0.0;   ///< distance of the mean planes of the undeformed surfaces [m]
  double pressure = 0.0;       ///< mean over the nominal area [Pa]
  double area_share = 0.0;     ///< real contact area over the nominal one, corrected for the pixels, eq-real-area [-]
  double pixel_share = 0.0;    ///< real contact area over the nominal one before the correction for the pixels [-]
  double share_at_cap = 0.0;   ///< share of the points in contact at which the pressure is the hardness [-]
  double mean_gap_m = 0.0;     ///< mean of the true gap, which is 0 in contact, over all measured points [m]
  double spots_per_m2 = 0.0;   ///< contact spots, which touch along sides of pixels [1/m2]
  double spot_radius_m = 0.0;  ///< radius of a circle with the mean area of a spot; 0 without contact [m]
  double residual = 0.0;       ///< residual of the complementarity, eq-contact-residual [-]
  double load_next_to_missing = 0.0;  ///< share of the load on neighbours of points without a height [-]
  int iterations = 0;                 ///< iterations of the conjugate gradients
};

/// Contact of one rough surface, the sum of two, with a smooth one: elastic half-space, perfectly plastic cap. At each
/// separation the pressure p minimises 1/2 <p, Gp> + <p, h - z> under 0 <= p <= H, eq-contact-problem.
class RoughContact {
 public:
  /// Points without a height never touch. Throws InputError for modulus or hardness that are not positive, for a flat
  /// map and for one with more than half of its points missing.
  RoughContact(const HeightMap& sum, MapEdges edges, const ContactMaterial& material);

  /// Solves at a separation h > 0, from the pressure of the last one. Throws InputError where h is not positive,
  /// ConvergenceError where no solution is found.
  ContactAtSeparation solve(double separation_m);

  double highest_m() const { return highest_m_; }  ///< highest point above the mean plane [m]
  double rms_m() const { return Sq_m_; }           ///< rms of the heights [m]
  /// Share of all points that have no height [-].
  double missing_share() const { return 1 - measured_points_ / static_cast<double>(grid_.points()); }
  const ContactGrid& grid() const { return grid_; }        ///< where the pressures are
  std::span<const double> pressure() const { return p_; }  ///< at each point, of the last separation [Pa]
  std::span<const double> gap() const { return gap_; }     ///< true gap, below 0 where pressed away [m]
  bool measured(std::size_t point) const { return missing_.empty() || missing_[point] == 0; }  ///< has it a height?

 private:
  int iterate(double separation_m, double& residual);
  double complementarity();
  void update_gap(double separation_m);
  ContactAtSeparation measures(double separation_m, double residual, int iterations) const;

  ContactGrid grid_;
  double cap_;  ///< hardness, or infinity [Pa]
  HalfSpace half_space_;
  std::vector<double> z_;              ///< about the mean; far below where missing [m]
  std::vector<std::uint8_t> missing_;  ///< as in HeightMap
  double highest_m_ = 0.0, Sq_m_ = 0.0, measured_points_ = 0.0;
  std::vector<double> p_, gap_, violation_, former_violation_, direction_, work_;
};

/// Share of the nominal area up to which half-space theory is used [-].
inline constexpr double kMaxContactArea = 0.5;
/// Throws InputError where more of the area touches.
void check_area(const ContactAtSeparation& contact);

/// Contact spots of marked points, which belong together along sides of pixels; across opposite edges, too, of a
/// periodic map.
std::size_t count_spots(std::span<const std::uint8_t> contact, const ContactGrid& grid);

/// Share of the points marked, corrected for the pixels along the edges of spots, eq-real-area [-].
double corrected_area_share(std::span<const std::uint8_t> contact, const ContactGrid& grid, double points);

/// Sum of two maps as they meet, the second one moved by columns and rows: of periodic maps round their edges, else
/// over their mirror images. Missing where one is. Throws InputError where the steps differ and, of periodic maps, the
/// sizes.
HeightMap sum_of_surfaces(const HeightMap& first, const HeightMap& second, MapEdges edges, std::size_t shift_x = 0,
                          std::size_t shift_y = 0);

}  // namespace ringfilm::surface
