#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

/// Limits beyond which a film that was solved means nothing, for cycles and pads alike; docs/manual/robustness.md.
namespace ringfilm::cycle {

/// A limit of a quantity.
struct Limit {
  enum class Allowed { kAbove, kBelow } allowed;  ///< on which side of the limit results are
  const char* topic;                              ///< topic of the note
  double value;                                   ///< SI
  double unit;                                    ///< in which the note states quantity and limit [SI]
  const char* format;                             ///< format of the note: extreme value, where it is, limit
};

/// Below the length of the molecules of an oil there is no liquid film.
extern const Limit kFilmBelowMolecules;
/// Density was measured to 0.4 GPa (Dowson and Higginson 1966); Roelands' law follows measured viscosities to about
/// 0.5 GPa, Barus' law to less; and surfaces that are taken as rigid give way by more than the film is thick.
extern const Limit kFilmPressureHigh;
/// Eyring stresses of mineral oils are 2 to 10 MPa (Johnson and Tevaarwerk 1977): beyond them friction grows with the
/// logarithm of the shear rate only.
extern const Limit kShearStressHigh;

/// The note on `n` results beyond a limit. @param extreme the worst of them [SI] @param where " (at 20 degree)", or ""
Note limit_note(const Limit& limit, double extreme, const std::string& where, long n);

/// Adds a note if the value of any sample is beyond the limit.
/// @param value of a sample [SI] @param where it was taken, as for limit_note()
template <class Sample, class Value, class Where>
void append_limit_note(const Limit& limit, const std::vector<Sample>& samples, const Value& value, const Where& where,
                       std::vector<Note>& notes) {
  const double sign = limit.allowed == Limit::Allowed::kBelow ? 1 : -1;
  const auto beyond = [&](const Sample& s) { return sign * value(s) > sign * limit.value; };
  const auto n = std::count_if(samples.begin(), samples.end(), beyond);
  if (n == 0) return;
  const auto worst = std::max_element(samples.begin(), samples.end(), [&](const Sample& a, const Sample& b) {
    return sign * value(a) < sign * value(b);
  });
  notes.push_back(limit_note(limit, value(*worst), where(*worst), static_cast<long>(n)));
}

}  // namespace ringfilm::cycle
