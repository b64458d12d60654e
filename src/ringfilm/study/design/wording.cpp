#include "ringfilm/study/design/wording.hpp"

#include "ringfilm/base/number_text.hpp"

namespace ringfilm::study {

std::string exact(double number) { return formatted("%a", number); }

}  // namespace ringfilm::study
