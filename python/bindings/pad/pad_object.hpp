#pragma once
#include "bindings.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/pad/pad_output.hpp"
#include "ringfilm/pad/pad_result.hpp"

namespace ringfilm::python {

/// `ringfilm.PadResult`: the film of a pad.
class PadObject {
 public:
  explicit PadObject(io::PadDocument document) : document_(std::move(document)) {}

  const io::PadDocument& document() const { return document_; }
  const pad::PadResult& result() const { return document_.result; }

 private:
  io::PadDocument document_;
};

/// All that a result holds, for pickles.
py::tuple pad_state(const PadObject& self);
/// Its inverse. Throws py::value_error for a pickle of another version.
PadObject pad_of_state(const py::tuple& state);

}  // namespace ringfilm::python
