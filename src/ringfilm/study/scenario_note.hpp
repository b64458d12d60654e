#pragma once
#include <cstdint>
#include <optional>
#include <string>

namespace ringfilm::study {

/// A note of one scenario, one of many that carry a note of the same topic.
struct ScenarioNote {
  std::uint64_t scenario = 0;
  std::string message;
  std::optional<double> badness = {};  ///< cycle::note_badness(); nothing where no value of the cycle measures it

  /// Is this the one to show of the two: one with a measure, of these the worse, else the first?
  bool comes_before(const ScenarioNote& other) const {
    if (badness.has_value() != other.badness.has_value()) return badness.has_value();
    if (badness && other.badness && *badness != *other.badness) return *badness > *other.badness;
    return scenario < other.scenario;
  }
};

}  // namespace ringfilm::study
