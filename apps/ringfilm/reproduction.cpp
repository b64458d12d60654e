#include "reproduction.hpp"

#include <fmt/format.h>

#include <limits>

#include "ringfilm/base/error.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "text/engineering_text.hpp"

namespace ringfilm::app {
namespace {

namespace fs = std::filesystem;

/// Crank angles at which the report can show film and pressure along the face: closer where the load is high.
std::string field_angles() {
  std::string list;
  for (int angle = 0; angle < 720; angle += 5) {
    const bool is_near_firing = angle <= 60 || angle >= 660;
    if (is_near_firing || angle % 10 == 0) list += (list.empty() ? "" : ", ") + fmt::format("\"{} degree\"", angle);
  }
  return "[" + list + "]";
}

}  // namespace

void make_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  if (!fs::create_directory(folder, error)) {
    throw InputError(
        folder.string() + ": this folder cannot be made: " + (error ? error.message() : "there is already a file"),
        "name another one with --output");
  }
}

cycle::Case case_for_report(const std::string& path, const io::Units& units) {
  cycle::Case input = io::read_case(path, {{"output.fields", field_angles()}}, units);
  cycle::prepare(input);
  return input;
}

double error_of(const io::ResultDocument& document, const std::string& quantity) {
  return document.errors ? document.errors->values.*cycle_quantity(quantity).value
                         : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace ringfilm::app
