#include "ringfilm/study/ensemble/oil_assumptions.hpp"

#include <fmt/format.h>

#include "ringfilm/base/display.hpp"

namespace ringfilm::study {

std::vector<Assumption> oil_consumption_assumptions(const cycle::Case& c) {
  const cycle::OilTransport& transport = c.oil_transport;
  const auto origin = [&c](const char* key) { return c.stated.contains(key) ? "as stated" : "typical, assumed"; };
  std::vector<Assumption> all;
  if (c.lubricant.evaporates()) {
    all.push_back(assumption(
        "oil-evaporation",
        fmt::format("{} fractions of the oil{} evaporate from the liner into gas without vapour",
                    c.lubricant.fractions().size(), c.lubricant.noack ? ", assumed to have its Noack loss," : ""),
        "the vapour pressure far below the boiling points and the heat transfer of the gas are "
        "uncertain by a factor of two or more; the films do not change by it"));
  }
  all.push_back(assumption("oil-scraped-up",
                           fmt::format("a share of {:.3g} of the oil that the ring leaves above it at TDC does not "
                                       "come back ({})",
                                       transport.scraped_share, origin("oil_transport.scraped_share")),
                           "the share is not known, and oil consumption is proportional to it where a bead remains"));
  if (c.gas_path.is_computed()) {
    all.push_back(
        assumption("oil-carried-by-gas",
                   fmt::format("gas that passes the ring towards the chamber carries {} of oil ({})",
                               text_in(transport.gas_load, kGramPerKilogram, 3), origin("oil_transport.gas_load")),
                   "the load depends on the oil on the second piston land and on the position of the gaps"));
  }
  all.push_back(assumption("oil-thrown-off",
                           fmt::format("the top piston land has an oil film of {} ({})",
                                       text_in(transport.land_film, kMicrometre, 3), origin("oil_transport.land_film")),
                           "what inertia throws off goes with the cube of that film"));
  return all;
}

}  // namespace ringfilm::study
