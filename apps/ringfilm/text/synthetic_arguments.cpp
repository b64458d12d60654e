#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <deque>
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

constexpr std::size_t kFewestPoints = 16;
constexpr std::size_t kMostPoints = std::size_t{1} << 26;  // of a map: half a GiB of heights

template <class Whole>
bool read_whole(std::string_view word, Whole& to) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), to);
  return error == std::errc() && end == word.data() + word.size();
}

/// An option of one kind of surface, declared once: what it is and where its value goes.
struct KindOption {
  using Put = std::function<void(OptionValues&, const std::string& text)>;

  std::string name;
  std::optional<std::string> text;
  Put put;
};

/// One kind of surface with the options that all kinds share and its own.
class SyntheticArguments {
 public:
  SyntheticArguments(CLI::App& synthetic, const std::string& kind, const char* description)
      : kind_(kind), app_(*synthetic.add_subcommand(kind, description)) {
    app_.add_option("OUT", command_.output, "the file to write: .x3p, .sur, .gsf or .csv")->required()->type_name("");
    app_.add_option("--points", points_, "of a row x rows; Nx1 is a profile")
        ->capture_default_str()
        ->type_name("512x512");
    app_.add_option("--step", step_, "distance of points along x and y")->capture_default_str()->type_name("LENGTH");
    app_.add_option("--seed", seed_, "another whole number gives another surface of the same kind")
        ->capture_default_str()
        ->type_name("N");
    app_.footer(kSyntheticFooter);
  }

  CLI::App* app() const { return &app_; }

  void option(const char* name, const std::string& help, const char* type, KindOption::Put put) {
    KindOption& added = options_.emplace_back(KindOption{name, {}, std::move(put)});
    app_.add_option(name, added.text, help)->type_name(type);
  }

  void length(const char* name, const std::string& help, const char* example, double& to) {
    option(name, help, "LENGTH", [name, example, &to](OptionValues& values, const std::string& text) {
      to = values.length(name, text, example);
    });
  }

  /// A length with a default, which help prints.
  void usual_length(const char* name, const std::string& help, const char* example, double& to) {
    length(name, help + " (default " + surface::length_text(to) + ")", example, to);
  }

  bool is_stated(const std::vector<std::string>& names) const {
    return std::any_of(options_.begin(), options_.end(), [&](const KindOption& one) {
      return one.text && std::find(names.begin(), names.end(), one.name) != names.end();
    });
  }

  /// The command without its kind, and as it is kept in the file; what the options of the kind state is put in place.
  SyntheticCommand read(OptionValues& values) const {
    SyntheticCommand of = command_;
    of.grid.step_x_m = of.grid.step_y_m = values.length("--step", step_, "0.5 um");
    const std::string_view text = points_;
    const std::size_t cross = text.find('x');
    if (cross == std::string_view::npos || !read_whole(text.substr(0, cross), of.grid.points_x) ||
        !read_whole(text.substr(cross + 1), of.grid.points_y) || of.grid.points_x < kFewestPoints ||
        (of.grid.points_y != 1 && of.grid.points_y < kFewestPoints) || of.grid.points_x > kMostPoints ||
        of.grid.points_y > kMostPoints / of.grid.points_x) {
      values.refuse("--points " + points_ + ": this is not a size of a map",
                    "16 or more points in each direction, 2^26 in all, for example --points 512x512");
    }
    if (!read_whole(std::string_view(seed_), of.seed)) {
      values.refuse("--seed " + seed_ + ": this is not a whole number from 0 on", "for example --seed 7");
    }
    of.command_text = "ringfilm synthetic " + kind_ + " --points " + points_ + " --step \"" + step_ + "\"";
    for (const KindOption& one : options_) {
      if (!one.text) continue;
      of.command_text += " " + one.name + " \"" + *one.text + "\"";
      one.put(values, *one.text);
    }
    return of;
  }

 private:
  std::string kind_;
  CLI::App& app_;
  SyntheticCommand command_;
  std::string points_ = "512x512", step_ = "0.5 um", seed_ = "1";
  std::deque<KindOption> options_;  ///< the program keeps references to their texts
};

/// A kind of surface whose options put their values into `of`.
template <class Surface>
struct Kind : SyntheticArguments {
  using SyntheticArguments::SyntheticArguments;
  Surface of;
};

template <class Surface, class Finish>
void add_action(Actions& actions, const std::shared_ptr<Kind<Surface>>& kind, Finish finish) {
  actions.emplace_back(kind->app(), [kind, finish] {
    const io::Units units;
    OptionValues values(units);
    SyntheticCommand command = kind->read(values);
    command.kind = finish(*kind, values);
    values.check();
    synthetic(command);
  });
}

/// The two ways to state a Gaussian surface.
struct StatedGaussian {
  GaussianSurface by_height;
  ContactSurface by_contact;
};
using SyntheticKind = decltype(SyntheticCommand::kind);

SyntheticKind gaussian_of(const Kind<StatedGaussian>& kind, OptionValues& values) {
  if (!kind.is_stated({"--asperity-density", "--asperity-radius", "--roughness", "--sigma"})) return kind.of.by_height;
  if (!kind.is_stated({"--asperity-density"}) || !kind.is_stated({"--asperity-radius"}) ||
      !kind.is_stated({"--roughness"})) {
    values.refuse("--asperity-density, --asperity-radius and --roughness belong together",
                  "give all three, or --sq and --correlation-length");
  } else if (kind.is_stated({"--sq", "--correlation-length", "--rms"})) {
    values.refuse("--sq, --correlation-length and --rms are another way to define the surface",
                  "leave them out, or --asperity-density, --asperity-radius and --roughness");
  }
  return kind.of.by_contact;
}

void add_gaussian(CLI::App& synthetic, Actions& actions) {
  using surface::RmsDefinition, surface::SigmaRule;
  const auto kind = std::make_shared<Kind<StatedGaussian>>(
      synthetic, "gaussian", "A Gaussian surface, by its roughness or by N, beta and sigma");
  auto& [height, contact] = kind->of;
  kind->usual_length("--sq", "rms height", "0.3 um", height.Sq_m);
  kind->usual_length("--correlation-length", "of exp(-r^2/length^2)", "5 um", height.length_m);
  kind->option("--rms", "exact: of this surface (default); expected: over many seeds", "WORD",
               [&rms = height.rms](OptionValues& values, const std::string& text) {
                 rms = values.chosen<RmsDefinition>(
                     "--rms", text, {{"exact", RmsDefinition::exact}, {"expected", RmsDefinition::expected}});
               });
  kind->option("--asperity-density", "target N against a smooth flat", "\"0.05 um-2\"",
               [&density = contact.target.density_per_m2](OptionValues& values, const std::string& text) {
                 density = values.quantity("--asperity-density", text, "m-2", "0.05 um-2");
                 if (density < 0) values.refuse("--asperity-density is below zero", "for example \"0.05 um-2\"");
               });
  kind->length("--asperity-radius", "target beta", "2 um", contact.target.beta_m);
  kind->length("--roughness", "target sigma", "0.4 um", contact.target.sigma_m);
  kind->option("--sigma", "what the target sigma is: Ra (default) or Rq", "WORD",
               [&rule = contact.rule](OptionValues& values, const std::string& text) {
                 rule = values.chosen<SigmaRule>("--sigma", text, {{"Ra", SigmaRule::ra}, {"Rq", SigmaRule::rq}});
               });
  add_action(actions, kind, gaussian_of);
}

void add_honed(CLI::App& synthetic, Actions& actions) {
  const auto kind = std::make_shared<Kind<surface::HonedSurface>>(
      synthetic, "honed", "A plateau-honed liner: a fine plateau cut by crossing grooves");
  surface::HonedSurface& honed = kind->of;
  kind->usual_length("--sq", "rms height of the plateau", "0.08 um", honed.plateau_Sq_m);
  kind->usual_length("--correlation-length", "of the plateau", "5 um", honed.plateau_length_m);
  kind->option("--hatch-angle",
               fmt::format("between both families of grooves; x halves it (default {:.3g} rad)", honed.hatch_angle_rad),
               "\"45 degree\"", [&angle = honed.hatch_angle_rad](OptionValues& values, const std::string& text) {
                 angle = values.quantity("--hatch-angle", text, "rad", "45 degree");
               });
  kind->usual_length("--groove-spacing", "mean", "60 um", honed.groove_spacing_m);
  kind->usual_length("--groove-depth", "mean", "2 um", honed.groove_depth_m);
  kind->usual_length("--groove-width", "at the top", "12 um", honed.groove_width_m);
  add_action(actions, kind, [](const auto& of, OptionValues&) { return of.of; });
}

void add_porous(CLI::App& synthetic, Actions& actions) {
  const auto kind = std::make_shared<Kind<surface::PorousSurface>>(synthetic, "porous",
                                                                   "A sprayed face: a Gaussian surface with pores");
  surface::PorousSurface& porous = kind->of;
  kind->usual_length("--sq", "rms height between the pores", "0.3 um", porous.fine_Sq_m);
  kind->usual_length("--correlation-length", "between the pores", "3 um", porous.fine_length_m);
  kind->option("--pore-share", fmt::format("of the area, 0 to 0.9 (default {})", porous.pore_share), "SHARE",
               [&share = porous.pore_share](OptionValues& values, const std::string& text) {
                 share = values.number("--pore-share", text, 0, 0.9, "0.15");
               });
  kind->usual_length("--pore-length", "correlation length of the pores", "15 um", porous.pore_length_m);
  kind->usual_length("--pore-depth", "mean", "4 um", porous.pore_depth_m);
  add_action(actions, kind, [](const auto& of, OptionValues&) { return of.of; });
}

}  // namespace

void add_synthetic_command(CLI::App& program, Actions& actions) {
  CLI::App* command =
      program.add_subcommand("synthetic", "Make a surface of known statistics, as an instrument's file");
  command->require_subcommand(1);
  command->footer(kSyntheticFooter);
  add_gaussian(*command, actions);
  add_honed(*command, actions);
  add_porous(*command, actions);
}

}  // namespace ringfilm::app
