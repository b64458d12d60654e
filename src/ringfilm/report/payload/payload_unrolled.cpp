#include "ringfilm/report/payload/payload_unrolled.hpp"

#include "ringfilm/io/result/record_json.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/unrolled_picture.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kPlaceDigits = 8;
constexpr int kStripDigits = 5;

ordered_json packed_fields(const std::vector<PackedField>& fields) {
  ordered_json object = ordered_json::object();
  for (const PackedField& field : fields) {
    object[field.name] = {{"low", exact(field.low)}, {"high", exact(field.high)}, {"data", packed(field.values)}};
  }
  return object;
}

ordered_json points(const std::vector<MapPoint>& list) {
  ordered_json array = ordered_json::array();
  for (const MapPoint& point : list) {
    array.push_back({{"x", rounded(point.x, kPlaceDigits)},
                     {"y", rounded(point.y, kPlaceDigits)},
                     {"value", rounded(point.value, kStripDigits)}});
  }
  return array;
}

}  // namespace

ordered_json unrolled_payload(const cycle::UnrolledFields& fields, std::optional<double> rupture_pressure) {
  const UnrolledPicture picture = unrolled_picture(fields);
  const StripPicture strips = strip_picture(fields);
  if (picture.fields.empty() && strips.fields.empty()) return nullptr;
  return {{"circumference", exact(fields.circumference)},
          {"end_gap", exact(fields.end_gap)},
          {"gap_position", exact(fields.gap_position)},
          {"stored", {{"angles", fields.crank_angle_deg.size()}, {"y", fields.y.size()}, {"x", fields.x.size()}}},
          {"crank_angle", rounded_list(picture.crank_angle_deg, kPlaceDigits)},
          {"y", rounded_list(picture.y, kPlaceDigits)},
          {"x", rounded_list(picture.x, kPlaceDigits)},
          {"fields", packed_fields(picture.fields)},
          {"highest_pressure", points(picture.highest_pressure)},
          {"lowest_film_content", points(picture.lowest_film_content)},
          {"rupture_pressure", rupture_pressure ? exact(*rupture_pressure) : ordered_json(nullptr)},
          {"strips",
           {{"crank_angle", rounded_list(strips.crank_angle_deg, kPlaceDigits)},
            {"y", rounded_list(strips.fields.empty() ? std::vector<double>{} : fields.y, kPlaceDigits)},
            {"fields", packed_fields(strips.fields)}}}};
}

ordered_json unrolled_values(const cycle::CycleResult& result) {
  if (result.unrolled.is_absent()) return nullptr;
  return io::quantities_object(cycle::unrolled_cycle_quantities(), result.unrolled_values);
}

void add_unrolled_curves(const cycle::CycleResult& result, int digits, ordered_json& curves) {
  if (result.unrolled_samples.empty() || result.unrolled_samples.size() != result.samples.size()) return;
  for (const cycle::UnrolledQuantity& q : cycle::unrolled_quantities()) {
    ordered_json list = ordered_json::array();
    for (const cycle::UnrolledSample& sample : result.unrolled_samples)
      list.push_back(rounded(sample.*q.value, digits));
    curves[q.name] = std::move(list);
  }
}

}  // namespace ringfilm::report
