#include "ringfilm/cycle/result/result.hpp"

#include <iterator>

namespace ringfilm::cycle {

const std::vector<CurveQuantity>& curve_quantities() {
  using S = Sample;
  static const std::vector<CurveQuantity> table = {
      {{"crank_angle", "degree", "degree", "crank angle, 0 at firing TDC", "varphi", ""}, &S::crank_angle_deg},
      {{"piston_velocity", "m/s", "m/s", "piston velocity, positive towards TDC", "U_p", "eq-piston-velocity"},
       &S::piston_velocity},
      {{"gas_pressure", "Pa", "bar", "gas pressure above the ring, absolute", "p_g", ""}, &S::gas_pressure},
      {{"applied_load", "N", "N", "load that presses the ring on the liner", "W", "eq-applied-load"}, &S::applied_load},
      {{"min_film_thickness", "m", "um", "minimum film thickness", "h_m", "eq-film-thickness"}, &S::min_film_thickness},
      {{"lambda_ratio", "1", "1", "lambda ratio, minimum film over composite roughness", "lambda", "eq-lambda-ratio"},
       &S::lambda_ratio},
      {{"hydrodynamic_load", "N", "N", "load carried by the film", "W_h", "eq-hydrodynamic-load"},
       &S::hydrodynamic_load},
      {{"asperity_load", "N", "N", "load carried by asperities", "W_a", "eq-asperity-load"}, &S::asperity_load},
      {{"asperity_contact_area", "m2", "mm2", "real area of asperity contact", "A_a", "eq-asperity-area"},
       &S::asperity_contact_area},
      {{"boundary_friction", "N", "N", "boundary friction", "f_b", "eq-boundary-friction"}, &S::boundary_friction},
      {{"viscous_friction", "N", "N", "viscous friction on the liner, modulus", "f_v", "eq-viscous-friction"},
       &S::viscous_friction},
      {{"viscous_friction_ring", "N", "N", "viscous friction on the ring, signed", "F_v^-", "eq-viscous-friction"},
       &S::viscous_friction_ring},
      {{"total_friction", "N", "N", "total friction", "f_t", "eq-total-friction"}, &S::total_friction},
      {{"friction_on_liner", "N", "N", "friction on the liner, positive towards TDC", "F_liner",
        "eq-friction-on-liner"},
       &S::friction_on_liner},
      {{"friction_coefficient", "1", "1", "friction coefficient", "mu", "eq-friction-coefficient"},
       &S::friction_coefficient},
      {{"power_loss", "W", "W", "friction power loss", "P_l", "eq-power-loss"}, &S::power_loss},
      {{"oil_flow_middle", "kg/s", "mg/s", "oil flow at the middle section, positive to the crankcase", "dot m(b/2)",
        "eq-mass-flow"},
       &S::oil_flow_middle},
      {{"peak_film_pressure", "Pa", "bar", "peak film pressure, absolute", "p_max", "eq-reynolds"},
       &S::peak_film_pressure},
      {{"cavitated_fraction", "1", "%", "cavitated share of the face", "", "eq-complementarity"},
       &S::cavitated_fraction},
      {{"sliding_distance", "m", "mm", "sliding distance since firing TDC", "s", "eq-sliding-distance"},
       &S::sliding_distance},
      {{"piston_position", "m", "mm", "distance of the piston below TDC", "y_p", "eq-piston-position"},
       &S::piston_position},
      {{"crankcase_pressure", "Pa", "bar", "gas pressure below the ring, absolute", "p_cc", ""},
       &S::crankcase_pressure},
      {{"viscous_friction_liner", "N", "N", "viscous friction on the liner, positive towards TDC", "F_v^+",
        "eq-viscous-friction"},
       &S::viscous_friction_liner},
      {{"archard_wear_load_rate", "W", "W", "asperity load times sliding speed, the Archard wear load", "D",
        "eq-archard-wear-load"},
       &S::archard_wear_load_rate},
      {{"oil_flow_chamber_edge", "kg/s", "mg/s", "oil flow at the chamber edge, positive to the crankcase", "dot m(0)",
        "eq-mass-flow"},
       &S::oil_flow_chamber_edge},
      {{"oil_flow_crankcase_edge", "kg/s", "mg/s", "oil flow at the crankcase edge, positive to the crankcase",
        "dot m(b)", "eq-mass-flow"},
       &S::oil_flow_crankcase_edge},
      {{"stribeck_number", "1", "1", "Stribeck number", "S", "eq-stribeck-number"}, &S::stribeck_number},
      {{"rupture_position", "m", "um", "where the cavity begins, from the chamber edge", "x_r", "eq-complementarity"},
       &S::rupture_position},
      {{"reformation_position", "m", "um", "where the cavity ends, from the chamber edge", "x_f", "eq-complementarity"},
       &S::reformation_position},
      {{"asperity_load_share", "1", "%", "share of asperities in the load that they and the oil carry beyond the gas",
        "a", "eq-asperity-load-share"},
       &S::asperity_load_share},
      {{"mean_real_pressure", "Pa", "GPa", "mean pressure on the real area of contact, where asperities carry 1 %",
        "bar p", "eq-mean-real-pressure"},
       &S::mean_real_pressure},
      {{"wetted_begin", "m", "um", "chamber-side end of the wetted face, from the chamber edge", "x_1", "eq-gas-film"},
       &S::wetted_begin},
      {{"wetted_end", "m", "um", "crankcase-side end of the wetted face, from the chamber edge", "x_2", "eq-gas-film"},
       &S::wetted_end},
      {{"gas_breakthrough", "1", "1", "1 where gas of an edge reaches the lowest place of the face", "",
        "eq-pressure-bound"},
       &S::gas_breakthrough},
      {{"gas_flow_through_film", "kg/s", "mg/s", "gas flow through a broken film, positive to the crankcase", "dot m",
        "eq-face-flow"},
       &S::gas_flow_through_film},
      {{"film_temperature", "K", "degC", "temperature of the oil film", "T", "eq-film-temperature"},
       &S::film_temperature},
      {{"film_ahead", "m", "um", "oil on the liner ahead of the ring", "f", "eq-inlet-supply"}, &S::film_ahead},
      {{"film_left_behind", "m", "um", "oil on the liner behind the ring", "f_out", "eq-film-left"},
       &S::film_left_behind},
      {{"bead_volume", "m3", "mm3", "bead of scraped oil ahead of the ring", "V_b", "eq-bead"}, &S::bead_volume},
      {{"viscous_heating_rise", "K", "K", "temperature rise of the film by viscous heating, above its walls", "Delta T",
        "eq-viscous-heating"},
       &S::viscous_heating_rise},
      {{"flash_temperature", "K", "K", "flash temperature of boundary friction, mean rise of the liner's surface",
        "Delta T_f", "eq-flash-temperature"},
       &S::flash_temperature},
      {{"gas_holding_margin", "1", "1", "pressure difference that the film holds against gas over the one that acts",
        "m_g", "eq-gas-holding-margin"},
       &S::gas_holding_margin},
      {{"peak_shear_rate", "s-1", "s-1", "largest shear rate of the oil along the face", "dot gamma_max",
        "eq-shear-rate"},
       &S::peak_shear_rate},
      {{"max_local_deformation", "m", "um", "largest local deformation of face and liner, over that at the edges",
        "delta_max", "eq-local-deformation"},
       &S::max_local_deformation},
      {{"newton_iterations", "1", "1", "Newton iterations spent on the way to this angle", "n_it", "eq-load-balance"},
       &S::newton_iterations},
      {{"crank_sub_steps", "1", "1", "steps taken on the way to this angle", "n_step", "eq-load-balance"},
       &S::crank_sub_steps},
      {{"fallbacks", "1", "1", "steps that needed the bracketed search or a shorter step", "n_fall", "eq-load-balance"},
       &S::fallbacks},
      {{"load_residual", "1", "1", "imbalance of the load, relative", "r_W", "eq-load-balance"}, &S::load_residual},
  };
  return table;
}

const std::vector<CycleQuantity>& cycle_quantities() {
  constexpr bool kAddsUp = true;
  using V = CycleValues;
  static const std::vector<CycleQuantity> table = {
      {{"energy_per_cycle", "J", "J", "friction energy per cycle", "E", "eq-energy-per-cycle"},
       &V::energy_per_cycle,
       kAddsUp},
      {{"mean_power_loss", "W", "W", "mean friction power", "P_l,mean", "eq-mean"}, &V::mean_power_loss, kAddsUp},
      {{"fmep", "Pa", "kPa", "friction mean effective pressure", "FMEP", "eq-fmep"}, &V::fmep, kAddsUp},
      {{"mean_boundary_power", "W", "W", "mean boundary friction power", "P_b,mean", "eq-mean"},
       &V::mean_boundary_power,
       kAddsUp},
      {{"mean_viscous_power", "W", "W", "mean viscous friction power", "P_v,mean", "eq-mean"},
       &V::mean_viscous_power,
       kAddsUp},
      {{"mean_boundary_friction", "N", "N", "mean boundary friction", "f_b,mean", "eq-mean"},
       &V::mean_boundary_friction},
      {{"peak_boundary_friction", "N", "N", "peak boundary friction", "f_b,max", "eq-boundary-friction"},
       &V::peak_boundary_friction},
      {{"peak_boundary_friction_angle", "degree", "degree", "crank angle of the peak boundary friction", "varphi",
        "eq-boundary-friction"},
       &V::peak_boundary_friction_angle},
      {{"mean_viscous_friction", "N", "N", "mean viscous friction", "f_v,mean", "eq-mean"}, &V::mean_viscous_friction},
      {{"peak_viscous_friction", "N", "N", "peak viscous friction", "f_v,max", "eq-viscous-friction"},
       &V::peak_viscous_friction},
      {{"peak_viscous_friction_angle", "degree", "degree", "crank angle of the peak viscous friction", "varphi",
        "eq-viscous-friction"},
       &V::peak_viscous_friction_angle},
      {{"mean_total_friction", "N", "N", "mean total friction", "f_t,mean", "eq-mean"}, &V::mean_total_friction},
      {{"peak_total_friction", "N", "N", "peak total friction", "f_t,max", "eq-total-friction"},
       &V::peak_total_friction},
      {{"peak_total_friction_angle", "degree", "degree", "crank angle of the peak total friction", "varphi",
        "eq-total-friction"},
       &V::peak_total_friction_angle},
      {{"peak_friction_coefficient", "1", "1", "peak friction coefficient", "mu_max", "eq-friction-coefficient"},
       &V::peak_friction_coefficient},
      {{"peak_friction_coefficient_angle", "degree", "degree", "crank angle of the peak friction coefficient", "varphi",
        "eq-friction-coefficient"},
       &V::peak_friction_coefficient_angle},
      {{"peak_friction_coefficient_firing", "1", "1", "peak friction coefficient within 60 degree of firing TDC",
        "mu_max,60", "eq-friction-coefficient"},
       &V::peak_friction_coefficient_firing},
      {{"min_film_thickness", "m", "um", "minimum film thickness", "h_min", "eq-film-thickness"},
       &V::min_film_thickness},
      {{"min_film_thickness_angle", "degree", "degree", "crank angle of the minimum film thickness", "varphi",
        "eq-film-thickness"},
       &V::min_film_thickness_angle},
      {{"max_film_thickness", "m", "um", "largest minimum film thickness of the cycle", "h_max", "eq-film-thickness"},
       &V::max_film_thickness},
      {{"peak_gas_pressure", "Pa", "bar", "peak gas pressure above the ring, absolute", "p_g,max", ""},
       &V::peak_gas_pressure},
      {{"peak_gas_pressure_angle", "degree", "degree", "crank angle of the peak gas pressure", "varphi", ""},
       &V::peak_gas_pressure_angle},
      {{"lambda_ratio_at_peak_pressure", "1", "1", "lambda ratio at peak cylinder pressure", "lambda(p_g,max)",
        "eq-lambda-ratio"},
       &V::lambda_ratio_at_peak_pressure},
      {{"min_lambda_ratio", "1", "1", "lowest lambda ratio", "lambda_min", "eq-lambda-ratio"}, &V::min_lambda_ratio},
      {{"peak_mean_real_pressure", "Pa", "GPa", "largest mean pressure on the real area of contact", "bar p_max",
        "eq-mean-real-pressure"},
       &V::peak_mean_real_pressure},
      {{"boundary_regime_cycle_share", "1", "%", "share of the cycle in boundary lubrication", "t_b/T_c",
        "eq-regime-shares"},
       &V::boundary_regime_cycle_share},
      {{"mixed_regime_cycle_share", "1", "%", "share of the cycle in mixed lubrication", "t_m/T_c", "eq-regime-shares"},
       &V::mixed_regime_cycle_share},
      {{"full_film_cycle_share", "1", "%", "share of the cycle in full-film lubrication", "t_f/T_c",
        "eq-regime-shares"},
       &V::full_film_cycle_share},
      {{"boundary_regime_distance_share", "1", "%", "share of the sliding distance in boundary lubrication", "s_b/s_c",
        "eq-regime-shares"},
       &V::boundary_regime_distance_share},
      {{"mixed_regime_distance_share", "1", "%", "share of the sliding distance in mixed lubrication", "s_m/s_c",
        "eq-regime-shares"},
       &V::mixed_regime_distance_share},
      {{"full_film_distance_share", "1", "%", "share of the sliding distance in full-film lubrication", "s_f/s_c",
        "eq-regime-shares"},
       &V::full_film_distance_share},
      {{"boundary_regime_energy_share", "1", "%", "share of the friction energy in boundary lubrication", "E_b/E",
        "eq-regime-shares"},
       &V::boundary_regime_energy_share},
      {{"mixed_regime_energy_share", "1", "%", "share of the friction energy in mixed lubrication", "E_m/E",
        "eq-regime-shares"},
       &V::mixed_regime_energy_share},
      {{"full_film_energy_share", "1", "%", "share of the friction energy in full-film lubrication", "E_f/E",
        "eq-regime-shares"},
       &V::full_film_energy_share},
      {{"mean_friction_coefficient", "1", "1", "mean friction coefficient, weighted with the load", "mu_W",
        "eq-load-mean"},
       &V::mean_friction_coefficient},
      {{"mean_stribeck_number", "1", "1", "mean Stribeck number, weighted with the load", "S_W", "eq-load-mean"},
       &V::mean_stribeck_number},
      {{"mean_lambda_ratio", "1", "1", "mean lambda ratio, weighted with the load", "lambda_W", "eq-load-mean"},
       &V::mean_lambda_ratio},
      {{"net_oil_flow", "kg/s", "mg/s", "net oil flow at the middle section, positive to the crankcase", "dot m_net",
        "eq-mass-flow"},
       &V::net_oil_flow},
      {{"mean_absolute_oil_flow", "kg/s", "mg/s", "oil passing under the ring in its frame, mean without sign",
        "dot m_abs", "eq-mass-flow"},
       &V::mean_absolute_oil_flow},
      {{"peak_film_pressure", "Pa", "bar", "peak film pressure, absolute", "p_max", "eq-reynolds"},
       &V::peak_film_pressure},
      {{"mean_cavitated_fraction", "1", "%", "mean cavitated share of the face", "", "eq-complementarity"},
       &V::mean_cavitated_fraction},
      {{"oil_scraped_up", "kg", "mg", "oil that the ring leaves above it at TDC, per cycle", "m_up", "eq-bead"},
       &V::oil_scraped_up},
      {{"oil_scraped_down", "kg", "mg", "oil that the ring leaves below it at BDC, per cycle", "m_down", "eq-bead"},
       &V::oil_scraped_down},
      {{"oil_replenished", "kg", "mg", "oil that the oil ring lays on the liner, per cycle", "m_oil", "eq-oil-account"},
       &V::oil_replenished},
      {{"gas_through_film_forward", "kg", "mg", "gas through a broken film towards the crankcase in a cycle", "",
        "eq-face-flow"},
       &V::gas_through_film_forward},
      {{"gas_through_film_back", "kg", "mg", "gas through a broken film back towards the chamber in a cycle", "",
        "eq-face-flow"},
       &V::gas_through_film_back},
      {{"peak_viscous_heating_rise", "K", "K", "largest temperature rise of the film by viscous heating", "Delta T_max",
        "eq-viscous-heating"},
       &V::peak_viscous_heating_rise},
      {{"peak_viscous_heating_rise_angle", "degree", "degree", "crank angle of the largest rise by viscous heating",
        "varphi", "eq-viscous-heating"},
       &V::peak_viscous_heating_rise_angle},
      {{"peak_local_deformation", "m", "um", "largest local deformation of face and liner in the cycle", "delta_max",
        "eq-local-deformation"},
       &V::peak_local_deformation},
      {{"peak_local_deformation_angle", "degree", "degree", "crank angle of the largest local deformation", "varphi",
        "eq-local-deformation"},
       &V::peak_local_deformation_angle},
      {{"peak_flash_temperature", "K", "K", "largest flash temperature of boundary friction", "Delta T_f,max",
        "eq-flash-temperature"},
       &V::peak_flash_temperature},
      {{"peak_flash_temperature_angle", "degree", "degree", "crank angle of the largest flash temperature", "varphi",
        "eq-flash-temperature"},
       &V::peak_flash_temperature_angle},
      {{"archard_wear_load", "J", "J", "asperity load times sliding distance, per cycle", "int D dt",
        "eq-archard-wear-load"},
       &V::archard_wear_load},
      {{"power_stroke_energy", "J", "J", "friction energy of the power stroke", "E_1", "eq-energy-per-cycle"},
       &V::power_stroke_energy},
      {{"exhaust_stroke_energy", "J", "J", "friction energy of the exhaust stroke", "E_2", "eq-energy-per-cycle"},
       &V::exhaust_stroke_energy},
      {{"intake_stroke_energy", "J", "J", "friction energy of the intake stroke", "E_3", "eq-energy-per-cycle"},
       &V::intake_stroke_energy},
      {{"compression_stroke_energy", "J", "J", "friction energy of the compression stroke", "E_4",
        "eq-energy-per-cycle"},
       &V::compression_stroke_energy},
  };
  return table;
}

const std::vector<CycleQuantity>& summed_quantities() {
  static const std::vector<CycleQuantity> table = [] {
    std::vector<CycleQuantity> summed;
    for (const CycleQuantity& quantity : cycle_quantities()) {
      if (quantity.adds_over_rings) summed.push_back(quantity);
    }
    return summed;
  }();
  return table;
}

void add_ring(const CycleValues& ring, CycleValues& pack) {
  for (const CycleQuantity& quantity : summed_quantities()) pack.*quantity.value += ring.*quantity.value;
}

std::optional<std::size_t> cycle_quantity_index(const std::string& name) {
  const auto& all = cycle_quantities();
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (all[i].name == name) return i;
  }
  return std::nullopt;
}

const std::vector<StrokeFilm>& stroke_films() {
  static const std::vector<StrokeFilm> films = [] {
    std::vector<StrokeFilm> all;
    const char* strokes[] = {"power", "exhaust", "intake", "compression"};
    for (std::size_t k = 0; k < std::size(strokes); ++k) {
      const std::string stroke = strokes[k];
      all.push_back({{"film_ahead_" + stroke, "m", "um", "oil on the liner ahead of the ring, " + stroke + " stroke",
                      "f", "eq-inlet-supply"},
                     &StrokeProfile::film_ahead,
                     k});
      all.push_back({{"film_behind_" + stroke, "m", "um", "oil on the liner behind the ring, " + stroke + " stroke",
                      "f_out", "eq-film-left"},
                     &StrokeProfile::film_behind,
                     k});
    }
    return all;
  }();
  return films;
}

const std::vector<Quantity>& derived_quantities() {
  static const std::vector<Quantity> table = {
      {"elastic_pressure", "Pa", "MPa", "ring elastic pressure", "p_e", "eq-elastic-pressure"},
      {"tangential_force", "N", "N", "ring tangential force", "F_t", "eq-elastic-pressure"},
      {"composite_modulus", "Pa", "GPa", "composite modulus of 2/E' = sum (1 - nu^2)/E", "E'", "eq-composite-modulus"},
      {"roughness", "m", "um", "composite roughness as the contact model uses it", "sigma", "eq-lambda-ratio"},
      {"roughness_parameter", "1", "1", "roughness parameter", "N beta sigma", "eq-asperity-load"},
      {"asperity_bandwidth", "1", "1", "bandwidth parameter of the surface with these asperities", "alpha",
       "eq-spectral-moments"},
      {"asperity_slope", "1", "1", "rms slope of the surface with these asperities", "h'", "eq-spectral-moments"},
      {"summit_plane_offset", "m", "um", "mean plane of the summits above that of the surface", "z_s",
       "eq-summit-plane"},
      {"plasticity_index", "1", "1", "plasticity index; above 1 asperities deform plastically", "psi",
       "eq-plasticity-index"},
      {"oil_viscosity", "Pa s", "mPa s", "oil viscosity at its temperature (with [thermal] at mid stroke) and 1 atm",
       "eta", "eq-walther"},
      {"oil_density", "kg/m3", "kg/m3", "oil density at its temperature (with [thermal] at mid stroke) and 1 atm",
       "rho", "eq-density-temperature"},
      {"hths_viscosity", "Pa s", "mPa s", "viscosity of the oil at 150 degC and 1e6 s-1 by its law of shear thinning",
       "eta_HTHS", "eq-hths"},
      {"face_height_minimum", "m", "um", "lowest height of the face as given", "min h_s", "eq-face-polynomial"},
      {"face_height_chamber_edge", "m", "um", "height of the face at the chamber edge above its lowest point", "h_s(0)",
       "eq-face-polynomial"},
      {"face_height_crankcase_edge", "m", "um", "height of the face at the crankcase edge above its lowest point",
       "h_s(b)", "eq-face-polynomial"},
      {"nominal_contact_area", "m2", "mm2", "nominal area of ring and liner", "A", "eq-applied-load"},
      {"swept_volume", "m3", "cm3", "swept volume of the cylinder", "V_d", "eq-fmep"},
      {"mean_piston_speed", "m/s", "m/s", "mean piston speed", "", "eq-piston-velocity"},
      {"full_film_lambda_ratio", "1", "1", "lambda ratio above which asperities carry less than 1 % of the tension",
       "lambda_f", "eq-full-film-lambda"},
      {"property_fit_error", "1", "1", "relative difference of the oil's polynomials from its laws", "e_p",
       "eq-oil-fit"},
      {"property_fit_pressure", "Pa", "MPa", "pressure up to which the oil's polynomials serve", "p_high",
       "eq-oil-fit"},
  };
  return table;
}

const std::vector<UnrolledQuantity>& unrolled_quantities() {
  using S = UnrolledSample;
  static const std::vector<UnrolledQuantity> table = {
      {{"gap_leakage", "kg/s", "mg/s", "oil out of the film into the ring's gap", "dot m_g", "eq-gap-leakage"},
       &S::gap_leakage},
      {{"ends_share_load", "1", "%", "share of the gap's ends in the load carried", "e_W", "eq-end-share"},
       &S::ends_share_load},
      {{"ends_share_friction", "1", "%", "share of the gap's ends in the total friction", "e_f", "eq-end-share"},
       &S::ends_share_friction},
      {{"ends_share_flow", "1", "%", "share of the gap's ends in the oil flow at the middle section", "e_m",
        "eq-end-share"},
       &S::ends_share_flow},
      {{"gap_leakage_low_end", "kg/s", "mg/s", "oil out of the film into the gap at the end y = 0", "dot m_g,0",
        "eq-gap-leakage"},
       &S::gap_leakage_low_end},
      {{"gap_leakage_high_end", "kg/s", "mg/s", "oil out of the film into the gap at the end y = L", "dot m_g,L",
        "eq-gap-leakage"},
       &S::gap_leakage_high_end},
      {{"oil_flow_without_ends", "kg/s", "mg/s",
        "oil flow at the middle section if all were like the strip opposite the gap", "L q(b/2)", "eq-end-share"},
       &S::oil_flow_without_ends},
      {{"open_area", "m2", "mm2", "open area between ring and bore where the ring is lifted off", "A_o",
        "eq-film-2d-open-area"},
       &S::open_area},
      {{"lifted_angle", "degree", "degree", "angle around the bore where the ring is lifted off", "varphi_o",
        "eq-film-2d-open-area"},
       &S::lifted_angle},
      {{"max_clearance", "m", "um", "largest clearance around the ring", "h_max", "eq-film-2d-ring"},
       &S::max_clearance},
      {{"max_clearance_place", "degree", "degree", "place of the largest clearance, from the middle of the gap",
        "phi_max", "eq-film-2d-ring"},
       &S::max_clearance_place},
  };
  return table;
}

const std::vector<UnrolledCycleQuantity>& unrolled_cycle_quantities() {
  using V = UnrolledValues;
  static const std::vector<UnrolledCycleQuantity> table = {
      {{"mean_gap_leakage", "kg/s", "mg/s", "mean oil flow out of the film into the ring's gap", "dot m_g,mean",
        "eq-gap-leakage"},
       &V::mean_gap_leakage},
      {{"mean_absolute_gap_leakage", "kg/s", "mg/s", "mean absolute oil flow between film and gap", "dot m_g,abs",
        "eq-gap-leakage"},
       &V::mean_absolute_gap_leakage},
      {{"peak_gap_leakage", "kg/s", "mg/s", "largest oil flow between film and gap, positive into the gap",
        "dot m_g,max", "eq-gap-leakage"},
       &V::peak_gap_leakage},
      {{"peak_gap_leakage_angle", "degree", "degree", "crank angle of the largest oil flow between film and gap",
        "varphi", "eq-gap-leakage"},
       &V::peak_gap_leakage_angle},
      {{"gap_leakage_share", "1", "%", "mean absolute flow between film and gap over that at the middle section",
        "dot m_g,abs/dot m_abs", "eq-gap-leakage"},
       &V::gap_leakage_share},
      {{"ends_share_mean_load", "1", "%", "share of the gap's ends in the mean load", "e_W,mean", "eq-end-share"},
       &V::ends_share_mean_load},
      {{"ends_share_friction_power", "1", "%", "share of the gap's ends in the mean friction power", "e_P",
        "eq-end-share"},
       &V::ends_share_friction_power},
      {{"ends_share_absolute_flow", "1", "%",
        "share of the gap's ends in the mean absolute oil flow at the middle section", "e_m,abs", "eq-end-share"},
       &V::ends_share_absolute_flow},
      {{"mean_open_area", "m2", "mm2", "mean open area where the ring is lifted off", "A_o,mean",
        "eq-film-2d-open-area"},
       &V::mean_open_area},
      {{"peak_open_area", "m2", "mm2", "largest open area where the ring is lifted off", "A_o,max",
        "eq-film-2d-open-area"},
       &V::peak_open_area},
      {{"peak_open_area_angle", "degree", "degree", "crank angle of the largest open area", "varphi",
        "eq-film-2d-open-area"},
       &V::peak_open_area_angle},
      {{"peak_clearance", "m", "um", "largest clearance around the ring over the cycle", "h_max", "eq-film-2d-ring"},
       &V::peak_clearance},
      {{"peak_clearance_angle", "degree", "degree", "crank angle of the largest clearance", "varphi",
        "eq-film-2d-ring"},
       &V::peak_clearance_angle},
  };
  return table;
}

const std::vector<UnrolledField>& unrolled_fields() {
  using F = UnrolledFields;
  static const std::vector<UnrolledField> table = {
      {{"film_thickness", "m", "um", "film thickness", "h", "eq-film-thickness"}, &F::film_thickness},
      {{"film_pressure", "Pa", "bar", "film pressure, absolute", "p", "eq-film-2d-reynolds"}, &F::film_pressure},
      {{"film_content", "1", "1", "liquid share of the film", "theta", "eq-film-content"}, &F::film_content},
      {{"asperity_pressure", "Pa", "bar", "asperity contact pressure", "p_a", "eq-asperity-load"},
       &F::asperity_pressure},
  };
  return table;
}

const std::vector<UnrolledField>& strip_fields() {
  using F = UnrolledFields;
  static const std::vector<UnrolledField> table = {
      {{"strip_hydrodynamic_load", "N/m", "N/mm", "load carried by the film, per length of ring", "w_h",
        "eq-hydrodynamic-load"},
       &F::strip_hydrodynamic_load},
      {{"strip_asperity_load", "N/m", "N/mm", "load carried by asperities, per length of ring", "w_a",
        "eq-asperity-load"},
       &F::strip_asperity_load},
      {{"strip_peak_film_pressure", "Pa", "bar", "peak film pressure across the face, absolute", "p_max",
        "eq-film-2d-reynolds"},
       &F::strip_peak_film_pressure},
      {{"strip_cavitated_fraction", "1", "%", "cavitated share of the face", "", "eq-complementarity"},
       &F::strip_cavitated_fraction},
      {{"strip_min_film_thickness", "m", "um", "minimum film thickness across the face", "h_m", "eq-film-thickness"},
       &F::strip_min_film_thickness},
      {{"strip_total_friction", "N/m", "N/mm", "total friction per length of ring", "f_t", "eq-total-friction"},
       &F::strip_total_friction},
      {{"strip_oil_flow_middle", "kg/(m s)", "mg/(m s)",
        "oil flow at the middle section, positive to the crankcase, per length of ring", "q(b/2)", "eq-mass-flow"},
       &F::strip_oil_flow_middle},
      {{"strip_lifted_off", "1", "1", "1 where the ring is lifted off, else 0", "", "eq-film-2d-open-area"},
       &F::strip_lifted_off},
      {{"strip_bore_deviation", "m", "um", "radius of the bore over that of the round one", "Delta", "eq-closure-bore"},
       &F::strip_bore_deviation},
  };
  return table;
}

}  // namespace ringfilm::cycle
