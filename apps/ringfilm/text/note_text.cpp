#include "text/note_text.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/base/joined.hpp"
#include "ringfilm/cycle/advice/note_topics.hpp"
#include "text/wrapped_text.hpp"

namespace ringfilm::app {
namespace {

cycle::Trust trust_with(const cycle::Note& note) {
  const cycle::NoteTopic* topic = cycle::note_topic(note.topic);
  return topic == nullptr ? cycle::Trust::kFull : topic->trust;
}

std::string in_words(std::string topic) {
  if (topic == "input") return "how files were read";
  std::replace(topic.begin(), topic.end(), '-', ' ');
  return topic;
}

std::ptrdiff_t n_lines(const std::string& text) { return std::count(text.begin(), text.end(), '\n'); }

}  // namespace

NoteText::NoteText(const std::vector<const io::ResultDocument*>& rings, const std::vector<std::string>& labels)
    : n_rings_(rings.size()) {
  for (std::size_t i = 0; i < rings.size(); ++i) {
    std::vector<cycle::Note> notes = rings[i]->result.notes;
    for (const std::string& note : rings[i]->input_notes) notes.push_back({"input", note, 1});
    for (const cycle::Note& note : notes) {
      const auto same = std::find_if(notes_.begin(), notes_.end(), [&](const One& one) {
        return one.note.topic == note.topic && (note.topic != "input" || one.note.message == note.message);
      });
      if (same == notes_.end()) {
        notes_.push_back({note, labels[i], {}});
      } else if (labels[i] != same->label && std::ranges::find(same->others, labels[i]) == same->others.end()) {
        same->others.push_back(labels[i]);
      }
    }
  }
  std::stable_sort(notes_.begin(), notes_.end(), [](const One& a, const One& b) {
    return cycle::note_rank(a.note.topic) < cycle::note_rank(b.note.topic);
  });
}

std::string NoteText::verdict() const {
  std::vector<std::string> invalid, limited;
  for (const One& one : notes_) {
    const cycle::Trust trust = trust_with(one.note);
    if (trust == cycle::Trust::kNone) invalid.push_back(in_words(one.note.topic));
    if (trust == cycle::Trust::kLimited) limited.push_back(in_words(one.note.topic));
  }
  const std::string text = !invalid.empty()   ? "the models do not hold here: " + joined(invalid, ", ")
                           : !limited.empty() ? "limited by: " + joined(limited, ", ")
                                              : "no note limits the result";
  return wrapped(words("verdict: " + text));
}

std::string NoteText::most_serious(std::size_t max_lines) const {
  std::string text;
  std::vector<std::string> others;
  for (const One& one : notes_) {
    const std::string also = one.others.empty()                  ? ""
                             : one.others.size() + 1 == n_rings_ ? " (all others, too)"
                                                                 : " (" + joined(one.others, ", ") + ", too)";
    const std::string of = one.label.empty() ? "" : one.label + also + ": ";
    const std::string line = wrapped(words("note: " + of + one.note.message));
    if (others.empty() && static_cast<std::size_t>(n_lines(text) + n_lines(line)) <= max_lines) {
      text += line;
    } else {
      others.push_back(in_words(one.note.topic));
    }
  }
  if (others.empty()) return text;
  return text + wrapped(words(fmt::format("{} more {}: {}", others.size(), others.size() == 1 ? "note" : "notes",
                                          joined(others, ", "))));
}

}  // namespace ringfilm::app
