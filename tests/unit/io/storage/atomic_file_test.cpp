#include "ringfilm/io/storage/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <thread>
#include <vector>

#include "../scratch_folder.hpp"
#include "ringfilm/base/error.hpp"

namespace ringfilm::io {
namespace {

using testing::HasSubstr;

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::set<std::string> names_in(const ScratchFolder& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

/// The number of a process that has ended.
long ended_process() {
  const pid_t child = ::fork();
  if (child == 0) ::_exit(0);
  ::waitpid(child, nullptr, 0);
  return child;
}

std::string refusal_of_writing(const std::string& path) {
  try {
    check_can_write(path, Sink::kFile);
  } catch (const InputError& error) {
    return error.what();
  }
  return "not refused";
}

TEST(AtomicFile, ReplacesAndLeavesNothingElse) {
  const ScratchFolder folder;
  write_atomically(folder / "a.txt", "first");
  write_atomically(folder / "a.txt", "second");
  EXPECT_EQ(text_of(folder / "a.txt"), "second");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, RemovesPartialFilesOfEndedWritersOnly) {
  const ScratchFolder folder;
  const std::string ended = folder / ("a.txt.partial-" + std::to_string(ended_process()));
  const std::string alive = folder / ("a.txt.partial-" + std::to_string(::getppid()));
  const std::string of_another_file = folder / ("b.txt.partial-" + std::to_string(ended_process()));
  const std::string of_a_person = folder / "a.txt.partial-copy";
  for (const auto& path : {ended, alive, of_another_file, of_a_person}) std::ofstream(path) << "half";
  write_atomically(folder / "a.txt", "whole");
  EXPECT_FALSE(std::filesystem::exists(ended));
  EXPECT_TRUE(std::filesystem::exists(alive));
  EXPECT_TRUE(std::filesystem::exists(of_another_file));
  EXPECT_TRUE(std::filesystem::exists(of_a_person));
}

TEST(AtomicFile, AClaimKeepsOthersFromItsFileAloneAndLeavesNothing) {
  const ScratchFolder folder;
  const std::string ended = folder / ("a.txt.partial-" + std::to_string(ended_process()));
  std::ofstream(ended) << "half";
  {
    const OutputClaim claim(folder / "a.txt");
    EXPECT_FALSE(std::filesystem::exists(ended));
    try {
      const OutputClaim another(folder.path() + "/./a.txt");
      ADD_FAILURE() << "two claims to one file";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("a.txt: another process computes this file now"));
      EXPECT_THAT(error.what(), HasSubstr("name another output"));
    }
    const OutputClaim of_another_file(folder / "b.txt"), of_a_device("/dev/null");
    write_atomically(folder / "a.txt", "whole");
  }
  EXPECT_EQ(text_of(folder / "a.txt"), "whole");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.txt"});
  EXPECT_NO_THROW(OutputClaim(folder / "a.txt"));
}

TEST(AtomicFile, OfManyClaimsAtOnceOneHolds) {
  const ScratchFolder folder;
  constexpr int kThreads = 8;
  std::atomic<int> n_held = 0, n_refused = 0;
  {
    std::vector<std::jthread> threads;
    for (int i = 0; i < kThreads; ++i) {
      threads.emplace_back([&] {
        try {
          const OutputClaim claim(folder / "a.txt");
          ++n_held;
          while (n_held + n_refused < kThreads) std::this_thread::yield();
        } catch (const InputError&) {
          ++n_refused;
        }
      });
    }
  }
  EXPECT_EQ(n_held, 1);
  EXPECT_EQ(n_refused, kThreads - 1);
}

TEST(AtomicFile, LeavesTheOldFileIfItIsNotPutInPlace) {
  const ScratchFolder folder;
  write_atomically(folder / "a.txt", "old");
  {
    const AsideFile file(folder / "a.txt");
    std::ofstream(file.path()) << "half";
  }
  EXPECT_EQ(text_of(folder / "a.txt"), "old");
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, NeverMixesTwoWritersOfOneName) {
  const ScratchFolder folder;
  const std::vector<std::string> contents = {std::string(3000000, 'a'), std::string(2000000, 'b')};
  std::vector<std::thread> writers;
  for (const std::string& content : contents) {
    writers.emplace_back([&] {
      for (int i = 0; i < 10; ++i) write_atomically(folder / "a.txt", content);
    });
  }
  for (auto& writer : writers) writer.join();
  EXPECT_THAT(contents, testing::Contains(text_of(folder / "a.txt")));
  EXPECT_EQ(names_in(folder), std::set<std::string>{"a.txt"});
}

TEST(AtomicFile, FollowsASymbolicLink) {
  const ScratchFolder folder;
  std::ofstream(folder / "real.txt") << "before";
  std::filesystem::create_symlink("real.txt", folder / "link.txt");
  write_atomically(folder / "link.txt", "after");
  EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
  EXPECT_EQ(text_of(folder / "real.txt"), "after");
}

TEST(AtomicFile, LeavesADeviceADevice) {
  write_atomically("/dev/null", "nothing");
  struct stat status {};
  ASSERT_EQ(::stat("/dev/null", &status), 0);
  EXPECT_TRUE(S_ISCHR(status.st_mode));
}

TEST(AtomicFile, FullDiskIsAnOutputErrorWithItsReason) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  try {
    write_atomically("/dev/full", "something");
    FAIL() << "not noticed";
  } catch (const OutputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/dev/full"));
    EXPECT_THAT(error.what(), HasSubstr("No space left"));
  }
}

TEST(AtomicFile, MissingFolderIsAnOutputErrorAfterTheRunAndAnInputErrorBefore) {
  const ScratchFolder folder;
  EXPECT_THROW(write_atomically(folder / "none/a.txt", "text"), OutputError);
  EXPECT_THAT(refusal_of_writing(folder / "none/a.txt"), HasSubstr("does not exist"));
}

TEST(AtomicFile, FoldersAndUnwritablePlacesAreRefusedBeforehand) {
  const ScratchFolder folder;
  EXPECT_THAT(refusal_of_writing(folder.path()), HasSubstr("this is a folder"));
  std::ofstream(folder / "file") << "text";
  EXPECT_THAT(refusal_of_writing(folder / "file/a.txt"), HasSubstr("is not a folder"));
  EXPECT_THAT(refusal_of_writing("/dev/null"), HasSubstr("device"));
  EXPECT_NO_THROW(check_can_write("/dev/null", Sink::kFileOrDevice));
  EXPECT_EQ(refusal_of_writing(folder / "a.txt"), "not refused");
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_read | std::filesystem::perms::owner_exec);
  EXPECT_THAT(refusal_of_writing(folder / "a.txt"), HasSubstr("not writable"));
  std::filesystem::permissions(folder.path(), std::filesystem::perms::owner_all);
}

TEST(AsideFile, ReservedSpaceDoesNotShowInTheFile) {
  const ScratchFolder folder;
  const std::string path = folder / "a";
  AsideFile aside(path);
  aside.reserve(1 << 20);
  std::ofstream(aside.path(), std::ios::app) << "short";
  aside.put_in_place();
  EXPECT_EQ(std::filesystem::file_size(path), 5u);
}

TEST(AsideFile, MissingSpaceIsRefused) {
  const ScratchFolder folder;
  AsideFile aside(folder / "a");
  EXPECT_THROW(aside.reserve(std::uint64_t{1} << 60), OutputError);
}

}  // namespace
}  // namespace ringfilm::io
