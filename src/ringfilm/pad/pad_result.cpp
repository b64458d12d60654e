#include "ringfilm/pad/pad_result.hpp"

#include <algorithm>
#include <cmath>

namespace ringfilm::pad {

const std::vector<PadQuantity>& pad_quantities() {
  using S = Sample;
  static const std::vector<PadQuantity> table = {
      {{"load", "N/m", "kN/m", "load carried, with the gas at the edges", "W", "eq-pad-load"}, &S::load},
      {{"friction_moving", "N/m", "N/m", "friction on the moving surface, positive against its motion", "F_moving",
        "eq-pad-friction"},
       &S::friction_moving},
      {{"friction_fixed", "N/m", "N/m", "friction on the fixed pad, positive along the motion", "F_fixed",
        "eq-pad-friction"},
       &S::friction_fixed},
      {{"friction_coefficient", "1", "1", "friction on the moving surface over load", "mu", "eq-pad-friction"},
       &S::friction_coefficient},
      {{"flow_left", "m2/s", "mm2/s", "volume flow through x = 0, positive in +x", "dot V_0", "eq-pad-flow"},
       &S::flow_left},
      {{"flow_right", "m2/s", "mm2/s", "volume flow through x = length, positive in +x", "dot V_L", "eq-pad-flow"},
       &S::flow_right},
      {{"mass_flow_left", "kg/(m s)", "g/(m s)", "mass flow through x = 0, positive in +x", "dot m_0", "eq-pad-flow"},
       &S::mass_flow_left},
      {{"mass_flow_right", "kg/(m s)", "g/(m s)", "mass flow through x = length, positive in +x", "dot m_L",
        "eq-pad-flow"},
       &S::mass_flow_right},
      {{"peak_film_pressure", "Pa", "MPa", "peak film pressure", "p_max", "eq-reynolds"}, &S::peak_film_pressure},
      {{"peak_position", "m", "mm", "where the film pressure peaks", "x_max", "eq-reynolds"}, &S::peak_position},
      {{"mean_film_pressure", "Pa", "MPa", "mean film pressure", "W/L", "eq-pad-load"}, &S::mean_film_pressure},
      {{"separation", "m", "um", "separation, which adds to the gap", "s", "eq-pad-gap"}, &S::separation},
      {{"min_film_thickness", "m", "um", "minimum film thickness", "h_m", "eq-pad-gap"}, &S::min_film_thickness},
      {{"cavitated_fraction", "1", "%", "cavitated share of the length", "", "eq-complementarity"},
       &S::cavitated_fraction},
      {{"wetted_left", "m", "mm", "left end of the wetted length", "x_1", "eq-gas-film"}, &S::wetted_left},
      {{"wetted_right", "m", "mm", "right end of the wetted length", "x_2", "eq-gas-film"}, &S::wetted_right},
      {{"film_load", "N/m", "kN/m", "load carried on the wetted length", "W_h", "eq-pad-load"}, &S::film_load},
      {{"gas_load", "N/m", "kN/m", "load carried by the gas at the edges", "W_g", "eq-pad-load"}, &S::gas_load},
      {{"asperity_load", "N/m", "kN/m", "load carried by asperities", "W_a", "eq-asperity-load"}, &S::asperity_load},
      {{"boundary_friction", "N/m", "N/m", "friction of asperities, in both frictions", "f_b", "eq-boundary-friction"},
       &S::boundary_friction},
      {{"film_left_behind", "m", "um", "film on the moving surface where it leaves", "h*/2", "eq-gas-film"},
       &S::film_left_behind},
      {{"gas_breakthrough", "1", "1", "1 where gas of an edge reaches the lowest place of the gap", "",
        "eq-pressure-bound"},
       &S::gas_breakthrough},
      {{"stable_solutions", "1", "1", "stable separations that carry the load", "n", "eq-pad-load"},
       &S::stable_solutions},
      {{"journal_load", "N/m", "kN/m", "load on the journal, the resultant of the film pressure", "W_J",
        "eq-pad-journal"},
       &S::journal_load},
      {{"journal_load_angle", "degree", "degree", "direction of the journal load, from x = 0 towards +x", "alpha_J",
        "eq-pad-journal"},
       &S::journal_load_angle},
      {{"attitude_angle", "degree", "degree", "from the journal load to the lowest place of the gap, along the motion",
        "phi_J", "eq-pad-journal"},
       &S::attitude_angle},
      {{"film_temperature", "K", "degC", "temperature of the film", "T", "eq-film-temperature"}, &S::film_temperature},
      {{"viscous_heating_rise", "K", "K", "temperature rise of the film by viscous heating, above its walls", "Delta T",
        "eq-viscous-heating"},
       &S::viscous_heating_rise},
      {{"mass_residual", "1", "1", "balance of mass, relative to the largest flow", "r_m", "eq-discrete-balance"},
       &S::mass_residual},
      {{"time", "s", "s", "time", "t", "eq-reynolds"}, &S::time},
  };
  return table;
}

const std::vector<PadQuantity>& width_quantities() {
  using S = Sample;
  static const std::vector<PadQuantity> table = {
      {{"total_load", "N", "kN", "load carried by the whole width", "W_B", "eq-pad-total"}, &S::total_load},
      {{"total_friction_moving", "N", "N", "friction of the whole width on the moving surface", "F_B,moving",
        "eq-pad-total"},
       &S::total_friction_moving},
      {{"total_friction_fixed", "N", "N", "friction of the whole width on the fixed pad", "F_B,fixed", "eq-pad-total"},
       &S::total_friction_fixed},
      {{"flow_front", "m3/s", "mm3/s", "volume flow through y = 0, positive in +y", "dot Q_0", "eq-pad-side-flow"},
       &S::flow_front},
      {{"flow_back", "m3/s", "mm3/s", "volume flow through y = width, positive in +y", "dot Q_B", "eq-pad-side-flow"},
       &S::flow_back},
      {{"mass_flow_front", "kg/s", "mg/s", "mass flow through y = 0, positive in +y", "dot M_0", "eq-pad-side-flow"},
       &S::mass_flow_front},
      {{"mass_flow_back", "kg/s", "mg/s", "mass flow through y = width, positive in +y", "dot M_B", "eq-pad-side-flow"},
       &S::mass_flow_back},
      {{"peak_position_y", "m", "mm", "where across the pad the film pressure peaks", "y_max", "eq-film-2d-reynolds"},
       &S::peak_position_y},
  };
  return table;
}

const std::vector<FrontQuantity>& front_quantities() {
  static const std::vector<FrontQuantity> table = {
      {{"rupture_positions", "m", "mm", "where cavities begin, along the motion", "x_r", "eq-complementarity"},
       &Sample::rupture_positions},
      {{"reformation_positions", "m", "mm", "where the film forms again", "x_f", "eq-complementarity"},
       &Sample::reformation_positions},
  };
  return table;
}

const std::vector<cycle::Quantity>& profile_quantities() {
  static const std::vector<cycle::Quantity> table = {
      {"time", "s", "s", "time", "t", "eq-reynolds"},
      {"x", "m", "mm", "place along the pad", "x", "eq-pad-gap"},
      {"film_thickness", "m", "um", "film thickness", "h", "eq-pad-gap"},
      {"pressure", "Pa", "MPa", "film pressure", "p", "eq-reynolds"},
      {"film_content", "1", "1", "share of the gap that is oil", "theta", "eq-film-content"},
  };
  return table;
}

const cycle::Quantity& place_across() {
  static const cycle::Quantity quantity = {"y", "m", "mm", "place across the pad", "y", "eq-pad-gap"};
  return quantity;
}

std::vector<PadQuantity> reported_quantities(const PadResult& result) {
  std::vector<PadQuantity> reported = pad_quantities();
  if (result.y.empty()) return reported;
  for (const PadQuantity& quantity : width_quantities()) {
    const auto has_value = [&](const Sample& sample) { return !std::isnan(sample.*quantity.value); };
    if (std::any_of(result.samples.begin(), result.samples.end(), has_value)) reported.push_back(quantity);
  }
  return reported;
}

}  // namespace ringfilm::pad
