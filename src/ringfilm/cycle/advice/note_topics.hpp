#pragma once
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ringfilm/cycle/result/result.hpp"

namespace ringfilm::cycle {

/// How far a result with a note can be trusted.
enum class Trust {
  kNone,     ///< the result is not that of a ring or pad, or the models do not hold for it
  kLimited,  ///< a part of the result is uncertain, or the input contradicts itself
  kFull,     ///< something that should be known; the numbers are as good as without the note
};

/// What Note::count counts.
enum class NoteCount {
  kCrankAngles,  ///< crank angles of one cycle; instants of a pad
  kCase,         ///< nothing: the note is on the case as a whole
  kOccurrences,  ///< steps, films or evaluations
};

/// Which end of a value is the bad one.
enum class BadEnd { kMin, kMax };

/// What holds for all notes of one topic.
struct NoteTopic {
  const char* name;               ///< Note::topic
  Trust trust;                    ///< in a result that carries the note
  NoteCount count;                ///< what the note counts
  const char* measure = nullptr;  ///< value of the cycle by which two results compare; nullptr: there is none
  BadEnd bad_end = BadEnd::kMax;  ///< which end of the range of `measure` is bad
};

/// All topics of notes on results of cycles and pads, the most serious first: the order of all lists of notes.
const std::vector<NoteTopic>& note_topics();

/// The entry of a topic; nullptr where it has none.
const NoteTopic* note_topic(const std::string& topic);

/// Place of a topic in note_topics(); topics without an entry come last.
std::size_t note_rank(const std::string& topic);

/// The most serious note first; notes of one topic stay in their order.
void sort_notes(std::vector<Note>& notes);

/// How bad a result is of those that carry a note of this topic; the larger the worse. Nothing without a measure, and
/// where its value is not finite.
/// @param value the cycle value of that index in cycle_quantities()
std::optional<double> note_badness(const std::string& topic, const std::function<double(std::size_t)>& value);
/// @param values in the order of cycle_quantities()
std::optional<double> note_badness(const std::string& topic, std::span<const double> values);

}  // namespace ringfilm::cycle
