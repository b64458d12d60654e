#include <fmt/format.h>

#include <iostream>
#include <variant>

#include "commands/commands.hpp"
#include "ringfilm/instrument/formats/map_writer.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/synthetic/target_surface.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

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

/// Makes a surface and writes it as the file of an instrument, labelled as synthetic.
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

constexpr const char* kSyntheticFooter = R"(Examples:
  ringfilm synthetic gaussian flat.x3p --sq "0.1 um" --correlation-length "4 um" --seed 7
  ringfilm synthetic gaussian ring.sur --asperity-density "0.05 um-2" --asperity-radius "2 um" --roughness "0.4 um"
  ringfilm synthetic honed liner.x3p --points 1024x1024 --step "1 um" --hatch-angle "45 degree"
  ringfilm synthetic porous sprayed.gsf --pore-share 0.15 --pore-depth "4 um"

The ending of the name selects the format: .x3p, .sur, .gsf or .csv. The file is marked as synthetic and describes how
it was made; the same arguments give the same bytes. Without --seed the seed is 1.
)";

constexpr std::uint64_t kMinPoints = 16;
constexpr std::uint64_t kMaxPoints = std::uint64_t{1} << 26;  // points of a map: half a GiB of heights

void read_points(const std::string& text, surface::SurfaceGrid& grid) {
  const auto size = two_whole_numbers(text);
  const auto [x, y] = size.value_or(std::pair<std::uint64_t, std::uint64_t>());  // 0 x 0: refused
  if (x < kMinPoints || (y != 1 && y < kMinPoints) || x > kMaxPoints || y > kMaxPoints / x) {
    throw InputError("--points " + text + ": this is not a size of a map",
                     "16 or more points in each direction, 2^26 in all, for example --points 512x512");
  }
  grid.points_x = x;
  grid.points_y = y;
}

std::uint64_t seed_of(const std::string& text) {
  if (const auto seed = whole_number(text)) return *seed;
  throw InputError("--seed " + text + ": this is not a whole number from 0 on", "for example --seed 7");
}

double density_of(CommandOptions& add, const std::string& text) {
  const double density = add.quantity_of("--asperity-density", text, "m-2", "0.05 um-2");
  if (density >= 0) return density;
  throw InputError("--asperity-density is below zero", "for example \"0.05 um-2\"");
}

/// The options that all kinds of surfaces have in common, and the command as it is kept in the file.
void add_grid(CommandOptions& add, SyntheticCommand& command) {
  surface::SurfaceGrid& grid = command.grid;
  grid.step_x_m = 0.5e-6;
  const CLI::Option* output =
      add.text("OUT", command.output, "", "the file to write: .x3p, .sur, .gsf or .csv")->required();
  const CLI::Option* points = add.read("--points", "512x512", "of a row x rows; Nx1 is a profile",
                                       [&grid](const std::string& text) { read_points(text, grid); })
                                  ->default_str(fmt::format("{}x{}", grid.points_x, grid.points_y));
  const CLI::Option* step = add.length("--step", grid.step_x_m, "0.5 um", "distance of points along x and y")
                                ->default_str(surface::length_text(grid.step_x_m));
  const CLI::Option* seed = add.read("--seed", "N", "another whole number gives another surface of the same kind",
                                     [&command](const std::string& text) { command.seed = seed_of(text); })
                                ->default_str(std::to_string(command.seed));
  add.rule([=, &add, &command](Faults&) {
    command.grid.step_y_m = command.grid.step_x_m;
    const auto value = [](const CLI::Option* option) {
      return is_stated(option) ? option->results().front() : option->get_default_str();
    };
    command.command_text = fmt::format("ringfilm synthetic {} --points {} --step \"{}\"", add.app().get_name(),
                                       value(points), value(step));
    for (const CLI::Option* option : add.app().get_options()) {
      const bool is_of_all = option == output || option == points || option == step || option == seed;
      if (is_stated(option) && !is_of_all) {
        command.command_text += fmt::format(" {} \"{}\"", option->get_name(), value(option));
      }
    }
  });
}

/// A length with a default, which the help states.
CLI::Option* add_length(CommandOptions& add, const std::string& name, double& target, const std::string& example,
                        const std::string& help) {
  return add.length(name, target, example, help + " (default " + surface::length_text(target) + ")");
}

/// The two ways to state a Gaussian surface.
struct GaussianCommand : SyntheticCommand {
  GaussianSurface by_height;
  ContactSurface by_contact;
};

void declare_gaussian(CommandOptions& add, GaussianCommand& command) {
  using surface::RmsDefinition, surface::SigmaRule;
  GaussianSurface& height = command.by_height;
  ContactSurface& contact = command.by_contact;
  add_grid(add, command);
  const std::vector<const CLI::Option*> of_height = {
      add_length(add, "--sq", height.Sq_m, "0.3 um", "rms height"),
      add_length(add, "--correlation-length", height.length_m, "5 um", "of exp(-r^2/length^2)"),
      add.choice("--rms", height.rms, {{"exact", RmsDefinition::exact}, {"expected", RmsDefinition::expected}},
                 "exact: of this surface (default); expected: over many seeds")};
  const CLI::Option* density =
      add.read("--asperity-density", "\"0.05 um-2\"", "target N against a smooth flat",
               [&](const std::string& text) { contact.target.density_per_m2 = density_of(add, text); });
  const CLI::Option* radius = add.length("--asperity-radius", contact.target.beta_m, "2 um", "target beta");
  const CLI::Option* roughness = add.length("--roughness", contact.target.sigma_m, "0.4 um", "target sigma");
  const CLI::Option* sigma = add.choice("--sigma", contact.rule, {{"Ra", SigmaRule::ra}, {"Rq", SigmaRule::rq}},
                                        "what the target sigma is: Ra (default) or Rq");
  add.rule([=, &command](Faults& faults) {
    if (!is_any_stated({density, radius, roughness, sigma})) {
      command.kind = command.by_height;
      return;
    }
    command.kind = command.by_contact;
    if (!is_stated(density) || !is_stated(radius) || !is_stated(roughness)) {
      faults.refuse("--asperity-density, --asperity-radius and --roughness belong together",
                    "give all three, or --sq and --correlation-length");
    } else if (is_any_stated(of_height)) {
      faults.refuse("--sq, --correlation-length and --rms are another way to define the surface",
                    "leave them out, or --asperity-density, --asperity-radius and --roughness");
    }
  });
}

void declare_honed(CommandOptions& add, SyntheticCommand& command) {
  auto& honed = command.kind.emplace<surface::HonedSurface>();
  add_grid(add, command);
  add_length(add, "--sq", honed.plateau_Sq_m, "0.08 um", "rms height of the plateau");
  add_length(add, "--correlation-length", honed.plateau_length_m, "5 um", "of the plateau");
  add.quantity(
      "--hatch-angle", honed.hatch_angle_rad, "rad", "45 degree", "\"45 degree\"",
      fmt::format("between both families of grooves; x halves it (default {:.3g} rad)", honed.hatch_angle_rad));
  add_length(add, "--groove-spacing", honed.groove_spacing_m, "60 um", "mean");
  add_length(add, "--groove-depth", honed.groove_depth_m, "2 um", "mean");
  add_length(add, "--groove-width", honed.groove_width_m, "12 um", "at the top");
}

void declare_porous(CommandOptions& add, SyntheticCommand& command) {
  auto& porous = command.kind.emplace<surface::PorousSurface>();
  add_grid(add, command);
  add_length(add, "--sq", porous.fine_Sq_m, "0.3 um", "rms height between the pores");
  add_length(add, "--correlation-length", porous.fine_length_m, "3 um", "between the pores");
  add.number("--pore-share", porous.pore_share, 0, 0.9, "0.15", "SHARE",
             fmt::format("of the area, 0 to 0.9 (default {})", porous.pore_share));
  add_length(add, "--pore-length", porous.pore_length_m, "15 um", "correlation length of the pores");
  add_length(add, "--pore-depth", porous.pore_depth_m, "4 um", "mean");
}

}  // namespace

void add_synthetic_command(Program& program) {
  CLI::App* kinds =
      program.app.add_subcommand("synthetic", "Make a surface of known statistics, as an instrument's file");
  kinds->require_subcommand(1)->footer(kSyntheticFooter);
  program.add(*kinds, "gaussian", "A Gaussian surface, by its roughness or by N, beta and sigma", kSyntheticFooter,
              declare_gaussian, synthetic);
  program.add(*kinds, "honed", "A plateau-honed liner: a fine plateau cut by crossing grooves", kSyntheticFooter,
              declare_honed, synthetic);
  program.add(*kinds, "porous", "A sprayed face: a Gaussian surface with pores", kSyntheticFooter, declare_porous,
              synthetic);
}

}  // namespace ringfilm::app
