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
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/verification/overlay_file.hpp"
#include "ringfilm/report/gas_page.hpp"
#include "ringfilm/report/html.hpp"

namespace ringfilm::app {
namespace {

void check_report_options(const ReportOptions& options) {
  if (!options.output && !options.vts_folder) {
    throw InputError("nothing is to be written", "name a page with --output X.html or a folder with --vts DIR");
  }
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

void check_output_apart(const ReportOptions& options) {
  for (const auto& inputs : {options.results, options.overlays}) {
    for (const std::string& input : inputs) {
      if (is_same_file(input, *options.output)) {
        throw InputError(*options.output + ": the page would replace a file that it is drawn from",
                         "name another file");
      }
    }
  }
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

std::string page_of(const ReportOptions& options, const std::vector<io::ResultDocument>& documents) {
  std::vector<ringfilm::report::Overlay> overlays;
  const io::Units units;
  for (const std::string& path : options.overlays) {
    for (const io::OverlayCurve& curve : io::read_overlay(path, units)) {
      overlays.push_back({curve.name, curve.quantity, curve.source, curve.crank_angle_deg, curve.value});
    }
  }
  return ringfilm::report::report_page(documents, overlays);
}

}  // namespace

void report(const ReportOptions& options) {
  check_report_options(options);
  if (options.output) {
    io::check_can_write(*options.output, io::Sink::kFileOrDevice);
    check_output_apart(options);
    check_suffix("--output", *options.output, OutputKind::kPage);
  }
  const std::vector<io::OutputClaim> claimed = claims({options.output});
  if (options.vts_folder) io::check_can_write_series(*options.vts_folder);
  const std::vector<ResultBytes> files = read_files(options);
  if (const std::optional<std::string> page = gas_page_of(options, files)) {
    io::write_atomically(*options.output, *page);
    std::cout << "wrote " << *options.output << "\n";
    return;
  }
  std::vector<io::ResultDocument> documents;
  for (const auto& [path, bytes] : files) documents.push_back(io::result_of_bytes(path, bytes));
  // Whatever can be refused is, before anything is written.
  const std::string page = options.output ? page_of(options, documents) : "";
  if (options.vts_folder) {
    const std::string stem = std::filesystem::path(options.results.front()).stem().string();
    const std::string series = io::write_vts_series(*options.vts_folder, stem, documents.front().result.unrolled,
                                                    options.vts_shape.value_or(io::VtsShape::kCylinder));
    std::cout << "wrote " << series << "\n";
  }
  if (!options.output) return;
  io::write_atomically(*options.output, page);
  std::cout << "wrote " << *options.output << "\n";
}

}  // namespace ringfilm::app
