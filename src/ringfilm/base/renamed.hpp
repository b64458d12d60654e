#pragma once
#include <array>
#include <string_view>

/// Names of earlier versions that case files, commands or results no longer use.
namespace ringfilm {

struct RenamedName {
  std::string_view kind;             ///< key, choice, command, option, json, csv or netcdf
  std::string_view before;           ///< name in earlier versions
  std::string_view now;              ///< present name
  std::string_view since = "0.2.0";  ///< version that renamed it
};

/// docs/renamed.csv is this table; a test compares the two.
inline constexpr std::array kRenamedNames = std::to_array<RenamedName>({
    {"key", "ring.face.measured.invented_shape", "ring.face.measured.fit_artifact"},
    {"key", "contact.film_parameter", "contact.lambda_ratio"},
    {"choice", "nested-secant", "coupled-newton"},
    {"json", "effort.cycles_marched", "effort.cycles_integrated"},
    {"json", "film_parameter", "lambda_ratio"},
    {"json", "film_parameter_at_peak_pressure", "lambda_ratio_at_peak_pressure"},
    {"json", "min_film_parameter", "min_lambda_ratio"},
    {"json", "mean_film_parameter", "mean_lambda_ratio"},
    {"json", "wear_drive", "archard_wear_load_rate"},
    {"json", "wear_drive_energy", "archard_wear_load"},
    {"csv", "film_parameter", "lambda_ratio"},
    {"csv", "wear_drive", "archard_wear_load_rate"},
    {"csv", "fill", "film_content"},
    {"netcdf", "effort_cycles_marched", "effort_cycles_integrated"},
    {"netcdf", "film_parameter", "lambda_ratio"},
    {"netcdf", "local_film_parameter", "local_lambda_ratio"},
    {"netcdf", "film_parameter_at_peak_pressure", "lambda_ratio_at_peak_pressure"},
    {"netcdf", "min_film_parameter", "min_lambda_ratio"},
    {"netcdf", "mean_film_parameter", "mean_lambda_ratio"},
    {"netcdf", "fill", "film_content"},
    {"netcdf", "unrolled_fill", "unrolled_film_content"},
    {"netcdf", "wear_drive", "archard_wear_load_rate"},
    {"netcdf", "wear_drive_energy", "archard_wear_load"},
    {"netcdf", "wear_drive_density", "archard_wear_load_density"},
    {"option", "--land-height", "--running-surface-height"},
    {"option", "--levelling land", "--levelling running-surface"},
    {"json", "tilt_half_land", "tilt_half_running_surface"},
    {"json", "tilt_double_land", "tilt_double_running_surface"},
    {"json", "land_from", "running_surface_from"},
    {"json", "land_to", "running_surface_to"},
    {"json", "land_width", "running_surface_width"},
    {"json", "tabor_product", "roughness_parameter"},
    {"json", "bearing_curve", "material_ratio_curve"},
    {"netcdf", "tilt_half_land", "tilt_half_running_surface"},
    {"netcdf", "tilt_double_land", "tilt_double_running_surface"},
    {"netcdf", "land_from", "running_surface_from"},
    {"netcdf", "land_to", "running_surface_to"},
    {"netcdf", "land_width", "running_surface_width"},
    {"netcdf", "tabor_product", "roughness_parameter"},
    {"netcdf", "bearing_height", "material_ratio_height"},
    {"netcdf", "bearing_curve_mark_place", "material_ratio_curve_mark_place"},
    {"netcdf", "bearing_curve_mark_label", "material_ratio_curve_mark_label"},
    {"json", "standing", "state_origin"},
    {"json", "wear.standing", "wear.coefficient_origin"},
    {"netcdf", "standing", "state_origin"},
    {"json", "mixed_share", "mixed_regime_cycle_share"},
    {"csv", "mixed_share", "mixed_regime_cycle_share"},
    {"netcdf", "mixed_share", "mixed_regime_cycle_share"},
});

/// The present name of `before`; empty where no name of an earlier version is meant.
std::string_view present_name(std::string_view before);

}  // namespace ringfilm
