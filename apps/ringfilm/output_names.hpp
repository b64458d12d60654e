#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::app {

/// What a command writes to a file.
enum class OutputKind { kNetcdf, kPage, kCsv, kToml };

/// Throws InputError for a name that ends like a file of another kind, as the program names them: .nc, .html, .csv and
/// .toml. Other endings are allowed, and none.
/// @param option with which the name is given, "--output"
void check_suffix(const std::string& option, const std::string& path, OutputKind kind);

/// Claims the outputs that are named for a command that computes for long. Throws InputError where another process
/// computes one of them now.
[[nodiscard]] std::vector<io::OutputClaim> claims(const std::vector<std::optional<std::string>>& outputs);

/// Do the two names lead to one file, existing or not?
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace ringfilm::app
