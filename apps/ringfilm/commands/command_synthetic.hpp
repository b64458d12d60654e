#pragma once
#include <cstdint>
#include <string>
#include <variant>

#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/synthetic/target_surface.hpp"

namespace ringfilm::app {

/// A Gaussian surface by its rms height and correlation length.
struct GaussianSurface {
  double Sq_m = 0.3e-6;
  double length_m = 5e-6;
  surface::RmsDefinition rms = surface::RmsDefinition::exact;
};

/// A Gaussian surface whose N, beta and sigma against a smooth flat are as stated.
struct ContactSurface {
  surface::AsperityParameters target;
  surface::SigmaRule rule = surface::SigmaRule::ra;
};

/// What `synthetic` was asked for.
struct SyntheticCommand {
  std::string output;
  std::string command_text;  ///< the command without its output, for the record in the file
  surface::SurfaceGrid grid;
  std::uint64_t seed = 1;
  std::variant<GaussianSurface, ContactSurface, surface::HonedSurface, surface::PorousSurface> kind;
};

/// Makes a surface and writes it as the file of an instrument, labelled as synthetic.
void synthetic(const SyntheticCommand& command);

}  // namespace ringfilm::app
