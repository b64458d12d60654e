#include <fmt/format.h>

#include <filesystem>
#include <iostream>

#include "commands/commands.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/integration/setup.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/pad/pad_setup.hpp"

namespace ringfilm::app {

void check(const CheckOptions& options) {
  const cycle::Case input = io::read_case(options.case_path, options.overrides);
  const bool is_pad = input.problem == cycle::Problem::kPad;
  if (is_pad) pad::prepare_pad(input);
  std::vector<cycle::Note> notes;
  if (!is_pad && !input.is_pack()) notes = cycle::prepare(input).notes;
  for (std::size_t i = 0; i < input.rings.size(); ++i) {
    for (cycle::Note note : cycle::prepare(input.rings[i]).notes) {
      note.message = fmt::format("ring {}: {}", i + 1, note.message);
      notes.push_back(std::move(note));
    }
  }
  int n_stated = 0, n_assumed = 0;
  for (const io::CaseEntry& entry : io::case_entries(input)) ++(entry.assumed ? n_assumed : n_stated);
  std::cout << options.case_path << ": no errors; " << n_stated << " keys stated, " << n_assumed << " assumed\n";
  for (const io::CaseEntry& entry : io::case_entries(input)) {
    if (entry.assumed) std::cout << fmt::format("  assumed {} = {}  ({})\n", entry.key, entry.shown, entry.help);
  }
  for (const std::string& note : input.notes) std::cout << "note: " << note << "\n";
  for (const cycle::Note& note : notes) std::cout << "note: " << note.message << "\n";
}

void fields() { std::cout << io::fields_table(); }

void start_case(const std::string& path) {
  io::check_can_write(path, io::Sink::kFile);
  std::error_code error;
  if (std::filesystem::exists(path, error)) {
    throw InputError(path + ": this file exists already", "name one that does not, nothing is replaced here");
  }
  io::write_atomically(path, io::starting_case());
  std::cout << "wrote " << path << "\nnext: ringfilm run " << path << "\n";
}

}  // namespace ringfilm::app
