#include "ringfilm/instrument/gwyddion_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include "ringfilm/instrument/binary_reader.hpp"

namespace ringfilm::instrument {
namespace {

namespace fs = std::filesystem;

class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code error;
    std::string name = (fs::temp_directory_path(error) / "ringfilm-gwyddion-XXXXXX").string();
    if (error || ::mkdtemp(name.data()) == nullptr) refuse(name, "no scratch folder can be made there", "set TMPDIR");
    path = name;
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder() {
    std::error_code error;
    fs::remove_all(path, error);
  }

  fs::path path;
};

std::optional<std::string> program_path() {
  const char* const path = std::getenv("PATH");
  if (path == nullptr) return std::nullopt;
  const std::string folders = path;
  for (std::size_t start = 0; start <= folders.size();) {
    const std::size_t end = std::min(folders.find(':', start), folders.size());
    const std::string file = folders.substr(start, end - start) + "/gwyddion";
    if (end > start && ::access(file.c_str(), X_OK) == 0) return file;
    start = end + 1;
  }
  return std::nullopt;
}

/// Owns what posix_spawn wants to know.
class SpawnPlan {
 public:
  explicit SpawnPlan(const std::string& log) {
    posix_spawn_file_actions_init(&files_);
    posix_spawn_file_actions_addopen(&files_, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&files_, 1, log.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    posix_spawn_file_actions_adddup2(&files_, 1, 2);
    posix_spawnattr_init(&attributes_);
    posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
  }
  SpawnPlan(const SpawnPlan&) = delete;
  SpawnPlan& operator=(const SpawnPlan&) = delete;
  ~SpawnPlan() {
    posix_spawn_file_actions_destroy(&files_);
    posix_spawnattr_destroy(&attributes_);
  }

  pid_t start(std::vector<std::string> arguments, std::vector<std::string> environment) {
    pid_t process = 0;
    const int error = posix_spawn(&process, arguments[0].c_str(), &files_, &attributes_, pointers(arguments).data(),
                                  pointers(environment).data());
    if (error != 0) refuse(arguments[0], std::string("the program cannot be started: ") + std::strerror(error), "");
    return process;
  }

 private:
  static std::vector<char*> pointers(std::vector<std::string>& texts) {
    std::vector<char*> result;
    for (std::string& text : texts) result.push_back(text.data());
    result.push_back(nullptr);
    return result;
  }

  posix_spawn_file_actions_t files_;
  posix_spawnattr_t attributes_;
};

void bound(pid_t process, const ConversionLimits& limits) {
#ifdef __linux__
  const auto set = [process](auto resource, std::size_t value) {
    const rlimit limit{value, value};
    ::prlimit(process, resource, &limit, nullptr);
  };
  set(RLIMIT_FSIZE, limits.output_bytes);
  set(RLIMIT_AS, limits.memory_bytes);
  set(RLIMIT_CORE, 0);
#else
  (void)process;
  (void)limits;
#endif
}

enum class Ending { kGood, kFailed, kTooLong };

double now_s() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Ending wait_for(pid_t process, double seconds) {
  const double end = now_s() + seconds;
  timespec pause{0, 1000000};
  while (true) {
    int status = 0;
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process) return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::kGood : Ending::kFailed;
    if (ended < 0 && errno != EINTR) return Ending::kFailed;
    if (now_s() > end) {
      ::kill(-process, SIGKILL);
      while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
      }
      return Ending::kTooLong;
    }
    ::nanosleep(&pause, nullptr);
    if (pause.tv_nsec < 20000000) pause.tv_nsec *= 2;
  }
}

/// The first line that the program left, without the names of its folders.
std::string first_words(const fs::path& log, const std::string& path) {
  std::ifstream in(log);
  std::string line;
  std::getline(in, line);
  line = utf8_from(line.substr(0, 300));
  const std::size_t place = line.find(path + ": ");
  return trimmed(place == std::string::npos ? line : line.substr(place + path.size() + 2));
}

}  // namespace

bool has_gwyddion() { return program_path().has_value(); }

std::shared_ptr<const std::string> converted_by_gwyddion(const std::string& path, const ConversionLimits& limits) {
  const std::string ending = fs::path(path).extension().string();
  const bool is_talysurf = ending == ".prf" || ending == ".PRF";
  const std::string talysurf_remedy =
      "no free program reads Talysurf .prf: export the profile as text with the columns x and z from the program of "
      "the instrument";
  const std::optional<std::string> program = program_path();
  if (!program) {
    refuse(path, "this format is read through the program gwyddion, which is not installed",
           is_talysurf ? talysurf_remedy
                       : "install it (Debian: apt install gwyddion), or export the measurement as X3P, SDF or SUR");
  }
  const ScratchFolder scratch;
  const std::string absolute = fs::absolute(path).string();
  const std::string target = (scratch.path / "converted.gwy").string(), home = scratch.path.string();
  const fs::path log = scratch.path / "log";
  SpawnPlan plan(log.string());
  const pid_t process = plan.start({*program, "--convert-to-gwy=" + target, absolute},
                                   {"HOME=" + home, "TMPDIR=" + home, "XDG_RUNTIME_DIR=" + home, "PATH=/usr/bin:/bin",
                                    "LC_ALL=C.UTF-8", "G_SLICE=always-malloc"});
  bound(process, limits);
  const Ending how = wait_for(process, limits.seconds);
  if (how == Ending::kTooLong) {
    refuse(path, fmt::format("gwyddion was stopped after {} s on this file", limits.seconds),
           "open it in gwyddion by hand and save it as .gwy");
  }
  std::error_code error;
  if (how == Ending::kFailed || !fs::exists(target, error)) {
    const std::string said = first_words(log, absolute);
    refuse(path, "gwyddion cannot read the file" + (said.empty() ? "" : ": " + said),
           is_talysurf ? talysurf_remedy : "export the measurement as X3P, SDF, SUR or text");
  }
  return std::make_shared<const std::string>(file_bytes(target, limits.output_bytes));
}

}  // namespace ringfilm::instrument
