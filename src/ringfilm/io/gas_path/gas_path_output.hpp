#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/setup/ring_section.hpp"
#include "ringfilm/gas_path/pack.hpp"
#include "ringfilm/gas_path/result.hpp"
#include "ringfilm/io/result/pack_gas.hpp"
#include "ringfilm/io/result/result_file.hpp"

namespace ringfilm::io {

/// The gas of a ring pack over a cycle, with what it was computed from.
struct GasPathDocument {
  std::string title;                     ///< Case::title
  std::vector<CaseEntry> inputs;         ///< keys that the gas uses, with the values in use
  std::vector<cycle::InputFile> files;   ///< everything that was read, with its digest
  std::vector<std::string> input_notes;  ///< Case::notes
  std::vector<cycle::Note> notes;        ///< on the result
  Provenance provenance;                 ///< what computed it
  gas_path::GasPathResult result;        ///< pressures, flows and motion over the cycle
  PackGas gas;                           ///< gas in the form of files and JSON
  /// Section of each ring, where it is stated.
  std::vector<std::optional<cycle::SectionValues>> sections = {};
};

/// The gas of a pack with the case that it is of.
GasPathDocument gas_path_document(const cycle::Case& c, const gas_path::Pack& pack, gas_path::GasPathResult result);

/// Values of the cycle as JSON, in SI with their units; crank angles in degrees.
std::string gas_path_json(const GasPathDocument& document);

/// Writes them as NetCDF-4 with the curves over crank angle, under the names that the result file of a pack has for its
/// gas. Throws OutputError.
void write_gas_path(const std::string& path, const GasPathDocument& document);

/// At each degree of crank angle the pressure of each region, the flow along each path and the position of each ring.
std::string gas_path_csv(const GasPathDocument& document);

}  // namespace ringfilm::io
