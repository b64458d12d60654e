#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/surface/topography/filter.hpp"
#include "ringfilm/surface/topography/form.hpp"
#include "ringfilm/surface/topography/topography.hpp"

namespace ringfilm::surface {

/// What happens to a map between the instrument and its statistics, in this order: form, short cut-off, long cut-off.
struct Preparation {
  FormChoice form{FormKind::none};           ///< what shape is removed
  std::optional<double> short_cutoff_m;      ///< S-filter [m]
  std::optional<double> long_cutoff_m;       ///< L-filter [m]
  FilterKind filter = FilterKind::gaussian;  ///< filter at both cut-offs
};

/// What happened.
struct Prepared {
  FormRemoved form;                    ///< the shape that was removed
  std::vector<FilterApplied> filters;  ///< in the order in which they were applied; empty: none

  /// A line for each step, for tables and files.
  std::vector<std::string> lines() const;
  /// The filters alone, on one line; "none" without any.
  std::string filter_text() const;
};

/// Prepares the map in place. Throws InputError for choices that form and filters refuse, and a short cut-off that is
/// not below the long one.
Prepared prepare(HeightMap& map, const Preparation& preparation);

}  // namespace ringfilm::surface
