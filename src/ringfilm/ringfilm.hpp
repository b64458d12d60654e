#pragma once
/// All that is public of the library, from the case file to the page. What these headers include is installed too, but
/// its names may change from one version to the next. docs/manual/library.md shows how to use them.

// Errors that every call may throw: InputError, ConvergenceError, OutputError.
#include "ringfilm/base/error.hpp"

// Measured surfaces, ring faces, friction loops: numbers in, numbers out.
#include "ringfilm/surface/asperity/asperities.hpp"
#include "ringfilm/surface/asperity/scatter.hpp"
#include "ringfilm/surface/asperity/spectral_moments.hpp"
#include "ringfilm/surface/face/face_fit.hpp"
#include "ringfilm/surface/friction_loop/lateral_force.hpp"
#include "ringfilm/surface/synthetic/synthetic.hpp"
#include "ringfilm/surface/topography/material_ratio.hpp"
#include "ringfilm/surface/topography/preparation.hpp"
#include "ringfilm/surface/topography/roughness.hpp"
#include "ringfilm/surface/topography/topography.hpp"

// Laws: oil, contact, crank, gas, ring.
#include "ringfilm/models/conformity/free_shape.hpp"
#include "ringfilm/models/conformity/ring_closure.hpp"
#include "ringfilm/models/contact/asperity_contact.hpp"
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas/gas.hpp"
#include "ringfilm/models/oil/lubricant.hpp"
#include "ringfilm/models/oil/oil_of_functions.hpp"
#include "ringfilm/models/ring.hpp"

// A case, whatever its problem: run::run_case. Below it the parts that it is made of, lives, batches, studies.
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/closure/static_closure.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/pack/simulate_pack.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/gas_path/solve_gas_path.hpp"
#include "ringfilm/life/life.hpp"
#include "ringfilm/life/life_run.hpp"
#include "ringfilm/pad/solve_pad.hpp"
#include "ringfilm/run/run.hpp"
#include "ringfilm/study/ensemble/batch.hpp"
#include "ringfilm/study/ensemble/cycle_integrators.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"
#include "ringfilm/study/study_run.hpp"

// Files: cases and results.
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/gas_path/gas_path_output.hpp"
#include "ringfilm/io/life/life_file.hpp"
#include "ringfilm/io/life/life_output.hpp"
#include "ringfilm/io/pad/pad_netcdf.hpp"
#include "ringfilm/io/pad/pad_output.hpp"
#include "ringfilm/io/result/result_csv.hpp"
#include "ringfilm/io/result/result_document.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/result/result_json.hpp"
#include "ringfilm/io/study/study_file.hpp"
#include "ringfilm/io/study/study_result.hpp"
#include "ringfilm/io/text/units.hpp"

// Instrument files, and the page.
#include "ringfilm/instrument/documents/surface_measurement.hpp"
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/report/html.hpp"
