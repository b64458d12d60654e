#pragma once
#include <string>
#include <vector>

#include "ringfilm/instrument/documents/surface_measurement.hpp"

namespace ringfilm::instrument {

/// All files of one surface, each region of each file a sample.
struct Side {
  std::string name;  ///< "ring", "liner" or "surface"
  std::vector<PreparedSurface> surfaces;
  std::vector<surface::SurfaceMeasures> measures;
  std::vector<PlateauMeasures> plateaus;  ///< plateau of each sample, where it carries: `measures` are then its
};

/// @param carrying what the measures are of
Side measured_side(const std::string& name, const std::vector<SurfaceFile>& files, const SurfaceAnalysis& analysis,
                   const SurfaceFile* flat, CarryingPart carrying = CarryingPart::kWhole);

/// Files of a side with the number of their regions.
std::string names_of(const Side& side);

/// Name and digest of each file, for the record.
std::vector<std::string> digest_lines(const Side& side);

/// What each sample measures, with its place.
io::MeasuredTable side_table(const Side& side, const SurfaceAnalysis& analysis, const std::string& title);

}  // namespace ringfilm::instrument
