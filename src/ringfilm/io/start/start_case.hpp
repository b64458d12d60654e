#pragma once
#include <optional>
#include <string>
#include <vector>

/// Cases to start from (`ringfilm new`).
namespace ringfilm::io {

/// What a case to start from is made of.
struct StartOptions {
  std::string engine = "passenger-car";  ///< one of start_engines()
  std::optional<std::string> trace;      ///< file of the cylinder pressure, as named in the working folder
  /// Folder of the case, to which its path of the trace is relative; empty: the working folder.
  std::string case_folder;
};

/// A case as text, and what a trace does not show.
struct StartCase {
  std::string text;
  std::vector<std::string> found;    ///< properties found in the trace, sentences
  std::vector<std::string> missing;  ///< what the user has to state before the case can be run, sentences
  std::vector<std::string> notes;    ///< why the pressures of the trace are improbable, sentences
};

/// The engines for which there are typical numbers.
std::vector<std::string> start_engines();

/// A commented case that states typical numbers, each marked as assumed, and has every other key as a comment. Without
/// a trace it runs unchanged. Throws InputError for an unknown engine and a trace that is not a table of numbers.
StartCase start_case(const StartOptions& options);

}  // namespace ringfilm::io
