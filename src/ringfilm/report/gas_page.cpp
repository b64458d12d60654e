#include "ringfilm/report/gas_page.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/base/error.hpp"
#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/payload_pack.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {

std::string gas_page(const io::GasPathFile& file) {
  using nlohmann::ordered_json;
  if (!file.gas)
    throw InputError("a page of the gas of a ring pack needs its pressures", "compute it with ringfilm gas");
  ordered_json notes = io::record_array(file.notes);
  for (const std::string& message : file.input_notes) notes.push_back({{"topic", "input"}, {"message", message}});
  const ordered_json payload = {{"title", file.title},
                                {"gas", gas_alone_payload(*file.gas)},
                                {"inputs", io::record_array(file.inputs)},
                                {"files", io::record_array(file.files)},
                                {"notes", std::move(notes)},
                                {"provenance", io::record_object(file.provenance)}};
  const page_template::PageTemplate parts = page_template::gas();
  std::string page(parts.before_title);
  page += html_text(file.title);
  page += parts.before_data;
  page += script_text(payload.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
