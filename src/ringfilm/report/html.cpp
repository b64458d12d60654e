#include "ringfilm/report/html.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ringfilm/base/error.hpp"
#include "ringfilm/report/html_text.hpp"
#include "ringfilm/report/page_template.hpp"
#include "ringfilm/report/payload/payload.hpp"

namespace ringfilm::report {
namespace {

void check_overlays(const std::vector<Overlay>& overlays) {
  std::vector<Fault> faults;
  const auto& quantities = cycle::curve_quantities();
  for (const Overlay& o : overlays) {
    SourceMark mark;
    mark.file = o.source;
    const bool known =
        std::any_of(quantities.begin(), quantities.end(), [&](const auto& q) { return q.name == o.quantity; });
    if (!known) {
      faults.push_back({mark, fmt::format("\"{}\" is not a quantity over crank angle", o.quantity),
                        "name one of the columns that `ringfilm run --csv` writes, for example friction_on_liner"});
    }
    if (o.crank_angle_deg.size() != o.value.size()) {
      faults.push_back({mark, fmt::format("{} crank angles, but {} values", o.crank_angle_deg.size(), o.value.size()),
                        "give one value for each crank angle"});
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
}

std::string page_title(const std::vector<io::ResultDocument>& documents) {
  if (documents.size() == 1) return documents.front().title;
  return fmt::format("{} and {} more", documents.front().title, documents.size() - 1);
}

}  // namespace

std::string report_page(const std::vector<io::ResultDocument>& documents, const std::vector<Overlay>& overlays) {
  if (documents.empty())
    throw InputError("a report needs at least one result", "name a result file of `ringfilm run --output`");
  check_overlays(overlays);
  const page_template::PageTemplate parts = page_template::report();
  std::string page(parts.before_title);
  page += html_text(page_title(documents));
  page += parts.before_data;
  page += payload(documents, overlays);
  page += parts.after_data;
  return page;
}

}  // namespace ringfilm::report
