#include "ringfilm/cycle/advice/limits.hpp"

#include "ringfilm/base/number_text.hpp"
#include "ringfilm/film/load_balance.hpp"

namespace ringfilm::cycle {

const Limit kFilmBelowMolecules = {
    Limit::Allowed::kAbove, "film-below-molecules", film::kMolecules, 1e-9,
    "film down to %.2g nm%s: below %.0f nm, the length of molecules of oil, there is no liquid film"};
const Limit kFilmPressureHigh = {Limit::Allowed::kBelow, "film-pressure-high", 400e6, 1e6,
                                 "film pressure up to %.4g MPa%s: beyond %.0f MPa neither the laws of density and "
                                 "viscosity nor rigid surfaces hold"};
const Limit kShearStressHigh = {Limit::Allowed::kBelow, "shear-stress-high", 10e6, 1e6,
                                "mean shear stress in the film up to %.3g MPa%s: real oils shear at little more than "
                                "%.0f MPa, their Eyring stress, and the friction is too high"};

Note limit_note(const Limit& limit, double extreme, const std::string& where, long n) {
  return {limit.topic, formatted(limit.format, extreme / limit.unit, where.c_str(), limit.value / limit.unit), n};
}

}  // namespace ringfilm::cycle
