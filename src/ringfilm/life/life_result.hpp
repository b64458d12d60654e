#pragma once
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/life/life_quantities.hpp"
#include "ringfilm/life/ring_state.hpp"
#include "ringfilm/life/wear/wear_bounds.hpp"
#include "ringfilm/life/wear_integration.hpp"

/// What a life gives over its running hours.
namespace ringfilm::life {

/// Material that the ring has lost since the start of the life.
struct WornProfile {
  std::vector<double> depth;  ///< at LifeState::x [m]
  double worn_area = 0;       ///< worn area of the cross-section: volume per length of the circumference [m2]
  double largest_depth = 0;   ///< [m]
  double end_gap_growth = 0;  ///< 2 pi times the largest depth: by how much the ends of the ring move apart [m]
  std::optional<double> coating_left;  ///< at the deepest place; nothing where its thickness is not known [m]
  std::vector<double> liner_depth;     ///< at LifeResult::liner_position [m]; empty: the liner is not followed
  /// Roughness that runs in: Rpq of a plateau, else contact.roughness [m]; nothing without running in.
  std::optional<double> running_in_roughness;
  /// Share of the worn volume that was taken from the peaks; nothing without running in [-].
  std::optional<double> smoothing_share;
  /// Blow-by of the pack with its end gap as worn, mean over the duty [m3/s]; nothing without a pack.
  std::optional<double> blow_by;
};

/// A value of a WornProfile; a life without a pack has none of its gas, one without running in none of it.
struct WornQuantity : cycle::Quantity {
  std::string heading;  ///< heading of its column in a table
  std::variant<double WornProfile::*, std::optional<double> WornProfile::*> value;
};

/// In the order of files and tables.
const std::vector<WornQuantity>& worn_quantities();

/// Nothing where it is not known.
std::optional<double> value_of(const WornQuantity& quantity, const WornProfile& worn);

/// The profile of lost depths. @param coating its thickness, if known [m]
WornProfile worn_profile(std::vector<double> depth, double area, std::optional<double> coating);

/// How far the face of a scenario is from a measured one near its middle, offset and tilt free.
struct FaceDistance {
  double half_width = 0;  ///< to both sides of the middle [m]
  double rms = 0;         ///< [m]
};

/// The members of a distance, as all outputs have them.
constexpr auto members(const FaceDistance*) {
  return std::tuple{Member{"half_width", "m", "half width compared, about the middle", &FaceDistance::half_width},
                    Member{"rms", "m", "rms distance of both faces", &FaceDistance::rms}};
}

/// The ring after one of the reported running times.
struct LifeState {
  double time = 0;                  ///< running time [s]
  StateOrigin state_origin{};       ///< how face, roughness and shear strength are known
  RingState ring;                   ///< those
  std::vector<double> x;            ///< from the chamber edge [m]
  std::vector<double> face_height;  ///< above the lowest point, as installed, at x [m]
  std::optional<WornProfile> worn;  ///< nothing where the mode does not determine it
  /// From the measured state of this running time, of a scenario that has one.
  std::vector<FaceDistance> from_measured;
  LifeValues values;                         ///< values of the whole duty
  std::vector<LifeValues> points;            ///< values of each operating point
  std::vector<gas_path::GasSums> point_gas;  ///< gas of the pack at each operating point; empty without a pack
  /// Least wear of a measured state since the first one, by how much of the edges is trusted. Lower bounds.
  std::vector<WearBound> least_wear;
  std::vector<LifeValues> other_paths;                 ///< on each of LifeResult::other_paths; empty: it ended before
  std::vector<std::optional<WornProfile>> other_worn;  ///< on each of them, where `worn` is known
  LifeValues turned;                       ///< values of the duty with the ring turned over; empty: not computed
  std::optional<WornProfile> turned_worn;  ///< material that the ring turned over has lost, in a scenario
  /// With only the face, only the roughness or only the shear strength of this state in the first one; empty: none.
  std::array<LifeValues, 3> parts;
};

/// Another way to interpolate between the measured states, or another coefficient of a scenario.
struct NamedPath {
  std::string name;
  Interpolation path;
};

/// When an EndRule is met; nothing: not within the reported times, or not known.
struct EndOfLife {
  std::optional<double> time;                      ///< on the life's own path, or in its scenario [s]
  std::vector<std::optional<double>> other_paths;  ///< on each of LifeResult::other_paths [s]
  std::optional<double> turned;                    ///< with the ring turned over [s]
  std::optional<bool> starts_above;                ///< is the value above the limit at the start? Nothing: not known
};

/// Wear coefficients that measured faces allow, by their lower bounds with more and less of the edges trusted.
struct CoefficientRange {
  double low = 0, high = 0;  ///< [m2/N]
};

/// What a fitted coefficient rests on.
enum class FitBasis {
  kMinWear,     ///< the area of the scenario is the least one between the faces
  kClosestFace  ///< the scenario is as close to the measured face as it comes
};

/// A mean coefficient from the start to a measured state.
struct FittedCoefficient {
  double time = 0;  ///< running time of the state [s]
  FitBasis basis{};
  double trusted = 0;                 ///< margin at each edge that is not trusted, or half width compared [m]
  double worn_area = 0;               ///< worn area that the scenario gives [m2]
  std::optional<double> rms;          ///< remaining rms distance, for kClosestFace [m]
  std::optional<double> coefficient;  ///< nothing: no wear, none that this duty gives, or a flat face [m2/N]
  /// For kClosestFace: is the scenario's face flat there, so that its distance no longer changes?
  bool is_flat = false;
};

/// Coefficients that the measured faces allow.
struct CoefficientFit {
  std::vector<FittedCoefficient> rows;
  CoefficientRange range;   ///< range of the coefficients up to the last state
  double largest_area = 0;  ///< to which the scenario was followed [m2]
  long cycles = 0;          ///< integrated for it
};

/// The end of a scenario whose coating is gone.
struct WearThrough {
  double time = 0;   ///< [s]
  WornProfile worn;  ///< as deep as the coating is thick at its deepest place
};

/// How a scenario of wear was integrated, and how it ended.
struct WearSummary {
  double coefficient = 0;  ///< with which the values were computed: of a fit the geometric mean of its range [m2/N]
  WearEffort effort;
  std::optional<WearThrough> worn_through;                     ///< nothing later was computed
  std::vector<std::optional<WearThrough>> other_worn_through;  ///< on each of LifeResult::other_paths
  std::optional<WearThrough> turned_worn_through;              ///< with the ring turned over
  std::optional<double> wedge_gone;  ///< when an edge of the face came within the roughness of its lowest point [s]
  std::optional<CoefficientRange> implied;  ///< by the first and the last measured face; nothing without states
  std::optional<CoefficientFit> fit;        ///< nothing: the coefficient was stated
};

/// A life, computed.
struct LifeResult {
  std::vector<LifeState> states;       ///< in the order of Life::times; fewer where the coating was worn through
  std::vector<NamedPath> other_paths;  ///< whose values make the band
  std::vector<EndOfLife> ends;         ///< end of life by each of Life::end_rules
  std::optional<WearSummary> wear;     ///< summary of the wear, in a scenario of wear
  WornProfile unworn;                  ///< before anything is worn: coating and gas; no depths
  std::vector<double> liner_position;  ///< below the TDC position of the ring [m]; empty: the liner is not followed
  std::vector<cycle::Note> notes;      ///< notes on the cycles and on the life; their counts are cycles
  long cycles = 0;                     ///< integrated until they repeat themselves
};

/// The ends of a value over all interpolations, that of the life itself among them.
struct Band {
  double low, high;
};
Band band_of(const LifeState& state, std::size_t quantity);

/// Band of a value of `worn`, which must be there.
Band band_of(const LifeState& state, const WornQuantity& quantity);

}  // namespace ringfilm::life
