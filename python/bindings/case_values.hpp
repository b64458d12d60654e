#pragma once
#include <optional>
#include <string>

#include "bindings.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/io/text/toml_tree.hpp"

/// Values of case keys as Python has them.
namespace ringfilm::python {

/// Is it a key without which there is no case, and does this case not state it?
bool is_missing(const cycle::Field& field, const cycle::Case& c);

/// The value of a key in SI: a float, an int, a str, a list, None where the case has none.
py::object si_value(const cycle::Field& field, const cycle::Case& c);

/// What a user assigns, as a case file would have it: a text as it is; a number of a key without unit, or whose SI unit
/// is the one that people write; ringfilm.SI(...) of any key; nothing for None. Throws InputError for a number that
/// lacks its unit, py::type_error.
std::optional<io::TomlValue> toml_value(const py::handle& value, const cycle::Field& field);

/// A value as TOML has it on the right-hand side.
std::string written(const io::TomlValue& value);

/// The value of a key and all that belongs to it, exactly; for pickles.
py::object stored_value(const cycle::Field& field, const cycle::Case& c);
/// Its inverse.
void restore_value(const cycle::Field& field, const py::handle& stored, cycle::Case& c);

}  // namespace ringfilm::python
