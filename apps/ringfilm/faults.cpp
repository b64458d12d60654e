#include "faults.hpp"

namespace ringfilm::app {

void Faults::refuse(const std::string& message, const std::string& remedy) { faults_.push_back({{}, message, remedy}); }

void Faults::collect(const std::function<void()>& check) {
  try {
    check();
  } catch (const InputError& error) {
    faults_.insert(faults_.end(), error.faults().begin(), error.faults().end());
  }
}

void Faults::check() const {
  if (!faults_.empty()) throw InputError(faults_);
}

}  // namespace ringfilm::app
