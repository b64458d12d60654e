#pragma once
#include <string>

/// Texts that are written from the table of case keys.
namespace ringfilm::io {

/// A commented, complete case that runs unchanged (`ringfilm new`): Wiebe cycle, parabolic face, oil by its values.
/// Every key is in it; those of other models as comments.
std::string starting_case();

/// The table of case keys for a terminal (`ringfilm fields`): key, unit, default, range, meaning, when it is in use.
std::string fields_table();

/// The same as Markdown tables, one a section, for the manual.
std::string fields_markdown();

}  // namespace ringfilm::io
