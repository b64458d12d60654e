#include "commands/command_contact.hpp"

#include <optional>

#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {

void contact(const ContactCommand& command) {
  check_outputs(command.outputs, command.surfaces);
  const io::Units units;
  const auto first = instrument::read_surface_file(command.surfaces.front(), command.reading, units);
  std::optional<instrument::SurfaceFile> second;
  if (command.surfaces.size() > 1) second = read_surface_file(command.surfaces.back(), command.reading, units);
  const io::Measurement measurement = contact_measurement(first, second ? &*second : nullptr, command.analysis);
  deliver(measurement, command.outputs, numbers_of(measurement), lists_of(measurement, instrument::kContactLawTable));
}

}  // namespace ringfilm::app
