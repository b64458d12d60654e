#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/life/life_quantities.hpp"
#include "ringfilm/life/ring_state.hpp"
#include "ringfilm/life/wear_integration.hpp"

/// What a life gives over its running hours.
namespace ringfilm::life {

/// Material that the ring has lost since the start of the life.
struct WornProfile {
  std::vector<double> depth;  ///< at LifeState::x [m]
  double worn_area = 0;       ///< of the cross-section: per length of the circumference [m2]
  double largest_depth = 0;   ///< [m]
  double end_gap_growth = 0;  ///< 2 pi times the largest depth: by how much the ends of the ring move apart [m]
  std::optional<double> coating_left;  ///< at the deepest place; nothing where its thickness is not known [m]
  std::vector<double> liner_depth;     ///< at LifeResult::liner_position [m]; empty: the liner is not followed
};

/// The ring after one of the reported running times.
struct LifeState {
  double time = 0;                      ///< running time [s]
  Standing standing{};                  ///< how face, roughness and shear strength are known
  RingState ring;                       ///< those
  std::vector<double> x;                ///< from the chamber edge [m]
  std::vector<double> face_height;      ///< above the lowest point, as installed, at x [m]
  std::optional<WornProfile> worn;      ///< nothing where the mode does not determine it
  LifeValues values;                    ///< of the whole duty
  std::vector<LifeValues> points;       ///< of each operating point
  std::vector<LifeValues> other_paths;  ///< on each of LifeResult::other_paths
  LifeValues turned;                    ///< of the duty, with the ring turned over; empty: not computed
  /// With only the face, only the roughness or only the shear strength of this state in the first one; empty: none.
  std::array<LifeValues, 3> parts;
};

/// Another way to interpolate between the measured states.
struct NamedPath {
  std::string name;
  Interpolation path;
};

/// How a scenario of wear was integrated, and how it ended.
struct WearSummary {
  WearEffort effort;
  std::optional<double> worn_through;  ///< when the coating was gone; nothing later was computed [s]
  std::optional<double> wedge_gone;    ///< when an edge of the face came within the roughness of its lowest point [s]
};

/// A life, computed.
struct LifeResult {
  std::vector<LifeState> states;       ///< in the order of Life::times; fewer where the coating was worn through
  std::vector<NamedPath> other_paths;  ///< whose values make the band
  std::optional<WearSummary> wear;     ///< of a scenario of wear
  std::vector<double> liner_position;  ///< below the TDC position of the ring [m]; empty: the liner is not followed
  std::vector<cycle::Note> notes;      ///< of the cycles and of the life; their counts are cycles
  long cycles = 0;                     ///< integrated until they repeat themselves
};

/// The ends of a value over all interpolations, that of the life itself among them.
struct Band {
  double low, high;
};
Band band_of(const LifeState& state, std::size_t quantity);

}  // namespace ringfilm::life
