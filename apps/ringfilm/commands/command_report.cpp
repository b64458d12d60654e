#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>

#include "commands/commands.hpp"
#include "output_names.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/io/gas_path/gas_path_file.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/vts_file.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/verification/overlay_file.hpp"
#include "ringfilm/report/gas_page.hpp"
#include "ringfilm/report/html.hpp"
#include "text/shared_options.hpp"

namespace ringfilm::app {
namespace {

struct ReportOptions {
  std::vector<std::string> results;
  std::vector<std::string> overlays;
  std::optional<std::string> output;      ///< web page
  std::optional<std::string> vts_folder;  ///< folder of the fields around the ring for ParaView
  std::optional<io::VtsShape> vts_shape;
};

void check_report_options(const ReportOptions& options) {
  if (!options.overlays.empty() && !options.output) {
    throw InputError("--overlay lays curves over those of a page, but no page is named", "add --output X.html");
  }
  if (options.vts_shape && !options.vts_folder) {
    throw InputError("--vts-shape shapes fields for ParaView, but no folder for them is named", "add --vts DIR");
  }
  if (options.vts_folder && options.results.size() > 1) {
    throw InputError(fmt::format("--vts {}: {} results are named", *options.vts_folder, options.results.size()),
                     "write the fields of one result at a time");
  }
}

NamedOutput page_of(const ReportOptions& options) {
  return {"--output", options.output, OutputKind::kPage, io::Sink::kFileOrDevice};
}

void check_page(const ReportOptions& options) {
  if (!options.output) return;
  Faults faults;
  check_names({page_of(options)}, faults);
  for (const auto& inputs : {options.results, options.overlays}) {
    for (const std::string& input : inputs) {
      if (!is_same_file(input, *options.output)) continue;
      faults.refuse(*options.output + ": the page would replace a file that it is drawn from", "name another file");
    }
  }
  faults.check();
}

/// A result with the bytes of its file.
struct ResultBytes {
  std::string path, bytes;
};

std::vector<ResultBytes> read_files(const ReportOptions& options) {
  std::vector<ResultBytes> files;
  for (const std::string& path : options.results) files.push_back({path, io::read_netcdf_bytes(path)});
  return files;
}

/// The page of the gas of a ring pack alone; nothing where no file is one.
std::optional<std::string> gas_page_of(const ReportOptions& options, const std::vector<ResultBytes>& files) {
  const auto is_gas = [](const ResultBytes& file) { return io::is_gas_path(file.path, file.bytes); };
  const auto gas = std::ranges::find_if(files, is_gas);
  if (gas == files.end()) return std::nullopt;
  if (files.size() > 1) {
    throw InputError(gas->path + ": the gas of a ring pack alone has a page of its own, and other results are named",
                     "draw it alone");
  }
  if (!options.overlays.empty() || options.vts_folder) {
    throw InputError(gas->path + ": the gas of a ring pack alone has neither curves of films nor fields",
                     "draw its page without --overlay and --vts");
  }
  return ringfilm::report::gas_page(io::gas_path_of_bytes(gas->path, gas->bytes));
}

std::string page_text(const ReportOptions& options, const std::vector<io::ResultDocument>& documents) {
  std::vector<ringfilm::report::Overlay> overlays;
  const io::Units units;
  for (const std::string& path : options.overlays) {
    for (const io::OverlayCurve& curve : io::read_overlay(path, units)) {
      overlays.push_back({curve.name, curve.quantity, curve.source, curve.crank_angle_deg, curve.value});
    }
  }
  return ringfilm::report::report_page(documents, overlays);
}

/// The page of one result is named after it where nothing else is to be written.
ReportOptions with_page(ReportOptions options) {
  if (!options.output && !options.vts_folder) {
    if (options.results.size() > 1) {
      throw InputError("a page of several results has no name by itself", "name it with --output X.html");
    }
    options.output = std::filesystem::path(options.results.front()).replace_extension(".html").string();
  }
  return options;
}

void report(const ReportOptions& stated) {
  const ReportOptions options = with_page(stated);
  check_report_options(options);
  check_page(options);
  const std::vector<io::OutputClaim> claimed = claims({page_of(options)});
  if (options.vts_folder) io::check_can_write_series(*options.vts_folder);
  const std::vector<ResultBytes> files = read_files(options);
  if (const std::optional<std::string> page = gas_page_of(options, files)) {
    io::write_atomically(*options.output, *page);
    print_written({page_of(options)});
    return;
  }
  std::vector<io::ResultDocument> documents;
  for (const auto& [path, bytes] : files) documents.push_back(io::result_of_bytes(path, bytes));
  // Whatever can be refused is, before anything is written.
  const std::string page = options.output ? page_text(options, documents) : "";
  if (options.vts_folder) {
    const std::string stem = std::filesystem::path(options.results.front()).stem().string();
    const std::string series = io::write_vts_series(*options.vts_folder, stem, documents.front().result.unrolled,
                                                    options.vts_shape.value_or(io::VtsShape::kCylinder));
    std::cout << "wrote " << series << "\n";
  }
  if (options.output) io::write_atomically(*options.output, page);
  print_written({page_of(options)});
}

constexpr const char* kReportFooter = R"(Examples:
  ringfilm report my.nc
  ringfilm report new.nc worn.nc --output comparison.html
  ringfilm report new.nc --overlay floating_liner.csv --output measured.html
  ringfilm report unrolled.nc --vts fields

The overlay has a column crank_angle [degree] (0 at firing TDC) and columns named like the curves of a result, with
their units: friction_on_liner [N], min_film_thickness [um], ...
)";

void declare_report(CommandOptions& add, ReportOptions& options) {
  add.text("X.nc", options.results, "...", "results of ringfilm run --output, or one of ringfilm gas --output")
      ->required();
  add.texts("--overlay", options.overlays, "X.csv", "measured curves to lay over; may be repeated");
  add.text("-o,--output,--html", options.output, "X.html",
           "the page to write; X.html beside the result X.nc where neither it nor --vts is stated");
  add.text("--vts", options.vts_folder, "DIR",
           "write the fields around the ring of one result: a .vts file for each crank angle, a .pvd file of all");
  add.choice("--vts-shape", options.vts_shape, {{"cylinder", io::VtsShape::kCylinder}, {"plane", io::VtsShape::kPlane}},
             "cylinder (default): on the bore; plane: unrolled", "SHAPE");
}

}  // namespace

void add_report_command(Program& program) {
  program.add("report", "Draw results as one self-contained web page, or fields for ParaView", kReportFooter,
              declare_report, report);
}

}  // namespace ringfilm::app
