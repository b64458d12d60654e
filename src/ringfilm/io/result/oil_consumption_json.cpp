#include "ringfilm/io/result/oil_consumption_json.hpp"

#include "ringfilm/io/result/record_json.hpp"

namespace ringfilm::io {
namespace {

using nlohmann::ordered_json;

ordered_json band_object(const cycle::OilLoss& loss) {
  return {{"low", loss.low}, {"value", loss.value}, {"high", loss.high}, {"assumption", loss.assumption}};
}

}  // namespace

ordered_json oil_consumption_object(const std::vector<cycle::OilLoss>& losses) {
  ordered_json total = ordered_json::object(), parts = ordered_json::object(), units = ordered_json::object();
  for (const cycle::OilLoss& loss : losses) {
    if (loss.name == cycle::kTotalOilLoss) {
      total = band_object(loss);
      for (const char* end : {"low", "value", "high"}) units[end] = loss.unit;
    } else {
      parts[loss.name] = band_object(loss);
      units[loss.name] = loss.unit;
    }
  }
  total.update(parts);
  total["narrowed_by"] = record_array(cycle::narrowed_bands(losses));
  units["band_share"] = "1";
  total["units"] = std::move(units);
  return total;
}

}  // namespace ringfilm::io
