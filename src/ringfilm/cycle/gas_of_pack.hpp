#pragma once
#include <vector>

#include "ringfilm/cycle/case/case.hpp"
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/gas_path/result.hpp"

namespace ringfilm::cycle {

/// The gas path of a checked case, of a ring pack or of one ring. Throws InputError where its traces cannot be used.
gas_path::Pack gas_pack(const Case& c);

/// Notes on the gas of a pack: those of its cylinder pressure, rings that flutter, cycles that do not repeat.
std::vector<Note> gas_path_notes(const Case& c, const gas_path::Pack& pack, const gas_path::GasPathResult& result);

}  // namespace ringfilm::cycle
