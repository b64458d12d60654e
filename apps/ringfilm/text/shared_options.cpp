#include "text/shared_options.hpp"

#include <filesystem>
#include <memory>
#include <set>
#include <utility>

#include "ringfilm/base/trimmed.hpp"

namespace ringfilm::app {
namespace {

surface::FormChoice form_of(const std::string& text) {
  using surface::FormKind;
  const std::string polynomial = "polynomial-";
  if (text.rfind(polynomial, 0) == 0) {
    constexpr std::uint64_t kMaxDegree = 12;
    const auto degree = whole_number(text.substr(polynomial.size()));
    if (degree && *degree <= kMaxDegree) return {FormKind::polynomial, static_cast<int>(*degree)};
    throw InputError("--form " + text + ": the degree is not a number from 0 to 12", "for example --form polynomial-2");
  }
  return {CommandOptions::chosen<FormKind>("--form", text,
                                           {{"none", FormKind::none},
                                            {"mean", FormKind::mean},
                                            {"tilt", FormKind::tilt},
                                            {"cylinder", FormKind::cylinder},
                                            {"polynomial-2", FormKind::polynomial}})};
}

/// Splits "key=value" or "key = value"; the value may hold further equal signs.
io::Override override_of(const std::string& text) {
  const std::size_t equal_sign = text.find('=');
  if (equal_sign == std::string::npos || equal_sign == 0) {
    throw InputError("--set " + text + ": this is not key=value", "for example --set operating.speed='3000 rpm'");
  }
  return {trimmed(text.substr(0, equal_sign)), trimmed(text.substr(equal_sign + 1))};
}

/// The words of a case and of its settings. A setting may follow --set or the one before it, so the arguments that are
/// alone are distinguished by their equal sign.
struct CaseWords {
  std::vector<std::string> alone, set;

  std::string case_path() const {
    std::string path;
    for (const std::string& word : alone) {
      if (is_setting(word)) continue;
      if (!path.empty()) throw InputError("two case files are named: " + path + " and " + word, "run them one by one");
      path = word;
    }
    if (path.empty()) throw InputError("no case file is named", "for example ringfilm run case.toml");
    return path;
  }

  std::vector<io::Override> overrides() const {
    std::vector<io::Override> overrides;
    for (const std::string& word : set) overrides.push_back(override_of(word));
    for (const std::string& word : alone) {
      if (is_setting(word)) overrides.push_back(override_of(word));
    }
    return overrides;
  }

 private:
  bool is_setting(const std::string& word) const { return !set.empty() && word.find('=') != std::string::npos; }
};

void refuse_repeated(const std::vector<io::Override>& overrides, Faults& faults) {
  std::set<std::string> keys, twice;
  for (const io::Override& one : overrides) {
    if (!keys.insert(one.key).second) twice.insert(one.key);
  }
  for (const std::string& key : twice) faults.refuse("--set " + key + " is given more than once", "keep one of them");
}

}  // namespace

void add_case(CommandOptions& add, CaseOptions& options) {
  const auto words = std::make_shared<CaseWords>();
  add.text("CASE.toml", words->alone, "", "the case file")->required();
  add.texts("--set", words->set, "key=value ...",
            "a key of the case to replace; read as TOML, else as text; may be repeated");
  add.rule([words, &options](Faults& faults) {
    options.case_path = words->case_path();
    options.overrides = words->overrides();
    refuse_repeated(options.overrides, faults);
  });
}

void add_csv(CommandOptions& add, CaseWithOutputs& options, const std::string& what) {
  add.text("--csv", options.csv, "X.csv", what + "; without a name: that of the case in this folder")->expected(0, 1);
  add.rule([&options](Faults&) {
    if (!options.csv || !options.csv->empty()) return;
    options.csv = std::filesystem::path(options.case_path).stem().string() + ".csv";
  });
}

CLI::Option* add_settings(CommandOptions& add, std::vector<io::Override>& settings) {
  return add.read_each("--set", "key=value", "a key of the case to replace; may be repeated",
                       [&settings](const std::string& text) { settings.push_back(override_of(text)); });
}

void add_outputs(CommandOptions& add, MeasurementOutputs& outputs, bool with_fragment) {
  add.text("-o,--output", outputs.netcdf, "X.nc", "write everything as NetCDF-4");
  add.text("--html", outputs.page, "X.html", "write everything as one self-contained web page");
  if (with_fragment) {
    add.text("--fragment", outputs.fragment, "X.toml",
             "write what a case needs; a case reads it with include = [\"X.toml\"]");
  }
  add.json(outputs.summary, "print JSON, SI units, instead of the table");
}

void add_table(CommandOptions& add, io::TableReading& table) {
  add.text("--columns", table.columns, "\"x [um], -, z [um]\"",
           "of a text file: names and units of all its columns; - is not used");
  add.read("--skip-lines", "N", "of a text file: lines in front of the table", [&table](const std::string& text) {
    constexpr std::uint64_t kMaxSkipped = 1000000;
    const std::optional<std::uint64_t> lines = whole_number(text);
    if (!lines || *lines > kMaxSkipped) {
      throw InputError("--skip-lines " + text + ": this is not a number of lines", "for example --skip-lines 12");
    }
    table.skip_lines = static_cast<std::size_t>(*lines);
  });
}

void add_channel_and_unit(CommandOptions& add, instrument::SurfaceOptions& reading) {
  add_table(add, reading.table);
  add.texts("--missing", reading.table.missing, "WORD",
            "of a text file: a word or number that marks a missing height; may be repeated");
  add.text("--channel", reading.channel, "N", "which channel of the file: its number from 1, or its name");
  add.text("--unit", reading.height_unit, "UNIT", "unit of the heights, where the file does not state it");
}

CLI::Option* add_map_options(CommandOptions& add, instrument::SurfaceOptions& reading,
                             surface::Preparation& preparation, const std::string& usual_form) {
  using instrument::TableLayout;
  add_channel_and_unit(add, reading);
  add.text("--lateral-unit", reading.lateral_unit, "UNIT", "unit of x and y, where the file does not state it");
  add.text("--step-x", reading.step_x, "LENGTH", "distance of points along a row, where the file does not state it");
  add.text("--step-y", reading.step_y, "LENGTH", "distance of rows; the same as --step-x if omitted");
  add.choice("--layout", reading.layout,
             {{"matrix", TableLayout::kMatrix}, {"points", TableLayout::kPoints}, {"profile", TableLayout::kProfile}},
             "of a text file: matrix, points (x, y, z) or profile", "LAYOUT");
  CLI::Option* form =
      add.read("--form", "FORM", "what is removed first: none, mean, tilt, cylinder or polynomial-K of degree K",
               [&preparation](const std::string& text) { preparation.form = form_of(text); });
  add.length("--short-cutoff", preparation.short_cutoff_m, "2.5 um", "S-filter: waves shorter than this go");
  add.length("--long-cutoff", preparation.long_cutoff_m, "2.5 um", "L-filter: waves longer than this go");
  add.flag("--robust", preparation.filter, surface::FilterKind::robust_gaussian,
           "robust Gaussian filters, which pores and grooves do not pull down");
  add.flag("--valley-suppression", preparation.filter, surface::FilterKind::valley_suppression,
           "of profiles: the two-step L-filter of ISO 13565-1, for drawings that name it");
  add.rule([&preparation](Faults& faults) {
    using surface::FilterKind;
    if (preparation.filter == FilterKind::robust_gaussian && !preparation.short_cutoff_m &&
        !preparation.long_cutoff_m) {
      faults.refuse("--robust names a filter, but there is no cut-off", "add --short-cutoff or --long-cutoff");
    }
    if (preparation.filter == FilterKind::valley_suppression && !preparation.long_cutoff_m) {
      faults.refuse("--valley-suppression names an L-filter, but there is no long cut-off", "add --long-cutoff");
    }
  });
  return form->default_str(usual_form);
}

void add_jobs(CommandOptions& add, int& threads) {
  add.threads("--jobs", threads,
              "threads for the other integrations of ledger and error estimate, 1 to 1024; without it as many as the "
              "machine runs at once; the numbers are the same");
}

CLI::Option* add_threads(CommandOptions& add, int& threads) {
  return add.threads("--threads", threads, "1 to 1024; without it as many as the machine runs at once");
}

}  // namespace ringfilm::app
