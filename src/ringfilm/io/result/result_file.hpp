#pragma once
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "ringfilm/base/members.hpp"
#include "ringfilm/case/case.hpp"
#include "ringfilm/cycle/contact_curves.hpp"
#include "ringfilm/cycle/pack/oil_consumption.hpp"
#include "ringfilm/cycle/result/result.hpp"
#include "ringfilm/io/case/case_entry.hpp"
#include "ringfilm/io/result/pack_gas.hpp"
#include "ringfilm/study/comparison.hpp"
#include "ringfilm/study/ensemble/error_estimate.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"

namespace ringfilm::io {

/// What computed the result.
struct Provenance {
  std::string program;   ///< "ringfilm 0.2.0"
  std::string commit;    ///< commit of the sources, "unknown" outside a checkout
  std::string compiler;  ///< name, version, build type
  std::string kernels;   ///< inner loops that found the films, and how many at once: "avx512, 1 lane"; of a run alone
};

/// The members of a provenance, as all outputs have them; what is not known is empty and omitted.
constexpr auto members(const Provenance*) {
  return std::tuple{Member{"program", "", "program and its version", &Provenance::program},
                    Member{"commit", "", "commit of its sources", &Provenance::commit},
                    Member{"compiler", "", "name, version and build type of the compiler", &Provenance::compiler},
                    Member{"kernels", "", "inner loops, and how many films at once", &Provenance::kernels}};
}

Provenance this_program();  ///< provenance of this build

/// The provenance of a run of this program that integrates by itself, in one lane.
Provenance this_run();

/// All that a result file holds; a report can be drawn again from it alone.
struct ResultDocument {
  std::string title;                             ///< Case::title
  std::vector<CaseEntry> inputs;                 ///< the active keys with the values in use, in table order
  std::string resolved_case;                     ///< a complete case file in SI that gives the same bits again
  std::vector<cycle::InputFile> files;           ///< everything that was read, with its digest
  std::vector<std::string> input_notes;          ///< Case::notes
  Provenance provenance;                         ///< what computed it
  cycle::CycleResult result;                     ///< up to the last good angle where the integration stopped
  std::vector<study::LedgerEntry> ledger;        ///< what the case takes for granted
  bool ledger_computed = false;                  ///< were the variants run?
  std::vector<study::ComparisonRow> comparison;  ///< with published values; empty where there are none
  std::optional<study::ErrorEstimate> errors;    ///< absent where they were not asked for
  cycle::ContactCurves contact;                  ///< contact law of the case and others of its surfaces
  /// Result of each ring of a ring pack, from the chamber down; `result` then has the friction of all rings
  /// (cycle::summed_quantities) and whether all are complete. Empty: a case of one ring.
  std::vector<ResultDocument> rings;
  /// Oil consumption by its parts and their sums, of a pack or of a case of one ring; empty where it is not computed.
  std::vector<cycle::OilLoss> oil_losses;
  std::optional<PackGas> gas;  ///< gas of a pack whose gas path is computed
  long rail = 0;               ///< number of the rail in an oil ring of several rails, from 1; 0: a ring as a whole

  bool is_pack() const { return !rings.empty(); }  ///< is it the result of a ring pack?
};

/// Writes NetCDF-4 with named dimensions crank_angle, x, ...; aside first, flushed, then renamed, so that a kill or a
/// full disk leaves the previous file unchanged. Same document, same bytes. Throws OutputError.
void write_result(const std::string& path, const ResultDocument& document);

/// Throws InputError if the file cannot be read, does not have the digest at its end (digest_trailer.hpp), or is not
/// one of ours (another program's NetCDF, newer schema, truncated).
ResultDocument read_result(const std::string& path);

/// The bytes of a file of results. Throws InputError: missing, a folder, a device.
std::string read_netcdf_bytes(const std::string& path);

/// The bytes that write_result writes, for who sends a result elsewhere. Throws OutputError.
std::string result_bytes(const ResultDocument& document);

/// The result that those bytes hold. @param name where they come from, for messages. Throws InputError as read_result.
ResultDocument result_of_bytes(const std::string& name, const std::string& bytes);

}  // namespace ringfilm::io
