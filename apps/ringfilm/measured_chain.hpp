#pragma once
#include <array>

#include "ringfilm/instrument/documents/force_sample.hpp"
#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/surface/face/face_fit.hpp"

/// How the files of cases/measured/ are measured: docs/manual/measured-chain.md has the same as options of the
/// commands.
namespace ringfilm::app::chain {

/// States of life of the ring, as the files are named.
inline constexpr std::array kRings = {"new", "run_in", "embedded"};

/// Relative positions of two maps in contact.
inline constexpr std::size_t kPositions = 2;

/// Tilt removed, S-filter 1 um, L-filter 80 um, 2 x 2 regions, sigma from Ra.
instrument::SurfaceAnalysis surface_analysis();

/// A stylus trace; where the face begins and how the holder leans was read off the instrument.
surface::FaceRule face_rule();

/// A tenth of each loop cut off at both ends, errors from the scatter about the line.
instrument::ForceRule force_rule();

/// What is taken over for silicon.
surface::Uncertain silicon_reference();

}  // namespace ringfilm::app::chain
