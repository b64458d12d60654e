#include "ringfilm/gas_path/result.hpp"

#include "ringfilm/base/constants.hpp"

namespace ringfilm::gas_path {

const char* event_name(FlankEvent event) {
  switch (event) {
    case FlankEvent::kLeavesLower:
      return "leaves-lower";
    case FlankEvent::kLandsUpper:
      return "lands-upper";
    case FlankEvent::kLeavesUpper:
      return "leaves-upper";
    case FlankEvent::kLandsLower:
      return "lands-lower";
  }
  return "";
}

double blow_by_flow(const GasPathResult& result, double gas_constant) {
  return result.blow_by / result.duration * gas_constant * kBlowByTemperature / base::kAtmosphere;
}

}  // namespace ringfilm::gas_path
