#include "commands/command_contact.hpp"

#include <optional>

#include "ringfilm/base/error.hpp"
#include "ringfilm/instrument/documents/contact_of_case.hpp"
#include "ringfilm/io/measurement/contact_law_file.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::app {

namespace {

void deliver_law(const io::Measurement& measurement, const MeasurementOutputs& outputs) {
  deliver(measurement, outputs, numbers_of(measurement), lists_of(measurement, io::kContactLawTable));
}

/// A file is for a case to read; what is only shown has a note.
void check_law(io::Measurement& measurement, const MeasurementOutputs& outputs) {
  try {
    io::check_contact_law(measurement);
  } catch (const InputError& refusal) {
    if (outputs.netcdf) throw;
    const Fault& fault = refusal.faults().front();
    measurement.notes.push_back(fault.message + "; " + fault.remedy);
  }
}

}  // namespace

void contact(const ContactCommand& command) {
  if (command.case_path) {
    const auto claimed = claimed_outputs(command.outputs, {*command.case_path});
    const cycle::Case input = case_with_settings(*command.case_path, command.settings);
    return deliver_law(instrument::contact_of_case(input, command.lambda), command.outputs);
  }
  const auto claimed = claimed_outputs(command.outputs, command.surfaces);
  const io::Units units;
  const auto first = instrument::read_surface_file(command.surfaces.front(), command.reading, units);
  std::optional<instrument::SurfaceFile> second;
  if (command.surfaces.size() > 1) second = read_surface_file(command.surfaces.back(), command.reading, units);
  io::Measurement measurement = contact_measurement(first, second ? &*second : nullptr, command.analysis);
  check_law(measurement, command.outputs);
  deliver_law(measurement, command.outputs);
}

}  // namespace ringfilm::app
