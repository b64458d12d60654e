#pragma once
#include <utility>

#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/setup/contact_setup.hpp"

namespace ringfilm::cycle::testing {

/// The law of a case as a table, so that the cycle is known. @param first @param last lambda ratios of the table
inline Case with_table(Case c, double first = 0, double last = 5) {
  const auto law = asperity_contact(c);
  ContactLawTable table;
  table.composite_roughness = roughness(c);
  table.composite_modulus = composite_modulus(c);
  for (double lambda = first; lambda < last + 1e-9; lambda += 0.1) {
    const auto at = law->contact(lambda * table.composite_roughness);
    table.rows.h.push_back(lambda * table.composite_roughness);
    table.rows.pressure.push_back(at.pressure);
    table.rows.area_share.push_back(at.area_share);
    table.mean_gap.push_back(lambda * table.composite_roughness);
  }
  table.last_supported_separation = table.rows.h.back();
  c.contact.model = ContactLaw::kTable;
  c.contact.law_file = "law.nc";
  c.contact.law = base::Shared<ContactLawTable>(std::move(table));
  return c;
}

}  // namespace ringfilm::cycle::testing
