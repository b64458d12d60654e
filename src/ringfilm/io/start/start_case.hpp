#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ringfilm/io/start/start_engine.hpp"
#include "ringfilm/io/table/text_table.hpp"

/// Cases to start from (`ringfilm new`).
namespace ringfilm::io {

/// What a case to start from is made of.
struct StartOptions {
  std::string engine = kDefaultEngine;  ///< one of start_engines(), or a file of an own one (.toml)
  std::string load = "full";            ///< one of start_loads()
  std::string state = "run-in";         ///< state of surfaces and top ring's face, one of start_states()
  bool is_pack = false;                 ///< all rings of the engine, in place of the top ring alone
  std::optional<std::string> trace{};   ///< file of the cylinder pressure, as named in the working folder
  /// Folder of the case, to which its path of the trace is relative; empty: the working folder.
  std::string case_folder{};
  TableReading trace_table{};  ///< how the trace is read
  bool has_all_keys = false;   ///< every other key as a comment, in the case of a ring
};

/// A case as text, and what a trace does not show.
struct StartCase {
  std::string text;
  std::vector<std::string> found;    ///< properties found in the trace, sentences
  std::vector<std::string> missing;  ///< what the user has to state before the case can be run, sentences
  std::vector<std::string> notes;    ///< why the pressures of the trace are improbable, sentences
};

std::vector<std::string> start_loads();   ///< part and full load
std::vector<std::string> start_states();  ///< new, run-in and worn

/// A case that states what a person must decide, in typical numbers, each with its source or marked as assumed; that of
/// a pack with the shipped rings. Without a trace it runs unchanged. Throws InputError for an unknown engine, load or
/// state and a trace that is not a table of numbers.
StartCase start_case(const StartOptions& options);

/// A study of a case to start from at the weighted operating points of its engine: part load and full load at low and
/// high speed. @param case_path the case, as the study names it
std::string start_points(const StartOptions& options, const std::string& case_path);

}  // namespace ringfilm::io
