#pragma once
#include "ringfilm/cycle/contact_curves.hpp"
#include "ringfilm/io/result/result_file_quantities.hpp"

/// What a result file holds of the contact law: a part of the description in result_file_layout.hpp.
namespace ringfilm::io {

/// Nothing where there is no contact; files of earlier versions have none.
template <class File, class Contact>
void exchange_contact(File& file, Contact& contact) {
  const cycle::Quantity separation =
      described("contact_separation", "m", "distance of the mean planes of both surfaces", "h", "eq-lambda-ratio");
  if constexpr (File::kReads) {
    if (!file.has_variable(separation.name)) return;
  } else {
    if (contact.separation.empty()) return;
  }
  file.numbers({"contact_separation"}, separation, contact.separation);
  exchange_rows(file, "contact_law", "contact_law_", contact.laws);
  for_each_of(cycle::curves_of_laws(), [&](const auto& member) {
    file.numbers({"contact_law", "contact_separation"}, described("contact_law_", member), contact.*member.value);
  });
  for_each_member<cycle::ContactCurves>([&](const auto& member) {
    exchange_present(file, {"contact_separation"}, described("contact_law_", member), contact.*member.value);
  });
}

}  // namespace ringfilm::io
