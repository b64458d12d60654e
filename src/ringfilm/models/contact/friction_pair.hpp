#pragma once
#include <optional>
#include <string>

namespace ringfilm::models {

/// What a coefficient of boundary friction was measured with: these are different quantities.
enum class FrictionState {
  kLubricated,  ///< asperities in engine oil
  kDry          ///< a probe without oil, which orders surfaces and is not an input of an engine
};

/// A coating against a liner, as the library data/pairs has it.
struct FrictionPair {
  std::string name;  ///< name of the pair, a value of contact.friction_pair
  std::string coating, liner;
  FrictionState state = FrictionState::kLubricated;
  double friction = 0;              ///< coefficient of boundary friction, zeta [-]
  std::optional<double> low, high;  ///< its band [-]
  std::optional<double> hardness;   ///< hardness of the softer face [Pa]
  std::string source;               ///< or "typical, assumed"
};

}  // namespace ringfilm::models
