#include "ringfilm/case/keys/case_fields_table.hpp"

namespace ringfilm::cycle::table {
namespace {

template <auto Member>
Field text(const char* key, const char* help, const char* example) {
  return field({.key = std::string("contact.measured.") + key,
                .kind = OptionalTextKind{member<&Case::contact, &Contact::measured, Member>},
                .need = Need::kOptional,
                .help = help,
                .example = example,
                .is_for_record = true});
}

template <auto Member>
Field number(const char* key, const DisplayUnit& unit, Range range, const char* help, const char* example) {
  return field({.key = std::string("contact.measured.") + key,
                .kind = OptionalNumberKind{member<&Case::contact, &Contact::measured, Member>},
                .unit = unit,
                .range = range,
                .need = Need::kOptional,
                .help = help,
                .example = example,
                .is_for_record = true});
}

template <auto Member>
Field strength_text(const char* key, const char* help, const char* example) {
  return field(
      {.key = std::string("contact.measured.shear_strength.") + key,
       .kind = OptionalTextKind{member<&Case::contact, &Contact::measured, &MeasuredContact::shear_strength, Member>},
       .need = Need::kOptional,
       .help = help,
       .example = example,
       .is_for_record = true});
}

template <auto Member>
Field strength_deviation(const char* key, const char* help, const char* example) {
  return field(
      {.key = std::string("contact.measured.shear_strength.") + key,
       .kind = OptionalNumberKind{member<&Case::contact, &Contact::measured, &MeasuredContact::shear_strength, Member>},
       .unit = kPlainNumber,
       .range = between(0, 5),
       .need = Need::kOptional,
       .help = help,
       .example = example,
       .is_for_record = true});
}

}  // namespace

void append_measured_fields(std::vector<Field>& fields) {
  using M = MeasuredContact;
  using S = MeasuredShearStrength;
  const Range correlation = between(-1, 1);
  fields.insert(
      fields.end(),
      {
          text<&M::ring_surface>("ring_surface", "file, channel and region of the ring's surface", "\"ring.x3p\""),
          text<&M::liner_surface>("liner_surface", "file, channel and region of the liner's surface", "\"liner.x3p\""),
          text<&M::filter>("filter", "what was removed before N, beta and sigma", "\"plane, Gaussian ISO 16610-61\""),
          number<&M::long_cutoff>("long_cutoff", kMillimetre, above(0, 1),
                                  "longest wavelength that was kept; the nesting index of the filter", "\"0.8 mm\""),
          number<&M::short_cutoff>("short_cutoff", kMicrometre, above(0, 1),
                                   "shortest wavelength that was kept; N and beta depend on it", "\"2.5 um\""),
          number<&M::step>("step", kMicrometre, above(0, 1), "distance of points; N and beta depend on it",
                           "\"0.5 um\""),
          text<&M::roughness_rule>("roughness_rule", "how sigma was made of both surfaces", "\"Rq, root-sum-square\""),
          text<&M::difference_scheme>("difference_scheme", "how slopes and curvatures were made of heights",
                                      "\"central, 3 points\""),
          number<&M::regions>("regions", kPlainNumber, between(1, 1e9), "how many regions were measured", "12"),
          number<&M::asperity_density_deviation>("asperity_density_deviation", kPerSquareMicrometre, between(0, 1e18),
                                                 "standard deviation of N between the regions", "\"0.01 um-2\""),
          number<&M::asperity_radius_deviation>("asperity_radius_deviation", kMicrometre, between(0, 1e-2),
                                                "standard deviation of beta between the regions", "\"0.2 um\""),
          number<&M::roughness_deviation>("roughness_deviation", kMicrometre, between(0, 1e-4),
                                          "standard deviation of sigma between the regions", "\"0.05 um\""),
          number<&M::density_radius_correlation>("density_radius_correlation", kPlainNumber, correlation,
                                                 "correlation of N and beta over the regions", "-0.6"),
          number<&M::density_roughness_correlation>("density_roughness_correlation", kPlainNumber, correlation,
                                                    "correlation of N and sigma over the regions", "0.1"),
          number<&M::radius_roughness_correlation>("radius_roughness_correlation", kPlainNumber, correlation,
                                                   "correlation of beta and sigma over the regions", "-0.5"),
          strength_text<&S::loops>("loops", "file of the friction loops, and sample", "\"new_ring.csv\""),
          strength_text<&S::method>("method", "how the lateral signal was calibrated: silicon, geometry or wedge",
                                    "\"silicon\""),
          strength_text<&S::calibration>("calibration", "name of the calibration; cases that share it are correlated",
                                         "\"silicon, tip 4\""),
          strength_deviation<&S::slope_deviation>("slope_deviation",
                                                  "standard deviation of zeta by the sample's own line", "0.01"),
          strength_deviation<&S::calibration_deviation>(
              "calibration_deviation", "standard deviation of zeta by the measurement of the calibration", "0.008"),
          strength_deviation<&S::reference_deviation>(
              "reference_deviation", "standard deviation of zeta by the value that the calibration took over", "0.06"),
      });
}

}  // namespace ringfilm::cycle::table
