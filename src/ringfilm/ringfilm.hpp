#pragma once
/// All that is public of the library, from the case file to the page. What these headers include is installed too, but
/// its names may change from one version to the next. docs/manual/library.md shows how to use them.

// Errors that every call may throw: InputError, ConvergenceError, OutputError.
#include "ringfilm/base/error.hpp"

// Measured surfaces, ring faces, friction loops: numbers in, numbers out.
#include "ringfilm/surface/asperities.hpp"
#include "ringfilm/surface/bearing.hpp"
#include "ringfilm/surface/face_fit.hpp"
#include "ringfilm/surface/lateral_force.hpp"
#include "ringfilm/surface/preparation.hpp"
#include "ringfilm/surface/roughness.hpp"
#include "ringfilm/surface/scatter.hpp"
#include "ringfilm/surface/spectral_moments.hpp"
#include "ringfilm/surface/synthetic.hpp"
#include "ringfilm/surface/topography.hpp"

// Laws: oil, contact, crank, gas, ring.
#include "ringfilm/models/asperity_contact.hpp"
#include "ringfilm/models/crank_slider.hpp"
#include "ringfilm/models/gas.hpp"
#include "ringfilm/models/lubricant.hpp"
#include "ringfilm/models/oil_of_functions.hpp"
#include "ringfilm/models/ring.hpp"

// One cycle, a pad, many cycles, studies.
#include "ringfilm/cycle/case.hpp"
#include "ringfilm/cycle/result.hpp"
#include "ringfilm/cycle/setup.hpp"
#include "ringfilm/cycle/simulate.hpp"
#include "ringfilm/pad/solve_pad.hpp"
#include "ringfilm/study/batch.hpp"
#include "ringfilm/study/error_estimate.hpp"
#include "ringfilm/study/ledger.hpp"
#include "ringfilm/study/study_run.hpp"

// Files: cases and results.
#include "ringfilm/io/case_file.hpp"
#include "ringfilm/io/pad_netcdf.hpp"
#include "ringfilm/io/pad_output.hpp"
#include "ringfilm/io/result_csv.hpp"
#include "ringfilm/io/result_document.hpp"
#include "ringfilm/io/result_file.hpp"
#include "ringfilm/io/result_json.hpp"
#include "ringfilm/io/study_file.hpp"
#include "ringfilm/io/study_result.hpp"
#include "ringfilm/io/units.hpp"

// Instrument files, and the page.
#include "ringfilm/instrument/surface_file.hpp"
#include "ringfilm/instrument/surface_measurement.hpp"
#include "ringfilm/report/html.hpp"
