#include <CLI/CLI.hpp>
#include <charconv>

#include "ringfilm/base/error.hpp"
#include "text/command_arguments.hpp"

namespace ringfilm::app {

void MapArguments::add_to(CLI::App& command, const std::string& usual_form) {
  command.add_option("--channel", reading.channel, "which channel of the file: its number from 1, or its name")
      ->type_name("N");
  command.add_option("--unit", reading.height_unit, "unit of the heights, where the file does not state it")
      ->type_name("UNIT");
  command.add_option("--lateral-unit", reading.lateral_unit, "unit of x and y, where the file does not state it")
      ->type_name("UNIT");
  command.add_option("--step-x", reading.step_x, "distance of points along a row, where the file does not state it")
      ->type_name("LENGTH");
  command.add_option("--step-y", reading.step_y, "distance of rows; the same as --step-x if omitted")
      ->type_name("LENGTH");
  command.add_option("--layout", layout, "of a text file: matrix, points (x, y, z) or profile")->type_name("LAYOUT");
  command.add_option("--form", form, "what is removed first: none, mean, tilt, cylinder or polynomial-K of degree K")
      ->default_str(usual_form)
      ->type_name("FORM");
  command.add_option("--short-cutoff", short_cutoff, "S-filter: waves shorter than this go")->type_name("LENGTH");
  command.add_option("--long-cutoff", long_cutoff, "L-filter: waves longer than this go")->type_name("LENGTH");
  command.add_flag("--robust", robust, "robust Gaussian filters, which pores and grooves do not pull down");
}

instrument::SurfaceOptions MapArguments::selected_reading(OptionValues& values) const {
  instrument::SurfaceOptions of = reading;
  if (layout) {
    using instrument::TableLayout;
    of.layout = values.chosen<TableLayout>(
        "--layout", *layout,
        {{"matrix", TableLayout::kMatrix}, {"points", TableLayout::kPoints}, {"profile", TableLayout::kProfile}});
  }
  return of;
}

surface::Preparation MapArguments::selected_preparation(OptionValues& values,
                                                        const surface::FormChoice& usual_form) const {
  surface::Preparation of;
  of.form = form_choice(values, usual_form);
  of.filter = robust ? surface::FilterKind::robust_gaussian : surface::FilterKind::gaussian;
  if (robust && !short_cutoff && !long_cutoff) {
    throw InputError("--robust names a filter, but there is no cut-off", "add --short-cutoff or --long-cutoff");
  }
  if (short_cutoff) of.short_cutoff_m = values.length("--short-cutoff", *short_cutoff, "2.5 um");
  if (long_cutoff) of.long_cutoff_m = values.length("--long-cutoff", *long_cutoff, "2.5 um");
  return of;
}

surface::FormChoice MapArguments::form_choice(OptionValues& values, const surface::FormChoice& usual_form) const {
  using surface::FormKind;
  if (!form) return usual_form;
  const std::string polynomial = "polynomial-";
  if (form->rfind(polynomial, 0) == 0) {
    int degree = -1;
    const char *begin = form->data() + polynomial.size(), *end = form->data() + form->size();
    const auto [stop, error] = std::from_chars(begin, end, degree);
    if (error == std::errc() && stop == end && degree >= 0 && degree <= 12) return {FormKind::polynomial, degree};
    throw InputError("--form " + *form + ": the degree is not a number from 0 to 12",
                     "for example --form polynomial-2");
  }
  return {values.chosen<FormKind>("--form", *form,
                                  {{"none", FormKind::none},
                                   {"mean", FormKind::mean},
                                   {"tilt", FormKind::tilt},
                                   {"cylinder", FormKind::cylinder},
                                   {"polynomial-2", FormKind::polynomial}}),
          2};
}

}  // namespace ringfilm::app
