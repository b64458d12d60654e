#pragma once
#include <string>
#include <vector>

#include "ringfilm/life/wear/wear_bounds.hpp"

namespace ringfilm::io {

/// A face with the name of the case that it is from.
struct NamedFace {
  std::string name;
  life::FaceHeights face;
};

/// The least wear from one face to a later one, with as much of the edges trusted as each row states.
struct FacePair {
  std::string earlier, later;
  std::vector<life::WearBound> level;   ///< the later face not tilted
  std::vector<life::WearBound> tilted;  ///< its tilt free
  std::vector<life::WearBound> turned;  ///< the later face turned over, its tilt free
};

/// What measured faces alone state about wear: docs/theory/life.md#eq-life-bound.
struct FaceComparison {
  std::vector<NamedFace> faces;  ///< in the order of their running hours
  /// Concave stretches of each face, by at least kNoticedConcavity.
  std::vector<std::vector<life::ConcaveStretch>> concave;
  std::vector<FacePair> pairs;  ///< each face and the next one, and the first and the last
};

inline constexpr double kNoticedConcavity = 0.1e-6;  ///< [m]

/// Reads the faces of two or more cases. Throws InputError for fewer, and for faces of different widths.
FaceComparison read_face_comparison(const std::vector<std::string>& case_paths);

/// The comparison as JSON, SI.
std::string face_comparison_json(const FaceComparison& comparison);

}  // namespace ringfilm::io
