#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measurement_outputs.hpp"
#include "option_values.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/surface/topography/preparation.hpp"

namespace CLI {
class App;
}

namespace ringfilm::app {

/// Commands of the program and what each does once its arguments are read.
using Actions = std::vector<std::pair<CLI::App*, std::function<void()>>>;

/// Splits "key=value" or "key = value"; the value may hold further equal signs. Throws InputError.
io::Override override_of(const std::string& text);

/// Arguments that all measuring commands share: --output, --html, --json and, where there is something for a case,
/// --fragment.
struct OutputArguments {
  MeasurementOutputs outputs;
  bool json = false;

  void add_to(CLI::App& command, bool with_fragment);
  MeasurementOutputs selected() const;
};

/// Arguments of every command that reads height maps: what the file does not state, form and filters.
struct MapArguments {
  instrument::SurfaceOptions reading;
  std::optional<std::string> layout, short_cutoff, long_cutoff;
  std::optional<std::string> form;
  bool robust = false;

  /// @param usual_form as the help prints it
  void add_to(CLI::App& command, const std::string& usual_form);
  instrument::SurfaceOptions selected_reading(OptionValues& values) const;
  /// @param usual_form where none is stated
  surface::Preparation selected_preparation(OptionValues& values, const surface::FormChoice& usual_form) const;

 private:
  surface::FormChoice form_choice(OptionValues& values, const surface::FormChoice& usual_form) const;
};

/// "3x2" as two counts from 1 to 1000. Throws InputError that names the option.
std::pair<std::size_t, std::size_t> counts_of(const std::string& option, const std::string& text);

/// `ringfilm surface` and `ringfilm pair`.
void add_surface_commands(CLI::App& program, Actions& actions);
/// `ringfilm contact`.
void add_contact_command(CLI::App& program, Actions& actions);
/// `ringfilm conform`.
void add_conform_command(CLI::App& program, Actions& actions);
/// `ringfilm face`.
void add_face_command(CLI::App& program, Actions& actions);
/// `ringfilm lateral-force`.
void add_lateral_force_command(CLI::App& program, Actions& actions);
/// `ringfilm synthetic`.
void add_synthetic_command(CLI::App& program, Actions& actions);
/// `ringfilm study`.
void add_study_command(CLI::App& program, Actions& actions);
/// `ringfilm life`.
void add_life_command(CLI::App& program, Actions& actions);

}  // namespace ringfilm::app
