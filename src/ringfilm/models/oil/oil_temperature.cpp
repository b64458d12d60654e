#include "ringfilm/models/oil/oil_temperature.hpp"

#include "ringfilm/base/error.hpp"
#include "ringfilm/base/number_text.hpp"

namespace ringfilm::models {

void check_oil_temperature(double T) {
  if (T > kColdestOil && T < kHottestOil) return;
  throw InputError("an oil at " + number_text(T) + " K is out of the range of " + number_text(kColdestOil) + " to " +
                       number_text(kHottestOil) + " K",
                   "temperatures are in kelvin: 313.15 for 40 degC");
}

}  // namespace ringfilm::models
