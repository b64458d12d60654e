#pragma once
#include "ringfilm/cycle/integration/time_integration.hpp"

namespace ringfilm::cycle::testing {

/// For integrations of which only the state counts.
class NoObserver : public StepObserver {
  void before_step(TimeIntegration&, double, double) override {}
  void after_step(const TimeIntegration&) override {}
};

}  // namespace ringfilm::cycle::testing
