#pragma once
#include <optional>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/gas_path/result.hpp"

namespace ringfilm::cycle {

/// The gas path of a checked case, of a ring pack or of one ring. Throws InputError where its traces cannot be used.
gas_path::Pack gas_pack(const Case& c);

/// Puts the pressures that the gas path of a pack gives into one of its rings: those of the piston lands at its edges
/// and that of its groove behind it; and the temperatures of the gas at its edges.
/// @param index of the ring in gas_path::Pack::rings
void put_gas_pressures(Ring& ring, const gas_path::Pack& pack, const gas_path::GasPathResult& result,
                       std::size_t index);

/// The pressures below its rings where the case states them (gas_path.model = "given"); empty otherwise.
gas_path::GivenPressures given_pressures(const Case& c);

/// A case whose rings have the pressures of their gas path.
struct CaseWithGas {
  Case input;                                  ///< with these pressures
  std::optional<gas_path::GasPathResult> gas;  ///< absent where the pressures are given
};

/// The case with the gas path of its pack computed, where gas_path.model asks for it: each ring has the pressures of
/// the piston lands at its edges and that of its groove behind it, and the first a note on the blow-by. Others as they
/// are. Throws ConvergenceError where the gas is not found.
CaseWithGas solve_gas_of_case(Case c);

/// The case of solve_gas_of_case(), without the result of the gas path.
Case with_gas_path(Case c);

/// Notes on rings that flutter, or that are kept on flanks off which they are pressed.
std::vector<Note> ring_motion_notes(const Case& c, const gas_path::Pack& pack, const gas_path::GasPathResult& result);

/// Notes on the gas of a pack: those of its cylinder pressure, its rings, cycles that do not repeat.
std::vector<Note> gas_path_notes(const Case& c, const gas_path::Pack& pack, const gas_path::GasPathResult& result);

}  // namespace ringfilm::cycle
