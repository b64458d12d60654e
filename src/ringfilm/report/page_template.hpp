#pragma once
#include <string_view>

/// The pages as bundled at build time from src/ringfilm/report/page, each cut at its two gaps.
namespace ringfilm::report::page_template {

struct PageTemplate {
  std::string_view before_title;  ///< from the doctype to the title's text
  std::string_view before_data;   ///< style sheet and body up to the data
  std::string_view after_data;    ///< the script and the end of the page
};

PageTemplate report();
PageTemplate verification();
PageTemplate measurement();
PageTemplate study();
PageTemplate life();
PageTemplate gas();

}  // namespace ringfilm::report::page_template
