#pragma once
#include <string>

#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {

/// Computes cases that are asked for as lines of JSON; docs/manual/serve.md.
class CaseServer {
 public:
  /// @param base case of requests that name none; may be empty
  explicit CaseServer(std::string base) : base_(std::move(base)) {}

  /// The answer to a request, one line of JSON without its end; what is wrong with a request is the answer, too.
  std::string answer(const std::string& line) const;

 private:
  std::string base_;
  io::Units units_;
};

}  // namespace ringfilm::app
