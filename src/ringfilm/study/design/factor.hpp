#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ringfilm/base/error.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/study/sampling/distribution.hpp"

/// What varies in a study: one uncertain or varied number, or a choice, and where it enters the cases.
namespace ringfilm::study {

/// How a factor's number x enters a key that has the number b in the base: x, b x, or b + x.
enum class FactorMode { kSet, kScale, kAdd };

/// A key that a factor moves.
struct Target {
  std::optional<std::size_t> base;  ///< index of the base case; absent: all of them
  std::string key;                  ///< "operating.speed"
  /// What enters is gain times the factor's number: so one error, common to several bases, has its own size in each
  /// [unit of the key over that of the factor].
  double gain = 1;
};

/// One of the values of a key that is not a number.
struct Choice {
  std::string text;      ///< as one would write it in TOML, without quotes
  SourceMark mark = {};  ///< where it is written in the study's file
  /// SHA-256 of the bytes of the file that it names; empty: it names none that can be read
  std::string file_sha256 = {};
  /// Values along the stroke that `text` states, of a key that has them.
  std::vector<cycle::StrokeValue> along_stroke = {};
};

enum class Spacing { kLinear, kLogarithmic };

/// Numbers that are listed [SI].
struct Levels {
  std::vector<double> values;
};
/// Texts that are listed; the factor's number is the index.
struct Choices {
  std::vector<Choice> values;
};
/// From one number to another [SI]: `points` of them on a grid, both ends among them, and any between in a sample.
struct Span {
  double low = 0, high = 0;
  std::size_t points = 2;
  Spacing spacing = Spacing::kLinear;
};
/// Only what the list of a plan gives.
struct Listed {};

using Variation = std::variant<Levels, Choices, Span, Distribution, Listed>;

struct Factor {
  std::string name;
  std::vector<Target> targets;
  FactorMode how = FactorMode::kSet;
  Variation variation;
  std::string unit;          ///< SI; "1" for a dimensionless number and for scale, "" for choices
  std::string display_unit;  ///< the unit in which people read it
  SourceMark mark;           ///< its place in the study's file, for messages about it
  std::string source = {};   ///< where its variation comes from, "assumed: ...", for people; may be empty
};

/// Does the factor move anything in that base?
bool applies(const Factor& factor, std::size_t base);

/// How many values the variation has on a grid; 0 unless it is listed values, listed texts or a span.
std::size_t n_levels(const Variation& variation);

/// The value at that place of the grid, from 0: a number [SI], or the index of a choice.
double level(const Variation& variation, std::size_t i);

/// The value at a share of all values, in (0, 1): the quantile of a distribution, the place in a span, one of as many
/// equal parts as there are levels. Not for `Listed`.
double value_at(const Variation& variation, double share);

/// A name as messages have it: `factor "speed"`.
std::string called(const Factor& factor);

}  // namespace ringfilm::study
