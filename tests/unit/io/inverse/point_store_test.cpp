#include "ringfilm/io/inverse/point_store.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace {

using ringfilm::InputError;
using ringfilm::io::PointStore;
using ringfilm::io::ScratchFolder;
using ringfilm::io::StoredPoint;

StoredPoint point(double value) { return {"", {{"fmep", value}, {"nothing", NAN}}, {-360, 0}, {{"f", {1. / 3, 2}}}}; }

TEST(PointStore, PointsComeBackToTheLastBit) {
  const ScratchFolder folder;
  const std::string path = folder / "points.jsonl";
  {
    PointStore store(path);
    store.add("a", point(0.1));
    store.add("b", {"no film", {}, {}, {}});
  }
  const PointStore store(path);
  EXPECT_EQ(store.n_read(), 2u);
  EXPECT_EQ(store.find("a")->values.at("fmep"), 0.1);
  EXPECT_TRUE(std::isnan(store.find("a")->values.at("nothing")));
  EXPECT_EQ(store.find("a")->curves.at("f"), (std::vector<double>{1. / 3, 2}));
  EXPECT_EQ(store.find("b")->reason, "no film");
  EXPECT_FALSE(store.find("c"));
}

TEST(PointStore, LineThatWasCutOffIsRemoved) {
  const ScratchFolder folder;
  const std::string path = folder / "points.jsonl";
  {
    PointStore store(path);
    store.add("a", point(0.1));
    store.add("b", point(0.2));
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 5);
  {
    PointStore store(path);
    EXPECT_EQ(store.n_read(), 1u);
    store.add("b", point(0.3));
  }
  const PointStore store(path);
  EXPECT_EQ(store.find("b")->values.at("fmep"), 0.3);
}

TEST(PointStore, FileOfAnotherKindIsRefused) {
  const ScratchFolder folder;
  const std::string path = folder / "points.jsonl";
  std::ofstream(path) << "title = \"a case that somebody named so, longer than the first line\"\n";
  EXPECT_THROW(PointStore{path}, InputError);
  EXPECT_GT(std::filesystem::file_size(path), 0u);
}

TEST(PointStore, SecondWriterIsRefused) {
  const ScratchFolder folder;
  const std::string path = folder / "points.jsonl";
  const PointStore store(path);
  EXPECT_THROW(PointStore{path}, InputError);
}

}  // namespace
