#include "commands/command_synthetic.hpp"

#include <fmt/format.h>

#include <iostream>

#include "ringfilm/instrument/formats/map_writer.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::app {
namespace {

/// Makes the surface of each kind.
struct Maker {
  const surface::SurfaceGrid& grid;
  std::uint64_t seed;

  surface::HeightMap operator()(const GaussianSurface& of) const {
    return gaussian_surface(grid, surface::gaussian_correlation(of.length_m, of.length_m), of.Sq_m, seed, of.rms);
  }
  surface::HeightMap operator()(const ContactSurface& of) const {
    const surface::SpectralMoments moments = surface::moments_of(of.target.density_per_m2, of.target.beta_m);
    return surface_with({of.rule, of.target.sigma_m, moments.m2, moments.m4_per_m2}, grid, seed);
  }
  surface::HeightMap operator()(const surface::HonedSurface& of) const { return honed_surface(grid, of, seed); }
  surface::HeightMap operator()(const surface::PorousSurface& of) const { return porous_surface(grid, of, seed).map; }
};

}  // namespace

void synthetic(const SyntheticCommand& command) {
  const instrument::MapFormat format = instrument::map_format_of(command.output);
  io::check_can_write(command.output, io::Sink::kFile);
  const io::OutputClaim claimed(command.output);
  const surface::HeightMap map = std::visit(Maker{command.grid, command.seed}, command.kind);
  const std::string maker = fmt::format("{}, seed {}", command.command_text, command.seed);
  io::write_atomically(command.output, instrument::map_bytes(map, format, "SYNTHETIC", maker));
  std::cout << "SYNTHETIC: " << maker << "\n"
            << instrument::plausibility_line(map) << "\nwrote " << command.output << "\n";
}

}  // namespace ringfilm::app
