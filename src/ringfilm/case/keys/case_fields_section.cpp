#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

constexpr When kSection{[](const Case& c) { return c.ring.section.is_stated(); }, "the section of the ring is stated"};
constexpr When kSectionByForm{[](const Case& c) { return c.ring.section.form != SectionForm::kNone; },
                              "ring.section_form is stated"};
constexpr When kSectionBevelled{[](const Case& c) { return c.ring.section.form == SectionForm::kInnerBevel; },
                                "ring.section_form = \"inner-bevel\""};
constexpr When kSectionStepped{[](const Case& c) { return c.ring.section.form == SectionForm::kNapier; },
                               "ring.section_form = \"napier\""};
constexpr When kSectionTapered{[](const Case& c) {
                                 const SectionForm form = c.ring.section.form;
                                 return form == SectionForm::kTaper || form == SectionForm::kNapier;
                               },
                               "ring.section_form = \"taper\" or \"napier\""};
constexpr When kSectionKeystone{[](const Case& c) { return c.ring.section.form == SectionForm::kKeystone; },
                                "ring.section_form = \"keystone\""};

/// All problems with a ring use its section.
constexpr Uses kRingBody{.closure = true, .gas = true};

ChoiceKind sides_of_section(const Ref<models::SectionSide>& side) {
  ChoiceKind kind;
  kind.names = {"chamber", "crankcase", "both"};
  kind.index = [side](const Case& c) { return static_cast<int>(side(c)); };
  kind.choose = [side](Case& c, int index) { side(c) = static_cast<models::SectionSide>(index); };
  return kind;
}

template <auto Member>
auto of_section = member<&Case::ring, &Ring::section, Member>;

}  // namespace

void append_section_fields(std::vector<Field>& fields) {
  fields.insert(
      fields.end(),
      {
          field({.key = "ring.section",
                 .kind = CornersKind{of_section<&RingSection::corners>},
                 .unit = kMillimetre,
                 .range = between(-0.1, 0.1),
                 .need = Need::kOptional,
                 .help = "corners of the section, axial from the chamber side and radial from the face inwards; if "
                         "omitted, by ring.section_form",
                 .example = "[[\"0 mm\", \"0 mm\"], [\"1.2 mm\", \"0 mm\"], [\"1.2 mm\", \"3.5 mm\"], [\"0 mm\", "
                            "\"3.5 mm\"]]",
                 .uses = kRingBody}),
          field({.key = "ring.section_form",
                 .kind = choice<&Case::ring, &Ring::section, &RingSection::form>(
                     {{"none", SectionForm::kNone},
                      {"rectangular", SectionForm::kRectangular},
                      {"inner-bevel", SectionForm::kInnerBevel},
                      {"napier", SectionForm::kNapier},
                      {"taper", SectionForm::kTaper},
                      {"keystone", SectionForm::kKeystone}}),
                 .help = "form of the section, radial_thickness thick, by which the ring twists; none: it does not",
                 .example = "\"inner-bevel\"",
                 .uses = kRingBody}),
          field({.key = "ring.section_height",
                 .kind = OptionalNumberKind{of_section<&RingSection::height>},
                 .unit = kMillimetre,
                 .range = above(0, 0.1),
                 .need = Need::kOptional,
                 .when = kSectionByForm,
                 .help = "height of the section along the bore's axis; if omitted, the face width and a step below it",
                 .example = "\"1.5 mm\"",
                 .uses = kRingBody}),
          field({.key = "ring.bevel_width",
                 .kind = NumberKind{of_section<&RingSection::bevel_width>},
                 .unit = kMillimetre,
                 .range = above(0, 0.05),
                 .need = Need::kRequired,
                 .when = kSectionBevelled,
                 .help = "width of the inner bevel along the flank",
                 .example = "\"0.6 mm\"",
                 .uses = kRingBody}),
          field({.key = "ring.bevel_angle",
                 .kind = NumberKind{of_section<&RingSection::bevel_angle_deg>},
                 .unit = si_unit("degree"),
                 .range = between(5, 85),
                 .when = kSectionBevelled,
                 .help = "angle of the inner bevel against the flank; usual, assumed",
                 .example = "\"45 degree\"",
                 .uses = kRingBody}),
          field({.key = "ring.bevel_side",
                 .kind = sides_of_section(of_section<&RingSection::bevel_side>),
                 .when = kSectionBevelled,
                 .help = "inner corner that is cut off; that towards the chamber makes a positive twist",
                 .example = "\"chamber\"",
                 .uses = kRingBody}),
          field({.key = "ring.step_height",
                 .kind = NumberKind{of_section<&RingSection::step_height>},
                 .unit = kMillimetre,
                 .range = above(0, 0.05),
                 .need = Need::kRequired,
                 .when = kSectionStepped,
                 .help = "height of the step below the face, along the bore's axis",
                 .example = "\"0.4 mm\"",
                 .uses = kRingBody}),
          field({.key = "ring.step_depth",
                 .kind = NumberKind{of_section<&RingSection::step_depth>},
                 .unit = kMillimetre,
                 .range = above(0, 0.05),
                 .need = Need::kRequired,
                 .when = kSectionStepped,
                 .help = "radial depth of the step below the face",
                 .example = "\"0.5 mm\"",
                 .uses = kRingBody}),
          field({.key = "ring.taper_angle",
                 .kind = NumberKind{of_section<&RingSection::taper_angle_deg>},
                 .unit = si_unit("degree"),
                 .range = between(0, 15),
                 .when = kSectionTapered,
                 .help = "angle of the face in the section against the bore's axis; ring.face has the face of the film",
                 .example = "\"1 degree\"",
                 .uses = kRingBody}),
          field({.key = "ring.keystone_angle",
                 .kind = NumberKind{of_section<&RingSection::keystone_angle_deg>},
                 .unit = si_unit("degree"),
                 .range = above(0, 40),
                 .need = Need::kRequired,
                 .when = kSectionKeystone,
                 .help = "angle between both flanks of a keystone ring",
                 .example = "\"15 degree\"",
                 .uses = kRingBody}),
          field({.key = "ring.keystone_side",
                 .kind = sides_of_section(of_section<&RingSection::keystone_side>),
                 .when = kSectionKeystone,
                 .help = "inclined flanks of a keystone ring; one of them: a half-keystone ring",
                 .example = "\"both\"",
                 .uses = kRingBody}),
          field({.key = "ring.groove_height",
                 .kind = OptionalNumberKind{of_section<&RingSection::groove_height>},
                 .unit = kMillimetre,
                 .range = above(0, 0.1),
                 .need = Need::kOptional,
                 .when = kSection,
                 .help = "height of the groove at its mouth; with the section one of the ways to state the side "
                         "clearance",
                 .example = "\"1.25 mm\"",
                 .uses = {.gas = true}}),
          field({.key = "ring.clearance_protrusion",
                 .kind = OptionalNumberKind{of_section<&RingSection::clearance_protrusion>},
                 .unit = kMillimetre,
                 .range = between(-0.01, 0.02),
                 .need = Need::kOptional,
                 .when = kSectionKeystone,
                 .help = "how far the face stood out of the piston land where side_clearance was measured; if omitted, "
                         "as far as in the bore",
                 .example = "\"0 mm\"",
                 .uses = {.gas = true}}),
          field({.key = "ring.twist",
                 .kind = choice<&Case::ring, &Ring::section, &RingSection::twist>(
                     {{"none", RingTwist::kNone}, {"quasi-static", RingTwist::kQuasiStatic}}),
                 .when = kSection,
                 .help = "whether the section turns by the balance of moments in each step, and the face with it",
                 .example = "\"quasi-static\""}),
      });
}

}  // namespace ringfilm::cycle::table
