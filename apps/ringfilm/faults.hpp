#pragma once
#include <functional>
#include <string>
#include <vector>

#include "ringfilm/base/error.hpp"

namespace ringfilm::app {

/// What is wrong with the input of a command, kept so that all of it is reported at once.
class Faults {
 public:
  void refuse(const std::string& message, const std::string& remedy = "");
  /// Runs a check and keeps the faults of the InputError that it throws.
  void collect(const std::function<void()>& check);
  /// Throws InputError if there is a fault.
  void check() const;

 private:
  std::vector<Fault> faults_;
};

}  // namespace ringfilm::app
