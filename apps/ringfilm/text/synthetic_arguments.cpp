#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string_view>

#include "commands/command_synthetic.hpp"
#include "option_values.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {
namespace {

constexpr const char* kSyntheticFooter = R"(Examples:
  ringfilm synthetic gaussian flat.x3p --sq "0.1 um" --correlation-length "4 um" --seed 7
  ringfilm synthetic gaussian ring.sur --asperity-density "0.05 um-2" --asperity-radius "2 um" --roughness "0.4 um"
  ringfilm synthetic honed liner.x3p --points 1024x1024 --step "1 um" --hatch-angle "45 degree"
  ringfilm synthetic porous sprayed.gsf --pore-share 0.15 --pore-depth "4 um"

The ending of the name selects the format: .x3p, .sur, .gsf or .csv. The file is marked as synthetic and describes how
it was made; the same arguments give the same bytes. Without --seed the seed is 1.
)";

/// A line of help with the length that holds where none is stated.
std::string with_default(const char* help, double length_m) {
  return std::string(help) + " (default " + surface::length_text(length_m) + ")";
}

constexpr surface::HonedSurface kHoned;
constexpr surface::PorousSurface kPorous;
constexpr std::size_t kFewestPoints = 16;
constexpr std::size_t kMostPoints = std::size_t{1} << 26;  // of a map: half a GiB of heights

template <class Whole>
bool read_whole(std::string_view word, Whole& to) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), to);
  return error == std::errc() && end == word.data() + word.size();
}

/// The arguments that all kinds share.
struct SyntheticArguments {
  SyntheticCommand command;
  std::string kind, points = "512x512", step = "0.5 um", seed = "1";

  CLI::App* add_to(CLI::App& synthetic, const std::string& name, const char* description) {
    kind = name;
    CLI::App* app = synthetic.add_subcommand(name, description);
    app->add_option("OUT", command.output, "the file to write: .x3p, .sur, .gsf or .csv")->required()->type_name("");
    app->add_option("--points", points, "of a row x rows; Nx1 is a profile")
        ->capture_default_str()
        ->type_name("512x512");
    app->add_option("--step", step, "distance of points along x and y")->capture_default_str()->type_name("LENGTH");
    app->add_option("--seed", seed, "another whole number gives another surface of the same kind")
        ->capture_default_str()
        ->type_name("N");
    app->footer(kSyntheticFooter);
    return app;
  }

  /// Points, step and seed; and the whole command as it is kept in the file.
  SyntheticCommand common(OptionValues& values,
                          const std::vector<std::pair<std::string, std::optional<std::string>>>& stated) const {
    SyntheticCommand of = command;
    of.grid.step_x_m = of.grid.step_y_m = values.length("--step", step, "0.5 um");
    const std::string_view text = points;
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos || !read_whole(text.substr(0, cross), of.grid.points_x) ||
        !read_whole(text.substr(cross + 1), of.grid.points_y) || of.grid.points_x < kFewestPoints ||
        (of.grid.points_y != 1 && of.grid.points_y < kFewestPoints) || of.grid.points_x > kMostPoints ||
        of.grid.points_y > kMostPoints / of.grid.points_x) {
      values.refuse("--points " + points + ": this is not a size of a map",
                    "16 or more points in each direction, 2^26 in all, for example --points 512x512");
    }
    if (!read_whole(std::string_view(seed), of.seed)) {
      values.refuse("--seed " + seed + ": this is not a whole number from 0 on", "for example --seed 7");
    }
    of.command_text = "ringfilm synthetic " + kind + " --points " + points + " --step \"" + step + "\"";
    for (const auto& [option, value] : stated) {
      if (value) of.command_text += " " + option + " \"" + *value + "\"";
    }
    return of;
  }
};

using Text = std::optional<std::string>;

/// A length where it is stated.
void read_length(OptionValues& values, const char* option, const Text& text, const char* example, double& to) {
  if (text) to = values.length(option, *text, example);
}

struct GaussianArguments : SyntheticArguments {
  Text sq, length, rms, density, radius, roughness, sigma;

  void add(CLI::App& synthetic, Actions& actions, const std::shared_ptr<GaussianArguments>& self) {
    CLI::App* app = add_to(synthetic, "gaussian", "A Gaussian surface, by its roughness or by N, beta and sigma");
    app->add_option("--sq", sq, with_default("rms height", GaussianSurface{}.Sq_m))->type_name("LENGTH");
    app->add_option("--correlation-length", length, with_default("of exp(-r^2/length^2)", GaussianSurface{}.length_m))
        ->type_name("LENGTH");
    app->add_option("--rms", rms, "exact: of this surface (default); expected: over many seeds")->type_name("WORD");
    app->add_option("--asperity-density", density, "target N against a smooth flat")->type_name("\"0.05 um-2\"");
    app->add_option("--asperity-radius", radius, "target beta")->type_name("LENGTH");
    app->add_option("--roughness", roughness, "target sigma")->type_name("LENGTH");
    app->add_option("--sigma", sigma, "what the target sigma is: Ra (default) or Rq")->type_name("WORD");
    actions.emplace_back(app, [self] { app::synthetic(self->read()); });
  }

  SyntheticCommand read() const {
    const io::Units units;
    OptionValues values(units);
    SyntheticCommand of = common(values, {{"--sq", sq},
                                          {"--correlation-length", length},
                                          {"--rms", rms},
                                          {"--asperity-density", density},
                                          {"--asperity-radius", radius},
                                          {"--roughness", roughness},
                                          {"--sigma", sigma}});
    if (density || radius || roughness || sigma) {
      of.kind = contact(values);
    } else {
      GaussianSurface gaussian;
      read_length(values, "--sq", sq, "0.3 um", gaussian.Sq_m);
      read_length(values, "--correlation-length", length, "5 um", gaussian.length_m);
      using surface::RmsDefinition;
      gaussian.rms = values.chosen<RmsDefinition>(
          "--rms", rms.value_or("exact"), {{"exact", RmsDefinition::exact}, {"expected", RmsDefinition::expected}});
      of.kind = gaussian;
    }
    values.check();
    return of;
  }

 private:
  ContactSurface contact(OptionValues& values) const {
    ContactSurface of;
    if (!density || !radius || !roughness) {
      values.refuse("--asperity-density, --asperity-radius and --roughness belong together",
                    "give all three, or --sq and --correlation-length");
      return of;
    }
    if (sq || length || rms) {
      values.refuse("--sq, --correlation-length and --rms are another way to define the surface",
                    "leave them out, or --asperity-density, --asperity-radius and --roughness");
    }
    of.target.density_per_m2 = values.quantity("--asperity-density", *density, "m-2", "0.05 um-2");
    if (of.target.density_per_m2 < 0) values.refuse("--asperity-density is below zero", "for example \"0.05 um-2\"");
    of.target.beta_m = values.length("--asperity-radius", *radius, "2 um");
    of.target.sigma_m = values.length("--roughness", *roughness, "0.4 um");
    using surface::SigmaRule;
    of.rule = values.chosen<SigmaRule>("--sigma", sigma.value_or("Ra"), {{"Ra", SigmaRule::ra}, {"Rq", SigmaRule::rq}});
    return of;
  }
};

struct HonedArguments : SyntheticArguments {
  Text sq, length, angle, spacing, depth, width;

  void add(CLI::App& synthetic, Actions& actions, const std::shared_ptr<HonedArguments>& self) {
    CLI::App* app = add_to(synthetic, "honed", "A plateau-honed liner: a fine plateau cut by crossing grooves");
    app->add_option("--sq", sq, with_default("rms height of the plateau", kHoned.plateau_Sq_m))->type_name("LENGTH");
    app->add_option("--correlation-length", length, with_default("of the plateau", kHoned.plateau_length_m))
        ->type_name("LENGTH");
    app->add_option(
           "--hatch-angle", angle,
           fmt::format("between both families of grooves; x halves it (default {:.3g} rad)", kHoned.hatch_angle_rad))
        ->type_name("\"45 degree\"");
    app->add_option("--groove-spacing", spacing, with_default("mean", kHoned.groove_spacing_m))->type_name("LENGTH");
    app->add_option("--groove-depth", depth, with_default("mean", kHoned.groove_depth_m))->type_name("LENGTH");
    app->add_option("--groove-width", width, with_default("at the top", kHoned.groove_width_m))->type_name("LENGTH");
    actions.emplace_back(app, [self] { app::synthetic(self->read()); });
  }

  SyntheticCommand read() const {
    const io::Units units;
    OptionValues values(units);
    SyntheticCommand of = common(values, {{"--sq", sq},
                                          {"--correlation-length", length},
                                          {"--hatch-angle", angle},
                                          {"--groove-spacing", spacing},
                                          {"--groove-depth", depth},
                                          {"--groove-width", width}});
    surface::HonedSurface honed;
    read_length(values, "--sq", sq, "0.08 um", honed.plateau_Sq_m);
    read_length(values, "--correlation-length", length, "5 um", honed.plateau_length_m);
    if (angle) honed.hatch_angle_rad = values.quantity("--hatch-angle", *angle, "rad", "45 degree");
    read_length(values, "--groove-spacing", spacing, "60 um", honed.groove_spacing_m);
    read_length(values, "--groove-depth", depth, "2 um", honed.groove_depth_m);
    read_length(values, "--groove-width", width, "12 um", honed.groove_width_m);
    values.check();
    of.kind = honed;
    return of;
  }
};

struct PorousArguments : SyntheticArguments {
  Text sq, length, share, pore_length, depth;

  void add(CLI::App& synthetic, Actions& actions, const std::shared_ptr<PorousArguments>& self) {
    CLI::App* app = add_to(synthetic, "porous", "A sprayed face: a Gaussian surface with pores");
    app->add_option("--sq", sq, with_default("rms height between the pores", kPorous.fine_Sq_m))->type_name("LENGTH");
    app->add_option("--correlation-length", length, with_default("between the pores", kPorous.fine_length_m))
        ->type_name("LENGTH");
    app->add_option("--pore-share", share, fmt::format("of the area, 0 to 0.9 (default {})", kPorous.pore_share))
        ->type_name("SHARE");
    app->add_option("--pore-length", pore_length,
                    with_default("correlation length of the pores", kPorous.pore_length_m))
        ->type_name("LENGTH");
    app->add_option("--pore-depth", depth, with_default("mean", kPorous.pore_depth_m))->type_name("LENGTH");
    actions.emplace_back(app, [self] { app::synthetic(self->read()); });
  }

  SyntheticCommand read() const {
    const io::Units units;
    OptionValues values(units);
    SyntheticCommand of = common(values, {{"--sq", sq},
                                          {"--correlation-length", length},
                                          {"--pore-share", share},
                                          {"--pore-length", pore_length},
                                          {"--pore-depth", depth}});
    surface::PorousSurface porous;
    read_length(values, "--sq", sq, "0.3 um", porous.fine_Sq_m);
    read_length(values, "--correlation-length", length, "3 um", porous.fine_length_m);
    if (share) porous.pore_share = values.number("--pore-share", *share, 0, 0.9, "0.15");
    read_length(values, "--pore-length", pore_length, "15 um", porous.pore_length_m);
    read_length(values, "--pore-depth", depth, "4 um", porous.pore_depth_m);
    values.check();
    of.kind = porous;
    return of;
  }
};

template <class Arguments>
void add_kind(CLI::App& synthetic, Actions& actions) {
  const auto arguments = std::make_shared<Arguments>();
  arguments->add(synthetic, actions, arguments);
}

}  // namespace

void add_synthetic_command(CLI::App& program, Actions& actions) {
  CLI::App* command =
      program.add_subcommand("synthetic", "Make a surface of known statistics, as an instrument's file");
  command->require_subcommand(1);
  command->footer(kSyntheticFooter);
  add_kind<GaussianArguments>(*command, actions);
  add_kind<HonedArguments>(*command, actions);
  add_kind<PorousArguments>(*command, actions);
}

}  // namespace ringfilm::app
