#include "ringfilm/io/case/shipped_oils.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/oil_setup.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/storage/shipped.hpp"

namespace ringfilm::io {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = "data/lubricants";
constexpr const char* kOfGrade = "sae-";  ///< begins the name of the file of a grade: sae-10w-40.toml

/// Letters and digits, small, without a leading "sae": "SAE 10W-40" and "10w40" are "10w40".
std::string bare(const std::string& grade) {
  std::string text;
  for (const unsigned char c : grade) {
    if (std::isalnum(c) != 0) text += static_cast<char>(std::tolower(c));
  }
  return text.rfind("sae", 0) == 0 ? text.substr(3) : text;
}

/// "SAE 10W-40" of "sae-10w-40"; empty for the name of another file.
std::string grade_of(const std::string& stem) {
  if (stem.rfind(kOfGrade, 0) != 0) return "";
  std::string grade = stem.substr(std::string(kOfGrade).size());
  std::transform(grade.begin(), grade.end(), grade.begin(), [](unsigned char c) { return std::toupper(c); });
  return "SAE " + grade;
}

/// The files of the shipped oils, by name.
std::vector<fs::path> oil_paths() {
  std::vector<fs::path> paths;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(fs::path(shipped_folder()) / kFolder, error)) {
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

NamedFile named(const fs::path& path) { return {path.string(), std::string(kFolder) + "/" + path.filename().string()}; }

ShippedOil read_oil(const fs::path& path, const Units& units) {
  constexpr double kHot = 423.15, kStroke = 0.1;  // [K]; [m], which does not matter at one temperature
  cycle::Case c;
  TomlValue name;
  name.kind = TomlValue::Kind::kText;
  name.text = path.string();
  update(c, {{"lubricant.file", name}}, units);
  const cycle::PreparedOil hot = cycle::prepared_oil(c.lubricant, std::nullopt, {kHot, kStroke});
  const auto kinematic_viscosity = [&](double temperature) {
    const cycle::PreparedOil oil = cycle::prepared_oil(c.lubricant, std::nullopt, {temperature, kStroke});
    return oil.setup.viscosity / oil.setup.density;
  };
  return {c.lubricant.name,
          grade_of(path.stem().string()),
          named(path).shown,
          kinematic_viscosity(313.15),
          kinematic_viscosity(373.15),
          hot.setup.viscosity / hot.setup.density,
          hot.setup.viscosity};
}

}  // namespace

std::vector<ShippedOil> shipped_oils(const Units& units) {
  std::vector<ShippedOil> oils;
  for (const fs::path& path : oil_paths()) oils.push_back(read_oil(path, units));
  return oils;
}

NamedFile shipped_oil_of_grade(const std::string& grade) {
  std::string known;
  for (const fs::path& path : oil_paths()) {
    const std::string of_file = grade_of(path.stem().string());
    if (of_file.empty()) continue;
    if (bare(of_file) == bare(grade)) return named(path);
    known += (known.empty() ? "" : ", ") + quoted(of_file);
  }
  throw InputError("no shipped oil has the grade " + quoted(grade),
                   "choose one of " + known + ", or state the oil by lubricant.file or its values");
}

std::string oils_table(const std::vector<ShippedOil>& oils) {
  std::string text = fmt::format("{:<12}{:<24}{:>10}{:>10}{:>10}{:>14}  {}\n", "grade", "name", "40 degC", "100 degC",
                                 "150 degC", "150 degC", "file");
  text += fmt::format("{:<12}{:<24}{:>10}{:>10}{:>10}{:>14}\n", "", "", "mm2/s", "mm2/s", "mm2/s", "mPa s");
  const auto mm2_s = [](double viscosity) { return number_in(viscosity, kSquareMillimetrePerSecond); };
  for (const ShippedOil& oil : oils) {
    text += fmt::format("{:<12}{:<24}{:>10.2f}{:>10.2f}{:>10.2f}{:>14.2f}  {}\n", oil.grade.empty() ? "-" : oil.grade,
                        oil.name, mm2_s(oil.kinematic_viscosity_40), mm2_s(oil.kinematic_viscosity_100),
                        mm2_s(oil.kinematic_viscosity_150), number_in(oil.viscosity_150, kMillipascalSecond), oil.file);
  }
  return text +
         "typical oils of their grades, not products; at 150 degC by ASTM D341 and without shear thinning\n"
         "in a case: [lubricant] grade = \"SAE 10W-40\", or file = \"data/lubricants/sae-10w-40.toml\"\n";
}

std::string oils_json(const std::vector<ShippedOil>& oils) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const ShippedOil& oil : oils) {
    list.push_back({{"grade", oil.grade.empty() ? nlohmann::ordered_json() : nlohmann::ordered_json(oil.grade)},
                    {"name", oil.name},
                    {"file", oil.file},
                    {"kinematic_viscosity_40", oil.kinematic_viscosity_40},
                    {"kinematic_viscosity_100", oil.kinematic_viscosity_100},
                    {"kinematic_viscosity_150", oil.kinematic_viscosity_150},
                    {"viscosity_150", oil.viscosity_150}});
  }
  return list.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace ringfilm::io
