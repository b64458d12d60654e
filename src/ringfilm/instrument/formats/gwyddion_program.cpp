#include "ringfilm/instrument/formats/gwyddion_program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <stdlib.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif
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

#include "ringfilm/base/trimmed.hpp"
#include "ringfilm/instrument/grid/binary_reader.hpp"
#include "ringfilm/io/text/foreign_file.hpp"

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

/// While it lives, a wish to end the program waits: first the conversion is stopped and its folder removed. Signals
/// that the program was set to ignore stay ignored.
class HeldSignals {
 public:
  HeldSignals() {
    sigemptyset(&held_);
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction now {};
      if (::sigaction(number, nullptr, &now) == 0 && now.sa_handler != SIG_IGN) sigaddset(&held_, number);
    }
    ::pthread_sigmask(SIG_BLOCK, &held_, &before_);
  }
  HeldSignals(const HeldSignals&) = delete;
  HeldSignals& operator=(const HeldSignals&) = delete;
  ~HeldSignals() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

  bool one_came() const {
    sigset_t waiting;
    if (::sigpending(&waiting) != 0) return false;
    for (const int number : {SIGINT, SIGTERM, SIGHUP}) {
      if (sigismember(&held_, number) == 1 && sigismember(&before_, number) == 0 &&
          sigismember(&waiting, number) == 1) {
        return true;
      }
    }
    return false;
  }

  const sigset_t& before() const { return before_; }

 private:
  sigset_t held_{}, before_{};
};

std::vector<char*> pointers(std::vector<std::string>& texts) {
  std::vector<char*> result;
  for (std::string& text : texts) result.push_back(text.data());
  result.push_back(nullptr);
  return result;
}

void bound(decltype(RLIMIT_CORE) resource, std::size_t value) {
  const rlimit limit{value, value};
  ::setrlimit(resource, &limit);
}

/// What the new process does before it becomes the other program: only calls that are safe after a fork. Returns where
/// one of them fails.
void become(char* const* arguments, char* const* environment, const char* log, const ConversionLimits& limits,
            const sigset_t& signals, pid_t parent) {
  ::setpgid(0, 0);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
#endif
  if (::getppid() != parent) return;
  bound(RLIMIT_FSIZE, limits.output_bytes);
  bound(RLIMIT_AS, limits.memory_bytes);
  bound(RLIMIT_CORE, 0);
  const int in = ::open("/dev/null", O_RDONLY), out = ::open(log, O_WRONLY | O_CREAT | O_APPEND, 0600);
  if (in < 0 || out < 0 || ::dup2(in, 0) < 0 || ::dup2(out, 1) < 0 || ::dup2(out, 2) < 0) return;
  ::signal(SIGCHLD, SIG_DFL);
  ::sigprocmask(SIG_SETMASK, &signals, nullptr);
  ::execve(arguments[0], arguments, environment);
}

constexpr int kExitNotStarted = 127;  // as shells have it

pid_t start(std::vector<std::string> arguments, std::vector<std::string> environment, const std::string& log,
            const ConversionLimits& limits, const sigset_t& signals) {
  const std::vector<char*> words = pointers(arguments), settings = pointers(environment);
  const pid_t parent = ::getpid(), process = ::fork();
  if (process == 0) {
    become(words.data(), settings.data(), log.c_str(), limits, signals, parent);
    ::_exit(kExitNotStarted);
  }
  if (process < 0) refuse(arguments[0], std::string("the program cannot be started: ") + std::strerror(errno), "");
  ::setpgid(process, process);  // whichever of the two comes first
  return process;
}

/// Unknown: where nobody waits for processes that end (SIGCHLD ignored), none reports how it ended.
enum class Ending { kGood, kFailed, kNotStarted, kUnknown, kTooLong, kInterrupted };

Ending ending_of(int status) {
  if (!WIFEXITED(status)) return Ending::kFailed;
  if (WEXITSTATUS(status) == kExitNotStarted) return Ending::kNotStarted;
  return WEXITSTATUS(status) == 0 ? Ending::kGood : Ending::kFailed;
}

double now_s() {
  timespec time{};
  ::clock_gettime(CLOCK_MONOTONIC, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Ending wait_for(pid_t process, double seconds, const HeldSignals& signals) {
  const double end = now_s() + seconds;
  timespec pause{0, 1000000};
  while (true) {
    int status = 0;
    const pid_t ended = ::waitpid(process, &status, WNOHANG);
    if (ended == process) return ending_of(status);
    if (ended < 0 && errno != EINTR) return Ending::kUnknown;
    const bool interrupted = signals.one_came();
    if (interrupted || now_s() > end) {
      ::kill(-process, SIGKILL);
      while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
      }
      return interrupted ? Ending::kInterrupted : Ending::kTooLong;
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

/// What to do where a file of that ending cannot be read; empty where nothing more is known of it.
std::string remedy_of_ending(const std::string& ending) {
  if (ending == ".prf" || ending == ".PRF") {
    return "no free program reads Talysurf .prf: export the profile as text with the columns x and z from the program "
           "of the instrument";
  }
  return ending == ".h5" || ending == ".hdf5" ? io::kHdf5Remedy : "";
}

}  // namespace

bool has_gwyddion() { return program_path().has_value(); }

std::shared_ptr<const std::string> converted_by_gwyddion(const std::string& path, const ConversionLimits& limits) {
  const std::string known_remedy = remedy_of_ending(fs::path(path).extension().string());
  const std::optional<std::string> program = program_path();
  if (!program) {
    refuse(path, "this format is read through the program gwyddion, which is not installed",
           !known_remedy.empty()
               ? known_remedy
               : "install it (Debian: apt install gwyddion), or export the measurement as X3P, SDF or SUR");
  }
  const HeldSignals signals;  // let go after the folder is removed
  const ScratchFolder scratch;
  const std::string absolute = fs::absolute(path).string();
  const std::string target = (scratch.path / "converted.gwy").string(), home = scratch.path.string();
  const fs::path log = scratch.path / "log";
  const pid_t process = start({*program, "--convert-to-gwy=" + target, absolute},
                              {"HOME=" + home, "TMPDIR=" + home, "XDG_RUNTIME_DIR=" + home, "PATH=/usr/bin:/bin",
                               "LC_ALL=C.UTF-8", "G_SLICE=always-malloc"},
                              log.string(), limits, signals.before());
  const Ending how = wait_for(process, limits.seconds, signals);
  if (how == Ending::kTooLong) {
    refuse(path, fmt::format("gwyddion was stopped after {} s on this file", limits.seconds),
           "open it in gwyddion by hand and save it as .gwy");
  }
  if (how == Ending::kInterrupted) refuse(path, "the conversion by gwyddion was interrupted", "");
  if (how == Ending::kNotStarted) refuse(*program, "the program cannot be started", "reinstall it");
  std::error_code error;
  if (how == Ending::kFailed || !fs::exists(target, error)) {
    const std::string printed = first_words(log, absolute);
    refuse(path, "gwyddion cannot read the file" + (printed.empty() ? "" : ": " + printed),
           !known_remedy.empty() ? known_remedy : "export the measurement as X3P, SDF, SUR or text");
  }
  return std::make_shared<const std::string>(file_bytes(target, limits.output_bytes));
}

}  // namespace ringfilm::instrument
