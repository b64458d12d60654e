#include "ringfilm/film/kernels/kernels.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm_stamp.hpp"

namespace ringfilm::io {

Provenance this_program() { return {stamp::kProgram, stamp::kCommit, stamp::kCompiler, ""}; }

Provenance this_run() {
  Provenance provenance = this_program();
  provenance.kernels = std::string(film::kernels().name) + ", 1 lane";
  return provenance;
}

}  // namespace ringfilm::io
