#include "ringfilm/cycle/advice/note_topics.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <regex>
#include <set>

namespace ringfilm::cycle {
namespace {

TEST(NoteTopics, AreListedOnceAndMeasuredByValuesOfTheCycle) {
  std::set<std::string> names;
  for (const NoteTopic& topic : note_topics()) {
    EXPECT_TRUE(names.insert(topic.name).second) << topic.name;
    if (topic.measure == nullptr) continue;
    EXPECT_TRUE(cycle_quantity_index(topic.measure)) << topic.measure;
  }
}

TEST(NoteTopics, ResultsThatCannotBeTrustedComeFirst) {
  for (std::size_t i = 1; i < note_topics().size(); ++i) {
    EXPECT_LE(note_topics()[i - 1].trust, note_topics()[i].trust) << note_topics()[i].name;
  }
}

TEST(NoteTopics, SortingKeepsTheOrderWithinATopic) {
  std::vector<Note> notes = {{"of-my-own", "", 1},
                             {"density-extrapolated", "", 1},
                             {"gas-pressure-low", "first", 1},
                             {"film-below-molecules", "", 1},
                             {"gas-pressure-low", "second", 1}};
  sort_notes(notes);
  std::string order;
  for (const Note& note : notes) order += note.topic + " " + note.message + "; ";
  EXPECT_EQ(order,
            "film-below-molecules ; gas-pressure-low first; gas-pressure-low second; density-extrapolated ; "
            "of-my-own ; ");
}

TEST(NoteTopics, AThinnerFilmIsWorse) {
  std::vector<double> thin(cycle_quantities().size(), 1), thinner = thin;
  thinner[*cycle_quantity_index("min_film_thickness")] = 0.5;
  EXPECT_GT(note_badness("film-below-molecules", thinner), note_badness("film-below-molecules", thin));
  EXPECT_FALSE(note_badness("synthetic-trace", thin));
  thinner[*cycle_quantity_index("min_film_thickness")] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(note_badness("film-below-molecules", thinner));
}

// Every topic of which the sources make a note is in the table.
TEST(NoteTopics, OfTheSourcesAreAllThere) {
  const std::regex made(R"re((?:notes\.push_back\(\s*\{|\bnote\(|Limit::Allowed::\w+,)\s*"([a-z]+(?:-[a-z]+)+)")re");
  std::set<std::string> found;
  for (const char* folder : {"cycle", "pad", "study"}) {
    const std::string path = std::string(RINGFILM_SOURCE_FOLDER "/src/ringfilm/") + folder;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(path)) {
      if (!entry.is_regular_file()) continue;
      std::ifstream stream(entry.path());
      const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
      for (std::sregex_iterator one(text.begin(), text.end(), made), end; one != end; ++one) found.insert((*one)[1]);
    }
  }
  EXPECT_GT(found.size(), 30u);
  for (const std::string& topic : found) EXPECT_NE(note_topic(topic), nullptr) << topic;
}

}  // namespace
}  // namespace ringfilm::cycle
