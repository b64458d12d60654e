#include "ringfilm/io/life/wear_json.hpp"

#include <nlohmann/json.hpp>

#include "ringfilm/base/table.hpp"

namespace ringfilm::io {

using nlohmann::ordered_json;

namespace {

ordered_json fit_object(const life::CoefficientFit& fit) {
  ordered_json object = {{"coefficient", {fit.range.low, fit.range.high}}, {"largest_worn_area", fit.largest_area}};
  ordered_json& rows = object["rows"] = ordered_json::array();
  for (const life::FittedCoefficient& row : fit.rows) {
    const bool is_bound = row.basis == life::FitBasis::kMinWear;
    ordered_json one = {{"hours", row.time / life::kHour}, {"basis", is_bound ? "least-wear" : "closest-face"}};
    one[is_bound ? "untrusted_margin" : "half_width"] = row.trusted;
    one["worn_area"] = row.worn_area;
    if (row.rms) one["rms"] = *row.rms;
    if (!is_bound) one["face_is_flat"] = row.is_flat;
    one["coefficient"] = row.coefficient ? ordered_json(*row.coefficient) : ordered_json();
    rows.push_back(std::move(one));
  }
  return object;
}

}  // namespace

ordered_json wear_units() {
  return {{"coefficient", "m2/N"},
          {"running_in_coefficient", "m2/N"},
          {"implied_coefficient", "m2/N"},
          {"running_in_hours", "h"},
          {"coating_worn_through_hours", "h"},
          {"wedge_gone_hours", "h"},
          {"stage_difference", "m"},
          {"volume_balance_error", "1"},
          {"largest_worn_area", "m2"},
          {"roughness_limit", "m"},
          {"depth_scale", "m"}};
}

ordered_json hours_or_null(const std::optional<double>& time) {
  return time ? ordered_json(*time / life::kHour) : ordered_json();
}

ordered_json measured_faces(const LifeDocument& document) {
  ordered_json faces = ordered_json::array();
  for (const life::MeasuredState& state : document.file.life.states) {
    const life::FaceHeights face = life::face_heights(state.input);
    std::vector<double> heights;
    for (const double x : document.result.states.front().x)
      heights.push_back(interpolate_linear(face.x, face.height, x));
    faces.push_back({{"hours", state.time / life::kHour}, {"face_height", heights}});
  }
  return faces;
}

ordered_json wear_object(const LifeDocument& document) {
  const life::Wear& wear = document.file.life.wear;
  const std::optional<life::RunningIn>& running_in = document.file.life.running_in;
  const life::WearSummary& summary = *document.result.wear;
  ordered_json object = {{"coefficient", summary.coefficient},
                         {"coefficient_origin", summary.fit ? "tuned" : "assumed"}};
  if (wear.running_in_coefficient) {
    object["running_in_coefficient"] = *wear.running_in_coefficient;
    object["running_in_hours"] = wear.running_in_time / life::kHour;
  }
  object["surface"] = running_in ? "running-in" : wear.surface == life::WornSurface::kFrozen ? "frozen" : "path";
  if (running_in) {
    object["running_in"] = {{"roughness_limit", running_in->roughness_limit},
                            {"depth_scale", running_in->depth_scale},
                            {"surface", running_in->surface == life::RunningInSurface::kLiner ? "liner" : "ring"}};
  }
  object["scheme"] = wear.scheme == life::WearScheme::kHeun ? "heun" : "euler";
  object["jumps"] = summary.effort.jumps;
  object["rejected_jumps"] = summary.effort.rejected_jumps;
  object["stage_difference"] = summary.effort.stage_difference;
  object["volume_balance_error"] = summary.effort.balance_error;
  object["coating_worn_through_hours"] =
      summary.worn_through ? hours_or_null(summary.worn_through->time) : ordered_json();
  object["wedge_gone_hours"] = hours_or_null(summary.wedge_gone);
  if (summary.fit) object["fit"] = fit_object(*summary.fit);
  if (summary.implied) object["implied_coefficient"] = {summary.implied->low, summary.implied->high};
  return object;
}

}  // namespace ringfilm::io
