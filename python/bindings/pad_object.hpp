#pragma once
#include "bindings.hpp"
#include "ringfilm/cycle/case.hpp"
#include "ringfilm/io/pad_output.hpp"
#include "ringfilm/pad/pad_result.hpp"

namespace ringfilm::python {

/// `ringfilm.PadResult`: the film of a pad.
class PadObject {
 public:
  PadObject(const cycle::Case& input, pad::PadResult result);

  const io::PadDocument& document() const { return document_; }
  const pad::PadResult& result() const { return document_.result; }

 private:
  io::PadDocument document_;
};

}  // namespace ringfilm::python
