#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/models/gas/gas.hpp"

/// What the cylinder pressure shows, of a trace or of Wiebe's cycle, compared with what the case states about it
/// (docs/theory/gas.md).
namespace ringfilm::cycle {

/// The start of a trace over a part of the cycle, and where compression from gas.intake_pressure could have brought it.
struct TraceStart {
  double crank_angle_deg;  ///< [degree], 0 = firing TDC
  double pressure;         ///< pressure at the start of the trace, absolute [Pa]
  double lowest, highest;  ///< before and after compression of the intake pressure [Pa]
};

/// Nothing where the trace covers the whole cycle or begins after firing TDC, or gas.intake_pressure is not stated.
std::optional<TraceStart> trace_start(const Case& c);

/// Does the start contradict gas.intake_pressure whatever the engine?
bool contradicts_intake(const TraceStart& start);

/// Notes on an improbable cylinder pressure: a peak far from firing TDC, or of compression alone not at it, weak, steep
/// or no compression, pressures of another reference or unit, a jump where a trace is joined with the intake pressure.
/// Wiebe's cycle also has notes on its angles.
/// @param cylinder the pressure of the whole cycle
void append_gas_notes(const Case& c, const models::CyclePressure& cylinder, std::vector<Note>& notes);

inline constexpr const char* kSyntheticTrace = "synthetic-trace";

/// The note on a trace that was not measured.
void append_origin_note(const Case& c, std::vector<Note>& notes);

/// Message on cases whose speed changes by more than a quarter although the cylinder pressure, which belongs to one
/// speed and load, stays the same. It describes the pressure of an engine. Nothing where a pressure differs or shows no
/// compression.
/// @param cases those of operating points or scenarios, each of one ring or a pack
std::optional<std::string> kept_pressure(const std::vector<const Case*>& cases);

}  // namespace ringfilm::cycle
