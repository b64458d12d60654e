#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "ringfilm/base/display.hpp"

/// "82.5 mm" to SI and back, by UDUNITS-2 and a few names of engineers: cP, deg, degCA, Grad, rev, bara, psia, thou,
/// HV, HB, and lb of a force; of quantities also HRC, SUS and degE (empirical_units.hpp). A no-break space is a space.
namespace ringfilm::io {

/// What is wrong with a quantity, as the end of a sentence ("has no unit"), and what to write instead.
class UnitError : public std::runtime_error {
 public:
  /// The rule that was broken, and what to write.
  UnitError(const std::string& predicate, const std::string& what_to_write)
      : std::runtime_error(predicate), remedy(what_to_write) {}
  std::string remedy;  ///< may be empty
};

/// Reads units, of a system that all share: to read it takes some milliseconds.
class Units {
 public:
  Units();  ///< the units of UDUNITS-2 and those of engineers

  /// The value in `si_unit` of a text such as "82.5 mm". Throws UnitError for: no number, comma decimal, NaN, infinity,
  /// no unit, unknown unit, gauge pressure, another dimension, an angle in units above a revolution, a speed without
  /// rpm or rad, a temperature in other than degC, K, degF. @param example what one could have written
  double quantity(const std::string& text, const std::string& si_unit, const std::string& example) const;

  /// The scale of a unit alone ("mm", or "0.001 m") to `si_unit`. Throws UnitError.
  Scale scale(const std::string& unit, const std::string& si_unit) const;

  /// Is `unit` a unit of the dimension of `si_unit`? False also where it is not a unit at all.
  bool measures(const std::string& unit, const std::string& si_unit) const;

  /// The value [si_unit] in the unit that people read: "89 mm"; the number alone where that unit is "1" or empty.
  std::string shown(double value_in_si, const std::string& si_unit, const std::string& display_unit,
                    int max_digits = 8) const;

 private:
  struct System;
  std::shared_ptr<const System> system_;
};

/// The number that a text begins with, a plus sign included, and what follows without blanks around it. Throws
/// UnitError for: no number, NaN, infinity. @param requested what one could have written
std::pair<double, std::string> leading_number(const std::string& text, const std::string& requested);

/// What `si_unit` measures, in words: "a force" for "N".
std::string dimension_words(const std::string& si_unit);

/// The shortest decimal text that reads back as the same double.
std::string exact_text(double value);

}  // namespace ringfilm::io
