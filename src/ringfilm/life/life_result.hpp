#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/life/life_quantities.hpp"
#include "ringfilm/life/ring_state.hpp"

/// What a life gives over its running hours.
namespace ringfilm::life {

/// Material that the ring has lost since the start of the life.
struct WornProfile {
  std::vector<double> depth;  ///< at LifeState::x [m]
  double worn_area = 0;       ///< of the cross-section: per length of the circumference [m2]
  double largest_depth = 0;   ///< [m]
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

/// A life, computed.
struct LifeResult {
  std::vector<LifeState> states;       ///< in the order of Life::times
  std::vector<NamedPath> other_paths;  ///< whose values make the band
  std::vector<cycle::Note> notes;      ///< of the cycles and of the life; their counts are cycles
  long cycles = 0;                     ///< integrated until they repeat themselves
};

/// The ends of a value over all interpolations, that of the life itself among them.
struct Band {
  double low, high;
};
Band band_of(const LifeState& state, std::size_t quantity);

}  // namespace ringfilm::life
