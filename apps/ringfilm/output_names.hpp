#pragma once
#include <optional>
#include <string>
#include <vector>

#include "faults.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::app {

/// What a command writes to a file.
enum class OutputKind { kNetcdf, kPage, kCsv, kToml };

/// Throws InputError for a name that ends like a file of another kind, as the program names them: .nc, .html, .csv and
/// .toml. Other endings are allowed, and none.
/// @param option with which the name is given, "--output"
void check_suffix(const std::string& option, const std::string& path, OutputKind kind);

/// A file that a command may write.
struct NamedOutput {
  std::string option;               ///< with which it is named, "--output"
  std::optional<std::string> path;  ///< nothing: it is not written
  std::optional<OutputKind> kind;   ///< nothing: it may end like any
  io::Sink sink = io::Sink::kFile;
};

/// Refuses outputs that end like a file of another kind, and those that cannot be written.
void check_names(const std::vector<NamedOutput>& outputs, Faults& faults);

/// Refuses outputs that are among the files that the case or life is read from, and two that are one file.
/// @param document "case" or "life"
void check_apart(const std::vector<NamedOutput>& outputs, const std::vector<cycle::InputFile>& files,
                 const std::string& document, Faults& faults);

/// Claims the outputs for a command that computes for long. Throws InputError where another process computes one of
/// them now.
[[nodiscard]] std::vector<io::OutputClaim> claims(const std::vector<NamedOutput>& outputs);

/// Prints a line "wrote X.nc" for each output.
void print_written(const std::vector<NamedOutput>& outputs);

/// Do the two names lead to one file, existing or not?
bool is_same_file(const std::string& a, const std::string& b);

}  // namespace ringfilm::app
