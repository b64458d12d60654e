#include "ringfilm/io/study/study_curves.hpp"
#include "ringfilm/report/payload/payload_numbers.hpp"
#include "ringfilm/report/payload/payload_study.hpp"

namespace ringfilm::report {
namespace {

using nlohmann::ordered_json;

constexpr int kBandDigits = 5;
/// A chart has hardly more pixels across.
constexpr std::size_t kMostAngles = 720;

ordered_json every(const std::vector<double>& values, std::size_t stride) {
  ordered_json list = ordered_json::array();
  for (std::size_t k = 0; k < values.size(); k += stride) list.push_back(rounded(values[k], kBandDigits));
  return list;
}

}  // namespace

void add_study_curves(const io::StudyRows& rows, ordered_json& payload) {
  payload["curves"] = nullptr;
  const std::vector<io::CurveBand> bands = io::curve_bands(rows);
  if (bands.empty()) return;
  const std::vector<double> angles = io::kept_angles(rows.plan.study().keep);
  const std::size_t stride = (angles.size() + kMostAngles - 1) / kMostAngles;
  ordered_json described = ordered_json::array(), list = ordered_json::array();
  for (const io::CurveBand& band : bands) {
    if (band.curve == described.size()) {
      described.push_back({{"name", band.quantity.name},
                           {"unit", band.quantity.unit},
                           {"display_unit", band.quantity.display_unit},
                           {"long_name", band.quantity.long_name}});
    }
    ordered_json values = ordered_json::array();
    for (const std::vector<double>& curve : band.values) values.push_back(every(curve, stride));
    list.push_back({{"base", band.base}, {"quantity", band.curve}, {"values", std::move(values)}});
  }
  payload["curves"] = {{"angles", every(angles, stride)},
                       {"shares", bands.front().shares},
                       {"quantities", std::move(described)},
                       {"bands", std::move(list)}};
}

}  // namespace ringfilm::report
