#pragma once
#include <string>
#include <vector>

#include "ringfilm/case/case.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/table/text_table.hpp"
#include "ringfilm/io/text/units.hpp"

namespace ringfilm::io {

/// The keys of [gas] for a trace.
struct TraceKeys {
  std::vector<StartValue> values;    ///< those without a value are to be stated by the user
  std::vector<std::string> found;    ///< what the file shows, sentences
  std::vector<std::string> missing;  ///< what it does not show, a sentence for each of them
  std::vector<std::string> notes;    ///< why its pressures are improbable, sentences
};

/// Looks at the file of a cylinder pressure: its columns, their units, which dead centre is its zero, whether it covers
/// a cycle, whether its pressures can be those of an engine. @param path as named in the working folder @param
/// case_folder to which the case names it @param engine in whose cylinder it was measured
/// @param stated how the file is read, which becomes keys of the case. Throws InputError
/// for a file that is not a table of numbers, has no crank angle or pressure, or breaks a rule on traces whatever the
/// case states.
TraceKeys trace_keys(const std::string& path, const std::string& case_folder, const cycle::Engine& engine,
                     const Units& units, const TableReading& stated = {});

}  // namespace ringfilm::io
