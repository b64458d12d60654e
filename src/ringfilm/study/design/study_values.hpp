#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/design/study.hpp"

/// Which values a study has of each scenario: those of the cycle of one ring, of the rings of a pack and their sum, of
/// the gas that passes them, and the oil that they let pass.
namespace ringfilm::study {

struct StudyValues {
  std::vector<cycle::Quantity> quantities;  ///< in the order of ScenarioRow::values
  std::vector<std::string> main;            ///< names of those that matter most, they first: reported of every study
  bool has_cycle = false;                   ///< do cycle::cycle_quantities() come first?

  std::optional<std::size_t> index(const std::string& name) const;  ///< nothing: there is no value of that name
};

/// Is a scenario of that base one ring at given pressures without oil to follow, which the lanes of a batch take?
bool is_one_film(const Study& study, const cycle::Case& base);

/// Values that a study has of each scenario of a base. Throws InputError where its gas path cannot be set up.
StudyValues study_values(const Study& study, const cycle::Case& base);

/// A value of one ring of a pack, of all rails of an oil ring together.
struct RingValue {
  enum class Rails { kSum, kMin, kMax };
  const char* name;  ///< name of the value in cycle::cycle_quantities()
  Rails rails;
};
const std::vector<RingValue>& ring_values();
/// What two rails have together.
double together(RingValue::Rails rails, double a, double b);

/// "ring_2_fmep"
std::string ring_value_name(std::size_t ring, const std::string& name);
/// "land_2_peak_pressure" of the region "land 2"
std::string region_value_name(const std::string& region, const std::string& name);

}  // namespace ringfilm::study
