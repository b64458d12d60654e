#pragma once
#include <cstddef>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/study/design/study.hpp"

/// The curves that a study keeps of each scenario, all over one axis of crank angles.
namespace ringfilm::study {

/// The curves of a scenario are at most so many numbers, 128 kB: rows wait for the slowest in memory.
inline constexpr std::size_t kMaxCurveNumbers = std::size_t{1} << 15;

/// A curve that a study keeps: of one ring, or of a pack.
struct KeptCurve {
  cycle::Quantity quantity;                      ///< under its name in the study, "ring_2_total_friction" of a pack
  const cycle::CurveQuantity* source = nullptr;  ///< entry of cycle::curve_quantities()
  std::size_t ring = 0;                          ///< ring of a pack, from 1; 0: all rings added up, or the only one
};

/// In the order in which the study names its quantities, of a pack that of all rings, where they add up, and then each
/// ring with its rails together; empty where no curves are kept.
std::vector<KeptCurve> kept_curves(const Study& study);

/// The common axis, from -360 to below 360 [degree]; empty where no curves are kept.
std::vector<double> kept_angles(const OutputSelection& keep);

/// Makes a case, or the rings of a pack, give samples at the angles that are kept, and nothing that is not. The
/// integration is the same whatever is asked for, and so are the values of the cycle.
void ask_for_kept(const OutputSelection& keep, cycle::Case& c);

/// Quantity by quantity over the axis [SI]; `samples` are those of a case that was asked for them. Not finite where a
/// sample is not.
std::vector<float> kept_numbers(const OutputSelection& keep, const std::vector<cycle::Sample>& samples);

/// Curve by curve of kept_curves() of a pack. @param faces from the chamber to the crankcase, asked for those samples
/// @param numbers of the rings to which they belong, from 1
std::vector<float> kept_numbers_of_pack(const Study& study, const std::vector<cycle::CycleResult>& faces,
                                        const std::vector<std::size_t>& numbers);

/// Kept numbers of a scenario that was not solved: all NaN.
std::vector<float> no_kept_numbers(const Study& study);

/// What is wrong with what is to be kept: no quantity, unknown ones, a step that does not divide the cycle or that
/// parts the steps of a base's integration, more than kMaxCurveNumbers.
std::vector<Fault> faults_of_keep(const Study& study);

}  // namespace ringfilm::study
