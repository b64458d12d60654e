#pragma once
#include <memory>
#include <utility>

namespace ringfilm::base {

/// A value that never changes and that its copies share: copying is cheap however much it holds, assigning gives this
/// copy another value and leaves the others as they are. Copies may be used from several threads. Never empty: moving
/// it copies.
template <class T>
class Shared {
 public:
  Shared() : value_(std::make_shared<const T>()) {}
  Shared(T value) : value_(std::make_shared<const T>(std::move(value))) {}
  Shared(const Shared&) = default;
  Shared& operator=(const Shared&) = default;
  ~Shared() = default;

  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_.get(); }

 private:
  std::shared_ptr<const T> value_;
};

}  // namespace ringfilm::base
