#pragma once
#include <memory>
#include <string>

#include "bindings.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::python {

/// `ringfilm.Case`: a case in memory that may be changed key by key.
class CaseObject {
 public:
  explicit CaseObject(cycle::Case value) : value_(std::move(value)) {}
  CaseObject(cycle::Case value, std::shared_ptr<const io::Units> units)
      : value_(std::move(value)), units_(std::move(units)) {}

  const cycle::Case& value() const { return value_; }
  /// Built at the first need, which takes some milliseconds; shared with copies.
  const io::Units& units() const {
    if (!units_) units_ = std::make_shared<io::Units>();
    return *units_;
  }

  void set(const std::string& key, const py::handle& value);
  void remove(const std::string& key);
  /// Several keys at once, {key: value}; None takes a key out.
  void update(const py::dict& values);
  /// Throws InputError with everything that is wrong with the case as a whole.
  void check();
  /// Of a file that is read and removed.
  void forget_file(const std::string& path) {
    std::erase_if(value_.files, [&](const cycle::InputFile& file) { return file.path == path; });
    for (cycle::Case& ring : value_.rings) {
      std::erase_if(ring.files, [&](const cycle::InputFile& file) { return file.path == path; });
    }
  }

 private:
  cycle::Case value_;
  mutable std::shared_ptr<const io::Units> units_;
  bool is_checked_ = false;
};

}  // namespace ringfilm::python
