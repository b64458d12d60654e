#pragma once
#include <functional>
#include <memory>

#include "ringfilm/cycle/integration/time_integration.hpp"

/// Many integrations at once, their films side by side in the lanes of a vector register.
namespace ringfilm::cycle {

/// An integration with a purpose of its own.
class BatchMember {
 public:
  virtual ~BatchMember() = default;
  virtual TimeIntegration& integration() = 0;
  /// The film of the proposed step was sought with this outcome. Throws nothing that is not to end all integrations.
  virtual void conclude(const film::FilmReport& report) = 0;
  virtual bool done() const = 0;
};

/// One integration by itself, to its end; `pulse` as below.
void integrate_alone(BatchMember& integrating, const std::function<void()>& pulse = {});

/// What it took.
struct LaneEffort {
  long sweeps = 0;         ///< Newton iterations of a block of lanes
  long lane_sweeps = 0;    ///< those of single lanes among them: `sweeps` times the width if all lanes were always busy
  long node_sweeps = 0;    ///< nodes of all blocks, swept
  long single_solves = 0;  ///< films that were sought one by one after a lane had failed
};

/// Takes integrations from `next` until it returns a null pointer, and passes each to `finished` when it is complete,
/// in any order. A free lane takes the next integration, so that none waits for the slowest. Integrations of different
/// grids share a block, as long as the longest in it, if their cells have the same next power of two; those that are
/// not solved by the coupled Newton method, and those of an unrolled film, are integrated one by one. The result of
/// an integration does not depend on the others. `pulse` is called every few crank steps at the latest; what it throws
/// ends all integrations. One thread.
LaneEffort integrate_side_by_side(const std::function<std::unique_ptr<BatchMember>()>& next,
                                  const std::function<void(std::unique_ptr<BatchMember>)>& finished,
                                  const std::function<void()>& pulse = {});

}  // namespace ringfilm::cycle
