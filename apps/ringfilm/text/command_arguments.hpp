#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "measurement_outputs.hpp"

namespace CLI {
class App;
}

namespace ringfilm::app {

/// Commands of the program and what each does once its arguments are read.
using Actions = std::vector<std::pair<CLI::App*, std::function<void()>>>;

/// Arguments that all measuring commands share: --output, --html, --json and, where there is something for a case,
/// --fragment.
struct OutputArguments {
  MeasurementOutputs outputs;
  bool json = false;

  void add_to(CLI::App& command, bool with_fragment);
  MeasurementOutputs selected() const;
};

/// `ringfilm surface` and `ringfilm pair`.
void add_surface_commands(CLI::App& program, Actions& actions);
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
