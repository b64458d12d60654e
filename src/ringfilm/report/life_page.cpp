#include "ringfilm/report/life_page.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/life/end_of_life.hpp"
#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

ordered_json quantities() {
  ordered_json list = ordered_json::array();
  const auto add = [&list](const cycle::Quantity& quantity) {
    list.push_back({{"name", quantity.name},
                    {"unit", quantity.unit},
                    {"display_unit", quantity.display_unit},
                    {"long_name", quantity.long_name}});
  };
  for (const cycle::Quantity& quantity : life::limitable_quantities()) add(quantity);
  return list;
}

}  // namespace

std::string life_page(const io::LifeDocument& document) {
  ordered_json payload = ordered_json::parse(io::life_json(document));
  payload["quantities"] = quantities();
  const page_template::PageTemplate parts = page_template::life();
  std::string page(parts.before_title);
  page += html_text(document.file.life.title);
  page += parts.before_data;
  page += script_text(payload.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
