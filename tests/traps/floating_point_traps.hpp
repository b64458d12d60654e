#pragma once

/// Every program linked with these traps dies where an invalid operation, a division by zero or an overflow happens:
/// a NaN is an error where it is born. Comparisons with infinities and quiet_NaN() as a documented answer raise
/// nothing.
namespace ringfilm::testing {

/// Switches the traps off for its scope; for tests that let a NaN in on purpose. Say why beside it.
class NoTraps {
 public:
  NoTraps();
  NoTraps(const NoTraps&) = delete;
  NoTraps& operator=(const NoTraps&) = delete;
  ~NoTraps();

 private:
  int were_on_;
};

}  // namespace ringfilm::testing
