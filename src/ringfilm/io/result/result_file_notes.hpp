#pragma once
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

/// What a result file holds of the notes: a part of the description in result_file_layout.hpp.
namespace ringfilm::io {

/// @param of_input those of reading the case @param of_result those on the result
template <class File, class Texts, class Notes>
void exchange_notes(File& file, Texts& of_input, Notes& of_result) {
  file.texts("input_note", text("input_note_message", "note on the input files of the case"), of_input);
  file.rows("note", of_result);
  file.column("note", text("note_topic", "stable word for the note"), of_result, &cycle::Note::topic);
  file.column("note", text("note_message", "what the user must know about this result"), of_result,
              &cycle::Note::message);
  file.column("note", count("note_count", "crank steps or evaluations concerned"), of_result, &cycle::Note::count);
}

}  // namespace ringfilm::io
