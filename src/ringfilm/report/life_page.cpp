#include "ringfilm/report/life_page.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/life/end_of_life.hpp"
#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/described.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {

std::string life_page(const io::LifeDocument& document) {
  using nlohmann::ordered_json;
  ordered_json payload = ordered_json::parse(io::life_json(document));
  payload["quantities"] = described_all(life::limitable_quantities());
  for (const life::WornQuantity& quantity : life::worn_quantities()) {
    payload["worn_quantities"].push_back({{"name", quantity.name}, {"heading", quantity.heading}});
  }
  const page_template::PageTemplate parts = page_template::life();
  std::string page(parts.before_title);
  page += html_text(document.file.life.title);
  page += parts.before_data;
  page += script_text(payload.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
