#pragma once
#include <string>

#include "ringfilm/io/text/toml_tree.hpp"

namespace ringfilm::io {

/// What a TOML file of the user describes.
enum class DocumentKind { kCase, kStudy, kLife, kOil, kFit, kOptimisation };

/// Refuses a file of another kind, by its keys at the top: it has one or more that only that kind has, and not one
/// that only the expected kind has. A file of keys that no kind has passes, for its reader to report each.
/// Throws InputError, which names the command that reads such a file. @param path as messages name the file
void check_document_kind(const TomlValue& root, DocumentKind expected, const std::string& path);

}  // namespace ringfilm::io
