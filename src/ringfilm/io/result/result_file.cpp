#include "ringfilm/io/result/result_file.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_file_document.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/result/result_file_writer.hpp"
#include "ringfilm/io/storage/atomic_file.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"

namespace ringfilm::io {
namespace {

/// A file of ours that is not a result of films.
struct OtherFile {
  const char* attribute;  ///< that only such files have
  const char* what;
  const char* remedy;  ///< where its page comes from
};

constexpr OtherFile kOtherFiles[] = {
    {"ringfilm_pad_schema", "the film of a pad; a report is drawn of rings",
     "name a result of an engine cycle; any program for NetCDF reads this one"},
    {"ringfilm_gas_schema", "the gas of a ring pack alone, without films",
     "ringfilm report draws its page where it is named alone"},
    {"ringfilm_life_schema", "a life; a report is drawn of single cycles",
     "ringfilm life writes its page with --html, together with this file"},
    {"ringfilm_measurement_schema", "a measurement; a report is drawn of engine cycles",
     "the command that wrote it writes its page with --html"}};

std::string page_beside(const std::string& path) {
  return std::filesystem::path(path).replace_extension(".html").string();
}

/// The words of a measurement by its kind: "a measurement by ringfilm contact".
std::string with_command(const ResultFileReader& file, std::string what) {
  if (!file.has_attribute("ringfilm_measurement_schema")) return what;
  std::string kind;
  file.attribute("kind", kind);
  const std::string command = kind == "conformity" ? "conform" : kind == "contact-of-case" ? "contact" : kind;
  return what.insert(what.find(';'), " by ringfilm " + command);
}

void refuse_what_is_not_ours(const std::string& path, const ResultFileReader& file) {
  for (const OtherFile& other : kOtherFiles) {
    if (file.has_attribute(other.attribute)) {
      throw InputError(path + ": " + with_command(file, other.what), other.remedy);
    }
  }
  if (file.has_attribute("ringfilm_study_schema")) {
    throw InputError(path + ": the result of a study; a report is drawn of single cycles",
                     "ringfilm study wrote the page of the study together with it: " + page_beside(path));
  }
  if (!file.has_attribute("ringfilm_schema")) {
    throw InputError(path + ": a NetCDF file, but not one of ringfilm (it has no attribute ringfilm_schema)",
                     "name a result that ringfilm run --output has written");
  }
  long schema = 0;
  file.attribute("ringfilm_schema", schema);
  if (schema != kResultSchema) {
    throw InputError(path + ": ringfilm_schema = " + std::to_string(schema) + ", this program reads " +
                         std::to_string(kResultSchema),
                     schema > kResultSchema ? "read it with the newer ringfilm that wrote it" : "run its case again");
  }
}

void give_back(const std::string& path, const VariantTable& table, std::vector<study::LedgerEntry>& ledger) {
  // A file of another version may have other quantities, or the same in another order.
  const auto& known = cycle::cycle_quantities();
  std::vector<const cycle::CycleQuantity*> columns;
  for (std::size_t i = 0; !table.rows.empty() && i < table.quantities.size(); ++i) {
    const std::optional<std::size_t> place = cycle::cycle_quantity_index(table.quantities[i]);
    if (!place || table.units[i] != known[*place].unit) {
      throw InputError(path + ": cannot be read as a result: variant_values has a column " + table.quantities[i] +
                           " [" + table.units[i] + "], which this program does not support",
                       "read it with the ringfilm that wrote it, or run its case again");
    }
    columns.push_back(&known[*place]);
  }
  if (!table.rows.empty() && columns.size() != known.size()) {
    throw InputError(path + ": cannot be read as a result: variant_values has " + std::to_string(columns.size()) +
                         " columns, this program has " + std::to_string(known.size()) + " cycle values",
                     "read it with the ringfilm that wrote it, or run its case again");
  }
  auto value = table.values.begin();
  for (const VariantRow& row : table.rows) {
    if (row.entry < 0 || row.entry >= static_cast<long>(ledger.size())) {
      throw InputError(path + ": cannot be read as a result: a ledger variant belongs to no entry");
    }
    study::LedgerVariant variant = row;
    for (const cycle::CycleQuantity* quantity : columns) variant.values.*quantity->value = *value++;
    ledger[static_cast<std::size_t>(row.entry)].variants.push_back(variant);
  }
}

ResultDocument read_ring(const std::string& path, ResultFileReader& file) {
  ResultDocument document;
  VariantTable variants;
  exchange(file, document, variants);
  give_back(path, variants, document.ledger);
  return document;
}

ResultDocument read_pack(const std::string& path, ResultFileReader& file) {
  ResultDocument pack;
  exchange_pack(file, pack);
  std::vector<ResultDocument> rings;
  for (std::size_t i = 0; i < file.n_rings(); ++i) {
    file.choose_ring(i);
    rings.push_back(read_ring(path, file));
  }
  ResultDocument whole = pack_document(pack.title, std::move(rings));
  whole.gas = std::move(pack.gas);
  whole.oil_losses = std::move(pack.oil_losses);
  return whole;
}

}  // namespace

VariantTable variant_table(const std::vector<study::LedgerEntry>& ledger) {
  VariantTable table;
  for (const auto& quantity : cycle::cycle_quantities()) {
    table.quantities.push_back(quantity.name);
    table.units.push_back(quantity.unit);
  }
  for (std::size_t i = 0; i < ledger.size(); ++i) {
    for (const study::LedgerVariant& variant : ledger[i].variants) {
      table.rows.push_back({variant, static_cast<long>(i)});
      for (const auto& quantity : cycle::cycle_quantities()) table.values.push_back(variant.values.*quantity.value);
    }
  }
  return table;
}

void write_result(const std::string& path, const ResultDocument& document) {
  ResultFileWriter file(path);
  put_document(file, document);
  write_atomically(path, file.bytes());
}

std::string result_bytes(const ResultDocument& document) {
  ResultFileWriter file("a result in memory");
  put_document(file, document);
  return std::string(file.bytes());
}

std::string read_netcdf_bytes(const std::string& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) {
    throw InputError(path + ": there is no such file", "name a result that ringfilm run --output has written");
  }
  if (std::filesystem::is_directory(path, error)) throw InputError(path + ": this is a folder, not a result file");
  if (!std::filesystem::is_regular_file(path, error)) {
    throw InputError(path + ": this is a device or a pipe, not a result file", "write its content into a file first");
  }
  std::ifstream stream(path, std::ios::binary);
  if (!stream) throw InputError(path + ": cannot be opened", "is it yours to read?");
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

ResultDocument read_result(const std::string& path) { return result_of_bytes(path, read_netcdf_bytes(path)); }

ResultDocument result_of_bytes(const std::string& path, const std::string& bytes) {
  if (!begins_as_netcdf(bytes)) {
    throw InputError(path + ": this is not a NetCDF file", "name a result that ringfilm run --output has written");
  }
  ResultFileReader file(path, content_before_trailer(path, bytes));
  refuse_what_is_not_ours(path, file);
  if (file.n_rings() > 0) return read_pack(path, file);
  ResultDocument document = read_ring(path, file);
  exchange_oil_losses(file, document);
  return document;
}

}  // namespace ringfilm::io
