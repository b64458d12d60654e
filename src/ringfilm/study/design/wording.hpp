#pragma once
#include <string>

/// Numbers in digests.
namespace ringfilm::study {

/// All digits, in a form that is the same wherever the number is the same.
std::string exact(double number);

}  // namespace ringfilm::study
