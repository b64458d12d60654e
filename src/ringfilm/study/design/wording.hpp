#pragma once
#include <string>

/// Numbers in sentences and in keys.
namespace ringfilm::study {

/// Six digits, for people.
std::string shown(double number);

/// All digits, in a form that is the same wherever the number is the same.
std::string exact(double number);

}  // namespace ringfilm::study
