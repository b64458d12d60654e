#pragma once

/// Every program linked with these traps dies where an invalid operation or a division by zero happens: a NaN is an
/// error where it is born. Infinities and quiet_NaN() as a documented answer raise nothing, but asking whether a NaN is
/// less or greater does.
namespace ringfilm::traps {

/// Switches the traps off for its scope; for tests that let a NaN in on purpose. State why beside it.
class NoTraps {
 public:
  NoTraps();
  NoTraps(const NoTraps&) = delete;
  NoTraps& operator=(const NoTraps&) = delete;
  ~NoTraps();

 private:
  int were_on_;
};

}  // namespace ringfilm::traps
