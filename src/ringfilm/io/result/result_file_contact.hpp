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
  using Law = cycle::ContactCurves::Law;
  file.numbers({"contact_separation"}, separation, contact.separation);
  file.rows("contact_law", contact.laws);
  file.column("contact_law", text("contact_law_name", "contact law, that of the case first"), contact.laws, &Law::name);
  file.column("contact_law", text("contact_law_label", "the same in words"), contact.laws, &Law::label);
  file.numbers({"contact_law", "contact_separation"},
               described("contact_law_pressure", "Pa", "contact pressure of the law", "p_a", "eq-asperity-load"),
               contact.pressure);
  file.numbers({"contact_law", "contact_separation"},
               described("contact_law_log_deviation", "1",
                         "standard deviation of the logarithm of that pressure by what was measured, NaN: not known",
                         "s(ln p)", "eq-law-band"),
               contact.log_deviation);
  file.numbers({"contact_separation"},
               described("contact_law_real_area", "1", "real contact area over the nominal one, law of the case", "A"),
               contact.real_area);
  const auto factor = [&](const char* name, const char* long_name, const char* symbol, auto& values) {
    const cycle::Quantity variable = described(name, "1", long_name, symbol, "eq-average-flow");
    if constexpr (File::kReads) {
      if (file.has_variable(variable.name)) file.numbers({"contact_separation"}, variable, values);
    } else {
      if (!values.empty()) file.numbers({"contact_separation"}, variable, values);
    }
  };
  factor("contact_law_phi_x", "pressure flow factor along the motion", "phi_x", contact.phi_x);
  factor("contact_law_phi_y", "pressure flow factor across the motion", "phi_y", contact.phi_y);
  factor("contact_law_phi_s", "shear flow factor, first surface at rest", "phi_s", contact.phi_s);
}

}  // namespace ringfilm::io
