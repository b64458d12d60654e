#include "ringfilm/instrument/formats/gwyddion_program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>

#include "written_files.hpp"

namespace ringfilm::instrument {
namespace {

using testing::HasSubstr;

/// A shell script in the place of gwyddion, in a folder that PATH and TMPDIR lead to.
class FalseGwyddion {
 public:
  explicit FalseGwyddion(const std::string& script)
      : path_before_(std::getenv("PATH")), temporary_before_(std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp") {
    folder_.write("gwyddion", "#!/bin/sh\n" + script);
    std::filesystem::permissions(folder_ / "gwyddion", std::filesystem::perms::owner_all);
    std::filesystem::create_directory(folder_ / "scratch");
    file_ = folder_.write("a.di", "x");
    ::setenv("PATH", folder_.path().c_str(), 1);
    ::setenv("TMPDIR", (folder_ / "scratch").c_str(), 1);
  }
  FalseGwyddion(const FalseGwyddion&) = delete;
  FalseGwyddion& operator=(const FalseGwyddion&) = delete;
  ~FalseGwyddion() {
    ::setenv("PATH", path_before_.c_str(), 1);
    ::setenv("TMPDIR", temporary_before_.c_str(), 1);
  }

  std::string converted(const ConversionLimits& limits = {}) const { return *converted_by_gwyddion(file_, limits); }

  std::string refusal(const ConversionLimits& limits = {}) const {
    try {
      converted(limits);
    } catch (const InputError& error) {
      return describe(error.faults());
    }
    return "";
  }

  bool left_nothing() const { return std::filesystem::is_empty(folder_ / "scratch"); }

  /// The process that the script named in the file "process" beside its input; 0 as long as there is none.
  pid_t process() const {
    pid_t number = 0;
    std::ifstream(folder_ / "process") >> number;
    return number;
  }

 private:
  std::string path_before_, temporary_before_;
  ScratchFolder folder_;
  std::string file_;
};

constexpr const char* kCopies = "printf GWYP >\"${1#--convert-to-gwy=}\"\n";
constexpr const char* kSleeps = "echo $$ >\"${2%/*}/aside\"; mv \"${2%/*}/aside\" \"${2%/*}/process\"\nexec sleep 60\n";

/// Does `condition` hold within ten seconds?
template <class Condition>
bool soon(Condition condition) {
  const timespec pause{0, 5000000};
  for (int i = 0; i < 2000; ++i) {
    if (condition()) return true;
    ::nanosleep(&pause, nullptr);
  }
  return false;
}

TEST(GwyddionProgram, ASlowConversionIsStopped) {
  const FalseGwyddion slow("sleep 30\n");
  ConversionLimits limits;
  limits.seconds = 0.2;
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(slow.refusal(limits), HasSubstr("gwyddion was stopped after 0.2 s"));
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(), 10);
  EXPECT_TRUE(slow.left_nothing());
}

TEST(GwyddionProgram, IsBoundFromItsFirstStep) {
  // The bounds as its first command sees them.
  const FalseGwyddion telling("{ ulimit -v; ulimit -c; } | tr '\\n' ' ' >\"${1#--convert-to-gwy=}\"\n");
  ConversionLimits limits;
  limits.memory_bytes = std::size_t{3} << 30;
  EXPECT_EQ(telling.converted(limits), "3145728 0 ");
}

TEST(GwyddionProgram, IsUnderstoodWhereEndedProcessesAreNotReported) {
  struct sigaction ignored {
  }, before{};
  ignored.sa_handler = SIG_IGN;
  ASSERT_EQ(::sigaction(SIGCHLD, &ignored, &before), 0);
  EXPECT_EQ(FalseGwyddion(kCopies).refusal(), "");
  EXPECT_THAT(FalseGwyddion("exit 1\n").refusal(), HasSubstr("gwyddion cannot read the file"));
  ::sigaction(SIGCHLD, &before, nullptr);
}

TEST(GwyddionProgram, EndsWithTheProgramThatStartedIt) {
  for (const int signal : {SIGTERM, SIGINT, SIGKILL}) {
    const FalseGwyddion sleeping(kSleeps);
    const pid_t program = ::fork();
    if (program == 0) {
      sleeping.refusal();
      ::_exit(0);
    }
    ASSERT_GT(program, 0);
    ASSERT_TRUE(soon([&] { return sleeping.process() > 0; }));
    ::kill(program, signal);
    int status = 0;
    ASSERT_EQ(::waitpid(program, &status, 0), program);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    // One that ended and that nobody waited for yet runs no more either.
    const auto is_gone = [&] {
      std::string word, state;
      std::ifstream about("/proc/" + std::to_string(sleeping.process()) + "/stat");
      about >> word >> word >> state;
      return state.empty() || state == "Z";
    };
    EXPECT_TRUE(soon(is_gone)) << signal;
    EXPECT_TRUE(signal == SIGKILL || sleeping.left_nothing()) << signal;
  }
}

}  // namespace
}  // namespace ringfilm::instrument
