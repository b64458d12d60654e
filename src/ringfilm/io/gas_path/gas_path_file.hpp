#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/result/pack_gas.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// The gas of a ring pack alone, as a file of it has it (write_gas_path).
struct GasPathFile {
  std::string title;                     ///< Case::title
  Provenance provenance;                 ///< what computed it
  std::vector<CaseEntry> inputs;         ///< keys that the gas uses, with the values in use; of earlier files none
  std::vector<cycle::InputFile> files;   ///< everything that was read, with its digest
  std::vector<std::string> input_notes;  ///< Case::notes
  std::vector<cycle::Note> notes;        ///< on the result
  std::optional<PackGas> gas;            ///< always present in a file that was written whole
};

/// Are these the bytes of such a file? False for another kind; throws InputError where they were damaged.
/// @param name how errors name the file
bool is_gas_path(const std::string& name, const std::string& bytes);

/// The gas that those bytes hold. Throws InputError where they are damaged or of another version.
GasPathFile gas_path_of_bytes(const std::string& name, const std::string& bytes);

}  // namespace ringfilm::io
