#include "ringfilm/base/renamed.hpp"

#include <algorithm>

namespace ringfilm {

std::string_view present_name(std::string_view before) {
  const auto found =
      std::find_if(kRenamedNames.begin(), kRenamedNames.end(), [&](const auto& name) { return name.before == before; });
  return found == kRenamedNames.end() ? std::string_view() : found->now;
}

}  // namespace ringfilm
