#pragma once
#include <string>
#include <vector>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/study/verification/verification.hpp"

/// What `ringfilm verify` found, for people and for programs. Computes nothing.
namespace ringfilm::report {

struct VerificationResult {
  std::vector<study::VerificationOutcome> cases;
  std::vector<study::NotCovered> not_covered;
  io::Provenance provenance;
};

/// As JSON in SI: cases with rows and convergence lines, not_covered, program, commit. A NaN is null.
std::string verification_json(const VerificationResult& result);

/// As one self-contained web page with tables and convergence plots.
std::string verification_page(const VerificationResult& result);

}  // namespace ringfilm::report
