#pragma once
#include <optional>
#include <string>

#include "bindings.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::python {

/// `ringfilm.Result`: a cycle, computed or read from a file. The description of the case in a result is only written
/// on request, because it takes longer than a cycle of a batch.
class ResultObject {
 public:
  explicit ResultObject(io::ResultDocument document, std::string reason = "")
      : document_(std::move(document)), reason_(std::move(reason)) {}
  ResultObject(cycle::Case input, cycle::CycleResult result, io::Provenance provenance, std::string reason = "");

  const cycle::CycleResult& result() const { return document_.result; }
  const io::ResultDocument& document() const;
  const std::string& reason() const { return reason_; }
  const std::string& title() const { return input_ ? input_->title : document_.title; }

 private:
  mutable io::ResultDocument document_;
  mutable std::optional<cycle::Case> input_;  ///< until it is written down in the document
  std::string reason_;                        ///< why a scenario of a batch was not solved
};

/// `ringfilm.PackResult`: the cycle of a ring pack.
class PackObject {
 public:
  explicit PackObject(io::ResultDocument document) : document_(std::move(document)) {}
  const io::ResultDocument& document() const { return document_; }
  const cycle::CycleResult& result() const { return document_.result; }
  const std::string& title() const { return document_.title; }

 private:
  io::ResultDocument document_;
};

/// A function of the package's plain layer.
py::object plain_layer(const char* module, const char* function);

/// Notes as tuples (topic, sentence, how many times), those of reading the case first.
py::list notes_list(const std::vector<std::string>& of_input, const std::vector<cycle::Note>& of_result);

/// A Result, or of a pack a PackResult.
py::object result_object(io::ResultDocument document);

}  // namespace ringfilm::python
