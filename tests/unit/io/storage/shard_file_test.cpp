#include "ringfilm/io/storage/shard_file.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <thread>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/cycle_values.hpp"

namespace ringfilm::io {
namespace {

ShardHeader header() {
  return {std::string(64, 'a'), std::string(64, 'b'), "ringfilm 9.9 commit c compiler d e", 2, 3, 10, 16, 2};
}

study::ScenarioBlock block(std::uint64_t first, std::uint64_t n) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  study::ScenarioBlock block{first, {}};
  for (std::uint64_t i = first; i < first + n; ++i) {
    if (i == 12) {
      block.rows.push_back({{none, none}, "no film at 20 degree\nof the cycle"});
    } else {
      block.rows.push_back({{static_cast<double>(i), 1.0 / static_cast<double>(i)}, ""});
    }
  }
  return block;
}

std::string bytes_of_shard(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Two blocks of three rows each.
std::string whole(const ScratchFolder& folder, const std::string& name) {
  const std::string path = folder / name;
  ShardWriter writer(path, header());
  writer.append(block(10, 3));
  writer.append(block(13, 3));
  return path;
}

TEST(ShardFile, GivesBackWhatWasAppended) {
  const ScratchFolder folder;
  const ShardReader shard(whole(folder, "rows"));
  EXPECT_TRUE(shard.is_complete());
  EXPECT_EQ(shard.header().program, header().program);
  EXPECT_EQ(difference(shard.header(), header()), "");
  std::vector<double> first, second;
  shard.append_values(0, first);
  shard.append_values(1, second);
  ASSERT_EQ(first.size(), 6u);
  for (std::size_t i = 0; i < 6; ++i) {
    if (i == 2) {
      EXPECT_TRUE(std::isnan(first[i]) && std::isnan(second[i]));
    } else {
      EXPECT_EQ(first[i], 10.0 + static_cast<double>(i));
      EXPECT_EQ(second[i], 1.0 / (10.0 + static_cast<double>(i)));
    }
  }
  std::vector<ShardReader::Unsolved> unsolved;
  shard.append_unsolved(unsolved);
  ASSERT_EQ(unsolved.size(), 1u);
  EXPECT_EQ(shard.n_unsolved(), 1u);
  EXPECT_EQ(unsolved.front().scenario, 12u);
  EXPECT_EQ(unsolved.front().reason, "no film at 20 degree of the cycle");
}

TEST(ShardFile, ShowsTheNoteOfTheWorstRowWhereRowsAreCycles) {
  const ScratchFolder folder;
  const std::size_t n_values = cycle::cycle_quantities().size();
  for (const bool has_cycle : {true, false}) {
    const std::string path = folder / (has_cycle ? "cycles" : "packs");
    {
      ShardWriter writer(path, {"plan", "inputs", "program", 1, 1, 0, 2, n_values});
      study::ScenarioBlock block{0, {}, has_cycle};
      for (const double value : {1.0, 2.0}) {
        block.rows.push_back({std::vector<double>(n_values, value), ""});
        block.rows.back().notes = {{"film-pressure-high", value == 1 ? "low" : "high", 1}};
      }
      writer.append(block);
    }
    std::vector<SharedNote> notes;
    ShardReader(path).append_notes({0, 2}, notes);
    ASSERT_FALSE(notes.empty());
    EXPECT_EQ(notes[0].message, has_cycle ? "high" : "low") << "values of packs do not measure notes of cycles";
  }
}

TEST(ShardFile, GivesBackTheNotesOfItsRows) {
  const ScratchFolder folder;
  const std::string path = folder / "rows";
  {
    ShardWriter writer(path, header());
    study::ScenarioBlock five = block(10, 5), last = block(15, 1);
    five.rows[0].notes = {{"film-thin", "at 1 degree", 3}, {"shear-rate-high", "1e7 1/s\nof the cycle", 1}};
    five.rows[4].notes = {{"shear-rate-high", "2e7 1/s", 1}};
    last.rows[0].notes = {{"shear-rate-high", "3e7 1/s", 1}};
    writer.append(five);
    writer.append(last);
  }
  const ShardReader shard(path);
  EXPECT_TRUE(shard.is_complete());
  EXPECT_EQ(shard.n_unsolved(), 1u) << "notes are not reasons";
  std::vector<SharedNote> notes;
  shard.append_notes({10, 16}, notes);
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[0].message, "1e7 1/s of the cycle");
  EXPECT_EQ(notes[0].scenarios, (std::vector<std::uint64_t>{10, 14}));
  EXPECT_EQ(notes[1].topic, "film-thin") << "a topic that is not in the table comes last";
  EXPECT_EQ(notes[1].scenarios, (std::vector<std::uint64_t>{10}));
  EXPECT_EQ(notes[2].message, "3e7 1/s");
  EXPECT_EQ(notes[2].scenarios, (std::vector<std::uint64_t>{15}));
  notes.clear();
  shard.append_notes({11, 15}, notes);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_EQ(notes[0].scenarios, (std::vector<std::uint64_t>{14}));
  EXPECT_EQ(notes[0].first, 10u) << "the scenario of the message, before the range";
}

TEST(ShardFile, ContinuesWhereverItWasCutOff) {
  const ScratchFolder folder;
  const std::string all = bytes_of_shard(whole(folder, "rows"));
  for (std::size_t n = 0; n < all.size(); ++n) {
    const std::string path = folder.write("cut", all.substr(0, n));
    ShardWriter writer(path, header());
    ASSERT_TRUE(writer.next() == 10 || writer.next() == 13) << n;
    if (writer.next() == 10) writer.append(block(10, 3));
    writer.append(block(13, 3));
    ASSERT_EQ(bytes_of_shard(path), all) << n;
  }
}

/// The rows of whole(), written out of turn.
std::string out_of_turn(const ScratchFolder& folder, const std::string& name) {
  const std::string path = folder / name;
  ShardWriter writer(path, header());
  writer.append(block(15, 1));
  writer.append(block(11, 2));
  EXPECT_EQ(writer.next(), 10u);
  EXPECT_EQ(writer.n_rows(), 3u);
  writer.append(block(10, 1));
  EXPECT_EQ(writer.next(), 13u);
  writer.append(block(13, 2));
  EXPECT_EQ(writer.next(), 16u);
  return path;
}

TEST(ShardFile, GivesBackInTheirOrderRowsThatWereAppendedOutOfTurn) {
  const ScratchFolder folder;
  const ShardReader one(whole(folder, "rows")), other(out_of_turn(folder, "out of turn"));
  EXPECT_TRUE(other.is_complete());
  EXPECT_TRUE(other.is_intact());
  EXPECT_TRUE(other.beyond().empty());
  EXPECT_EQ(other.n_rows(), 6u);
  EXPECT_EQ(other.n_unsolved(), one.n_unsolved());
  for (std::size_t i = 0; i < 2; ++i) {
    std::vector<double> first, second;
    one.append_values(i, first);
    other.append_values(i, second);
    first.erase(first.begin() + 2);  // not solved
    second.erase(second.begin() + 2);
    EXPECT_EQ(first, second);
  }
  std::vector<ShardReader::Unsolved> unsolved;
  other.append_unsolved({11, 14}, unsolved);
  EXPECT_EQ(unsolved.size(), 1u);
}

TEST(ShardFile, ContinuesWithTheRowsBeyondAGapWhereverItWasCutOff) {
  const ScratchFolder folder;
  const std::string all = bytes_of_shard(out_of_turn(folder, "rows"));
  for (std::size_t n = 0; n < all.size(); n += 13) {
    const std::string path = folder.write("cut", all.substr(0, n));
    ShardWriter writer(path, header());
    std::set<std::uint64_t> missing = {10, 11, 12, 13, 14, 15};
    for (std::uint64_t i = 10; i < writer.next(); ++i) missing.erase(i);
    for (const study::ScenarioRange& range : writer.beyond()) {
      for (std::uint64_t i = range.first; i < range.end; ++i) ASSERT_EQ(missing.erase(i), 1u) << n;
    }
    ASSERT_EQ(missing.size(), 6 - writer.n_rows()) << n;
    for (const std::uint64_t i : missing) writer.append(block(i, 1));
    ASSERT_EQ(writer.n_unsolved(), 1u) << n;
    const ShardReader shard(path);
    ASSERT_TRUE(shard.is_complete()) << n;
    ASSERT_EQ(shard.n_unsolved(), 1u) << n;
  }
}

TEST(ShardFile, DoesNotReadABlockOverRowsThatAreThere) {
  const ScratchFolder folder;
  const std::string all = bytes_of_shard(whole(folder, "rows"));
  ShardWriter(folder / "empty", header());
  const std::size_t begin = std::filesystem::file_size(folder / "empty");
  const ShardReader shard(folder.write("twice", all + all.substr(begin)));
  EXPECT_TRUE(shard.is_complete());
  EXPECT_FALSE(shard.is_intact());
  EXPECT_EQ(shard.n_rows(), 6u);
}

TEST(ShardFile, FindsACorruptedBlockAnywhere) {
  const ScratchFolder folder;
  const std::string all = bytes_of_shard(whole(folder, "rows"));
  ShardWriter(folder / "empty", header());
  const std::size_t header_size = std::filesystem::file_size(folder / "empty");
  for (std::size_t n = 0; n < all.size(); ++n) {
    std::string corrupted = all;
    corrupted[n] ^= 4;
    const std::string path = folder.write("corrupted", corrupted);
    if (n < header_size) {
      EXPECT_THROW(ShardReader{path}, InputError) << n;
    } else {
      EXPECT_LT(ShardReader(path).next(), 16u) << n;
    }
  }
}

TEST(ShardFile, RefusesRowsOfSomethingElse) {
  const ScratchFolder folder;
  const std::string path = whole(folder, "rows"), before = bytes_of_shard(path);
  ShardHeader plan = header(), inputs = header(), program = header(), part = header(), kernels = header();
  plan.plan[0] = 'x';
  inputs.inputs[0] = 'x';
  program.program = "ringfilm 9.8";
  part.part = 1;
  kernels.kernels = "avx2";
  for (const ShardHeader& other : {plan, inputs, program, part, kernels})
    EXPECT_THROW(ShardWriter(path, other), InputError);
  EXPECT_NE(difference(header(), plan), difference(header(), inputs));
  EXPECT_EQ(bytes_of_shard(path), before);
}

ShardHeader header_with_curves() {
  ShardHeader with = header();
  with.curves = {"power_loss", "total_friction"};
  with.n_angles = 3;
  return with;
}

/// Curves whose numbers state where they are.
study::ScenarioBlock block_with_curves(std::uint64_t first, std::uint64_t n) {
  study::ScenarioBlock with = block(first, n);
  for (std::uint64_t k = 0; k < n; ++k) {
    for (int q = 0; q < 2; ++q)
      for (int a = 0; a < 3; ++a)
        with.rows[k].curves.push_back(static_cast<float>(first + k) + 100.0F * static_cast<float>(q) +
                                      1000.0F * static_cast<float>(a));
  }
  return with;
}

TEST(ShardFile, GivesBackAnyPartOfTheCurves) {
  const ScratchFolder folder;
  const std::string path = folder / "rows";
  {
    ShardWriter writer(path, header_with_curves());
    writer.append(block_with_curves(10, 1));
    writer.append(block_with_curves(11, 3));
    writer.append(block_with_curves(14, 2));
  }
  const ShardReader shard(path);
  EXPECT_EQ(difference(shard.header(), header_with_curves()), "");
  EXPECT_NE(difference(shard.header(), header()), "");
  for (std::uint64_t first = 10; first < 16; ++first) {
    for (std::uint64_t end = first + 1; end <= 16; ++end) {
      const std::uint64_t n = end - first, stride = n + 1;
      std::vector<float> found(2 * stride, -1);
      shard.read_curve(1, 1, 2, {first, end}, found.data(), stride);
      std::vector<double> values(n);
      shard.read_values(0, {first, end}, values.data());
      for (std::uint64_t k = 0; k < n; ++k) {
        EXPECT_EQ(found[k], 1100.0F + static_cast<float>(first + k));
        EXPECT_EQ(found[stride + k], 2100.0F + static_cast<float>(first + k));
        if (first + k == 12) continue;
        EXPECT_EQ(values[k], static_cast<double>(first + k));
      }
      EXPECT_EQ(found[n], -1);  // what lies between two angles is not touched
    }
  }
  std::vector<float> room(100);
  EXPECT_THROW(shard.read_curve(2, 0, 1, {10, 16}, room.data(), 6), std::out_of_range);
  EXPECT_THROW(shard.read_curve(0, 2, 2, {10, 16}, room.data(), 6), std::out_of_range);
  EXPECT_THROW(shard.read_curve(0, 0, 1, {10, 17}, room.data(), 7), std::out_of_range);
  std::vector<ShardReader::Unsolved> unsolved;
  shard.append_unsolved({13, 16}, unsolved);
  EXPECT_TRUE(unsolved.empty());
  shard.append_unsolved({12, 13}, unsolved);
  EXPECT_EQ(unsolved.size(), 1u);
}

ShardHeader alone(std::uint64_t end) {
  ShardHeader h = header();
  h.part = h.parts = 1;
  h.end = end;
  return h;
}

TEST(ShardFile, BecomesLongerWithTheBytesOfTheLongOne) {
  const ScratchFolder folder;
  {
    ShardWriter writer(folder / "long", alone(1016));
    writer.append(block(10, 3));
    writer.append(block(13, 3));
  }
  const std::string path = folder / "rows";
  {
    ShardWriter writer(path, alone(13));
    writer.append(block(10, 3));
  }
  const std::string before = bytes_of_shard(path);
  EXPECT_THROW(ShardWriter(path, alone(1016)), InputError);
  EXPECT_THROW(ShardWriter(path, alone(12), Extension::kAllowed), InputError);
  EXPECT_EQ(bytes_of_shard(path), before);
  {
    ShardWriter writer(path, alone(1016), Extension::kAllowed);
    EXPECT_EQ(writer.next(), 13u);
    EXPECT_EQ(writer.n_unsolved(), 1u);
    EXPECT_THROW(ShardWriter(path, alone(1016)), InputError) << "somebody else may write to it";
    writer.append(block(13, 3));
  }
  EXPECT_EQ(bytes_of_shard(path), bytes_of_shard(folder / "long"));
  ShardHeader of_two = header();
  of_two.end = 1016;
  EXPECT_FALSE(is_beginning_of(header(), of_two)) << "a part of several";
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(std::filesystem::path(path).parent_path()), {}), 2);
}

TEST(ShardFile, LetsOneAlonePutRowsIn) {
  const ScratchFolder folder;
  const ShardWriter writer(folder / "rows", header());
  EXPECT_THROW(ShardWriter(folder / "rows", header()), InputError);
}

TEST(ShardFile, IsReplacedOnceNobodyElseWritesToIt) {
  const ScratchFolder folder;
  const std::string path = whole(folder, "rows");
  ShardHeader other = header();
  other.plan = std::string(64, 'f');
  {
    const ShardWriter first(path, header());
    EXPECT_THROW(ShardWriter(path, other, Extension::kRefused, Rows::kReplaced), InputError);
    EXPECT_TRUE(ShardReader(path).is_complete()) << "rows that somebody writes to are not removed";
  }
  const ShardWriter second(path, other, Extension::kRefused, Rows::kReplaced);
  EXPECT_EQ(second.next(), other.first);
  second.rename(folder / "finished");
  EXPECT_EQ(ShardReader(folder / "finished").header().plan, other.plan);
  EXPECT_THROW(ShardReader{path}, InputError);
}

TEST(ShardFile, IsOpenedWhileAnotherOnlyAsksWhetherItIsWritten) {
  const ScratchFolder folder;
  const std::string path = whole(folder, "rows");
  std::atomic<bool> ends = false;
  std::thread asking([&] {
    while (!ends) {
      try {
        check_not_being_written(path);
      } catch (const InputError&) {
      }
    }
  });
  for (int n = 0; n < 200; ++n) EXPECT_NO_THROW(ShardWriter(path, header())) << n;
  ends = true;
  asking.join();
}

TEST(ShardFile, RefusesInvalidInput) {
  const ScratchFolder folder;
  EXPECT_THROW(ShardReader(folder / "none"), InputError);
  EXPECT_THROW(ShardReader(folder.write("text", std::string(1000, '\xff'))), InputError);
  EXPECT_THROW(ShardReader(folder.write("empty", "")), InputError);
}

}  // namespace
}  // namespace ringfilm::io
