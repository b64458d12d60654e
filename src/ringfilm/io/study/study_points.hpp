#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/study/study_factor.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

/// What the tables [[point]] of a study with operating points make: a factor for each key that they state, and the
/// numbers of the factors point by point.
struct StudyPoints {
  std::vector<study::Factor> factors;
  std::vector<study::WeightedPoint> points;
  std::vector<std::vector<double>> list;  ///< as Sampling::list
};

/// The tables [[point]]: name, weight and values = { "operating.speed" = "1000 rpm", ... }, each with the same keys.
/// What is wrong goes to `faults`.
StudyPoints read_study_points(const std::vector<TomlValue>& tables, const SourceMark& mark,
                              const FactorSources& sources, std::vector<Fault>& faults);

}  // namespace ringfilm::io
