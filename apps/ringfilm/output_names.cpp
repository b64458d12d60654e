#include "output_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <iostream>

#include "ringfilm/base/error.hpp"

namespace ringfilm::app {
namespace {

struct Suffix {
  const char* suffix;
  OutputKind kind;
  const char* description;
};
constexpr std::array<Suffix, 5> kSuffixes{{{".nc", OutputKind::kNetcdf, "a NetCDF file"},
                                           {".html", OutputKind::kPage, "a web page"},
                                           {".htm", OutputKind::kPage, "a web page"},
                                           {".csv", OutputKind::kCsv, "a CSV file"},
                                           {".toml", OutputKind::kToml, "a TOML file"}}};

}  // namespace

void check_suffix(const std::string& option, const std::string& path, OutputKind kind) {
  const auto of_kind =
      std::find_if(kSuffixes.begin(), kSuffixes.end(), [&](const Suffix& s) { return s.kind == kind; });
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const Suffix& one : kSuffixes) {
    if (one.suffix != suffix || one.kind == kind) continue;
    throw InputError(option + " " + path + ": " + of_kind->description + " is written here, and " + suffix +
                         " is the ending of " + one.description,
                     std::string("give the name the ending ") + of_kind->suffix);
  }
}

void check_names(const std::vector<NamedOutput>& outputs, Faults& faults) {
  for (const NamedOutput& one : outputs) {
    if (!one.path) continue;
    faults.collect([&one] {
      if (one.kind) check_suffix(one.option, *one.path, *one.kind);
      io::check_can_write(*one.path, one.sink);
    });
  }
}

void check_apart(const std::vector<NamedOutput>& outputs, const std::vector<cycle::InputFile>& files,
                 const std::string& document, Faults& faults) {
  for (auto one = outputs.begin(); one != outputs.end(); ++one) {
    if (!one->path) continue;
    for (const cycle::InputFile& file : files) {
      if (!is_same_file(*one->path, file.path)) continue;
      faults.refuse(*one->path + ": the output is a file that the " + document + " is read from", "name another file");
    }
    for (auto other = outputs.begin(); other != one; ++other) {
      if (!other->path || !is_same_file(*one->path, *other->path)) continue;
      faults.refuse(*one->path + ": " + other->option + " and " + one->option + " name the same file",
                    "name two files");
    }
  }
}

std::vector<io::OutputClaim> claims(const std::vector<NamedOutput>& outputs) {
  std::vector<io::OutputClaim> all;
  for (const NamedOutput& one : outputs) {
    if (one.path) all.emplace_back(*one.path);
  }
  return all;
}

void print_written(const std::vector<NamedOutput>& outputs) {
  for (const NamedOutput& one : outputs) {
    if (one.path) std::cout << "wrote " << *one.path << "\n";
  }
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto whole = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return whole(a) == whole(b);
}

}  // namespace ringfilm::app
