#include "study/slurm_queue.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"

namespace ringfilm::app {

CommandOutput output_of(const std::string& command_line) {
  std::FILE* pipe = ::popen(fmt::format("{{ {}\n}} 2>&1", command_line).c_str(), "re");
  if (pipe == nullptr) return {"no process could be started", -1};
  CommandOutput printed;
  std::array<char, 4096> part{};
  constexpr std::size_t kMax = 1 << 24;  // output of 10^5 tasks with their reasons [byte]
  for (std::size_t n = 0; (n = std::fread(part.data(), 1, part.size(), pipe)) > 0;) {
    if (printed.text.size() < kMax) printed.text.append(part.data(), n);
  }
  const int status = ::pclose(pipe);
  printed.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return printed;
}

std::string shell_word(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) c == '\'' ? quoted.append("'\\''") : quoted.append(1, c);
  return quoted.append(1, '\'');
}

bool is_plain(const std::string& word) {
  constexpr const char* kPlain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_=.,:/%+@";
  return !word.empty() && word.find_first_not_of(kPlain) == std::string::npos;
}

bool is_number(const std::string& text) { return text.find_first_not_of("0123456789") == std::string::npos; }

std::string word_to_copy(const std::string& word) { return is_plain(word) ? word : shell_word(word); }

bool is_command(const std::string& name) {
  return output_of(fmt::format("command -v {} >/dev/null", shell_word(name))).exit_code == 0;
}

std::string StudyJobs::path(const StudyFiles& files) { return fmt::format("{}/{}.jobs", files.folder(), files.name()); }

std::optional<StudyJobs> StudyJobs::read(const StudyFiles& files) {
  std::ifstream file(path(files));
  StudyJobs jobs;
  std::string word;
  if (!(file >> word >> jobs.array >> word >> jobs.parts)) return std::nullopt;
  file >> word >> jobs.merge;
  if (!is_number(jobs.array) || !is_number(jobs.merge)) return std::nullopt;
  return jobs;
}

void StudyJobs::write(const StudyFiles& files) const {
  io::write_atomically(path(files), fmt::format("array {} parts {}\nmerge {}\n", array, parts, merge));
}

std::optional<std::map<std::uint64_t, std::string>> queue_states(const StudyJobs& jobs) {
  if (!is_command("squeue")) return std::nullopt;
  std::map<std::uint64_t, std::string> states;
  for (const std::string& job : {jobs.array, jobs.merge}) {
    if (job.empty()) continue;
    const CommandOutput printed =
        output_of(fmt::format("squeue --noheader --array --jobs={} --format='%K %T %r'", job));
    // Squeue reports an error for a job that ended long ago.
    if (printed.exit_code != 0 && printed.text.find("Invalid job id") == std::string::npos) return std::nullopt;
    if (printed.exit_code != 0) continue;
    std::istringstream lines(printed.text);
    std::string task, state, reason;
    while (lines >> task >> state && std::getline(lines >> std::ws, reason)) {
      constexpr std::size_t kMaxDigits = 9;
      states[is_number(task) ? std::stoull(task.substr(0, kMaxDigits)) : 0] =
          state == "RUNNING" || reason == "None" ? state : fmt::format("{} ({})", state, reason);
    }
  }
  return states;
}

}  // namespace ringfilm::app
