#include "ringfilm/io/gas_path/gas_path_file.hpp"

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/pack_gas_layout.hpp"
#include "ringfilm/io/result/provenance_attributes.hpp"
#include "ringfilm/io/result/result_file_layout.hpp"
#include "ringfilm/io/result/result_file_reader.hpp"
#include "ringfilm/io/storage/digest_trailer.hpp"

namespace ringfilm::io {

bool is_gas_path(const std::string& name, const std::string& bytes) {
  if (!begins_as_netcdf(bytes) || !has_digest_trailer(bytes)) return false;
  return ResultFileReader(name, content_before_trailer(name, bytes)).has_attribute("ringfilm_gas_schema");
}

GasPathFile gas_path_of_bytes(const std::string& name, const std::string& bytes) {
  ResultFileReader file(name, content_before_trailer(name, bytes));
  GasPathFile content;
  file.attribute("title", content.title);
  exchange_provenance(file, content.provenance);
  exchange_pack_gas(file, content);
  exchange_inputs(file, content);
  exchange_notes(file, content.input_notes, content.notes);
  if (!content.gas) throw InputError(name + ": the file holds no gas pressures", "run its case again");
  return content;
}

}  // namespace ringfilm::io
