#include "ringfilm/io/result_file.hpp"
#include "ringfilm_stamp.hpp"

namespace ringfilm::io {

Provenance this_program() { return {stamp::kProgram, stamp::kCommit, stamp::kCompiler}; }

}  // namespace ringfilm::io
