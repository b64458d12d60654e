#include "output_names.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>

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

std::vector<io::OutputClaim> claims(const std::vector<std::optional<std::string>>& outputs) {
  std::vector<io::OutputClaim> all;
  for (const auto& output : outputs) {
    if (output) all.emplace_back(*output);
  }
  return all;
}

bool is_same_file(const std::string& a, const std::string& b) {
  std::error_code error;
  const auto whole = [&](const std::string& path) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(path, error), error);
  };
  return whole(a) == whole(b);
}

}  // namespace ringfilm::app
