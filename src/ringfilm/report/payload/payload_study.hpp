#pragma once
#include <nlohmann/json.hpp>

#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/io/text/units.hpp"

/// What the page of a study is drawn from: SI numbers, each quantity with the unit in which people read it.
namespace ringfilm::report {

/// What was done: plan, bases, factors, what was not solved, program and files.
nlohmann::ordered_json study_head(const io::StudyRows& rows, const io::Units& units, const io::Provenance& provenance);

/// Statistics of all cycle values, and of the main ones histograms, indices, one-at-a-time sensitivities, convergence,
/// elementary effects and the comparison of bases and choices, as far as the plan has them.
void add_study_values(const io::StudyRows& rows, const io::Units& units, nlohmann::ordered_json& payload);

/// Values at the points of a grid, unless it has more than the page can hold, and an even subset of the points of each
/// base for a Stribeck curve.
void add_study_points(const io::StudyRows& rows, nlohmann::ordered_json& payload);

/// Bands of the curves that were kept; none where they were not. Few scenarios that are not a sample have their own
/// curves in place of the bands.
void add_study_curves(const io::StudyRows& rows, const io::Units& units, nlohmann::ordered_json& payload);

/// Points of single scenarios in one picture, at the most.
inline constexpr std::size_t kMaxDrawnPoints = 2000;
/// Up to kFewScenarios that are not a sample, single curves are drawn in place of bands, at most kMaxDrawnCurves.
inline constexpr std::uint64_t kFewScenarios = 40, kMaxDrawnCurves = 8;
/// Points of a grid that a page carries, at the most.
inline constexpr std::size_t kMaxGridPoints = 20'000;

}  // namespace ringfilm::report
