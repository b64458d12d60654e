#include "ringfilm/report/study_page.hpp"

#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/payload_study.hpp"
#include "ringfilm/report/payload/script_text.hpp"

namespace ringfilm::report {

std::string study_page(const io::StudyRows& rows, const io::Units& units, const io::Provenance& provenance) {
  using nlohmann::ordered_json;
  ordered_json payload = study_head(rows, units, provenance);
  add_study_values(rows, units, payload);
  add_study_points(rows, payload);
  add_study_curves(rows, units, payload);
  const page_template::PageTemplate parts = page_template::study();
  std::string page(parts.before_title);
  page += html_text(rows.plan.study().title);
  page += parts.before_data;
  // A name in another encoding than UTF-8 is shown with a replacement sign, not refused.
  page += script_text(payload.dump(-1, ' ', false, ordered_json::error_handler_t::replace));
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
