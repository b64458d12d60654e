#pragma once
#include <string>
#include <utility>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/text/units.hpp"
#include "ringfilm/surface/friction_loop/lateral_force_calibration.hpp"

namespace ringfilm::app {

/// Reads the values of options and keeps what is wrong with them, so that all of it is reported at once.
class OptionValues {
 public:
  explicit OptionValues(const io::Units& units) : units_(units) {}

  /// In `si_unit`; 0 where the text is refused. @param example what one could have written
  double quantity(const std::string& option, const std::string& text, const std::string& si_unit,
                  const std::string& example);
  /// The same above zero; what cannot be read is reported once.
  double positive(const std::string& option, const std::string& text, const std::string& si_unit,
                  const std::string& example);
  /// A length above zero [m].
  double length(const std::string& option, const std::string& text, const std::string& example);
  /// A number without unit between both, ends included.
  double number(const std::string& option, const std::string& text, double least, double most,
                const std::string& example);
  /// A value and its standard deviation in `si_unit`, "1" for none.
  surface::Uncertain uncertain(const std::string& option, const std::string& text, const std::string& si_unit,
                               const std::string& example);

  template <class Choice>
  Choice chosen(const std::string& option, const std::string& word,
                const std::vector<std::pair<std::string, Choice>>& choices) {
    std::string names;
    for (const auto& [name, choice] : choices) {
      if (name == word) return choice;
      names += (names.empty() ? "" : ", ") + name;
    }
    refuse(option + " " + word + ": this is not a choice", renamed_remedy(option, word, "one of: " + names));
    return choices.front().second;
  }

  void refuse(const std::string& message, const std::string& remedy);
  /// Throws InputError if anything was refused.
  void check() const;

 private:
  /// With the present name of a choice of an earlier version; `remedy` alone for any other word.
  static std::string renamed_remedy(const std::string& option, const std::string& word, const std::string& remedy);

  const io::Units& units_;
  std::vector<Fault> faults_;
};

/// A number of threads from 1 to 1024; throws InputError for another text. @param option with which it is given
int thread_count(const std::string& option, const std::string& text);

}  // namespace ringfilm::app
