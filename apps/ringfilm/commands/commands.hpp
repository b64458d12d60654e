#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/result/vts_file.hpp"
#include "ringfilm/run/run.hpp"

/// The commands of the program: arguments in, text and files out. Each returns normally or throws one of the errors of
/// ringfilm/base/error.hpp; main turns those into exit codes.
namespace ringfilm::app {

enum class SummaryForm { kTable, kJson, kNothing };

/// The case of a command with what it states on the command line; prints on standard error which keys of the case that
/// makes unused.
cycle::Case case_with_settings(const std::string& path, const std::vector<io::Override>& settings,
                               cycle::CasePurpose purpose = cycle::CasePurpose::kFilm);

struct RunOptions {
  std::string case_path;
  std::vector<io::Override> overrides;
  std::optional<std::string> output;  ///< NetCDF
  std::optional<std::string> csv;
  SummaryForm summary = SummaryForm::kTable;
  run::Options computed;
};
void run(const RunOptions& options);

struct CheckOptions {
  std::string case_path;
  std::vector<io::Override> overrides;
  SummaryForm summary = SummaryForm::kTable;
};
void check(const CheckOptions& options);

struct ReportOptions {
  std::vector<std::string> results;
  std::vector<std::string> overlays;
  std::optional<std::string> output;      ///< web page
  std::optional<std::string> vts_folder;  ///< of the fields around the ring for ParaView
  std::optional<io::VtsShape> vts_shape;
};
void report(const ReportOptions& options);

/// Are the maps pressed against each other, and their film computed with each contact law?
enum class FrictionBands { kNone, kComputed };

struct ReproduceOptions {
  std::string publication;
  std::string folder;
  FrictionBands bands = FrictionBands::kNone;  ///< of "measured"
  int jobs = 0;                                ///< threads; 0: as many as the machine runs at once
};
void reproduce(const ReproduceOptions& options);

/// The same rings from the synthetic instrument files of cases/measured/: surfaces, faces and friction loops are
/// measured as by the single commands, what they give becomes cases, and these are run.
void reproduce_measured(const ReproduceOptions& options);

enum class VerifyRequest { kTable, kJson, kNames };

struct VerifyOptions {
  std::vector<std::string> names;     ///< folders of verification/; empty: all
  std::optional<std::string> output;  ///< web page
  VerifyRequest requested = VerifyRequest::kTable;
};

/// Everything was computed and written, but something in it is not as it should be (exit code 4).
class FailedChecks : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Runs the shipped cases with known answers. Throws FailedChecks.
void verify(const VerifyOptions& options);

struct FieldsOptions {
  std::vector<std::string> words;  ///< sections, keys or parts of keys; empty: all keys
};
/// Prints the table of case keys.
void fields(const FieldsOptions& options);

/// Of `oils` and `pairs`.
struct OilsOptions {
  SummaryForm summary = SummaryForm::kTable;
};
/// Prints the shipped oils.
void oils(const OilsOptions& options);

/// Prints the shipped pairs of coating and liner with their boundary friction.
void pairs(const OilsOptions& options);

struct NewOptions {
  std::string path;
  std::optional<std::string> engine;  ///< one of io::start_engines(); the first of them if absent
  std::optional<std::string> trace;   ///< file of the cylinder pressure
};
/// Writes a commented case to start from; refuses to replace a file.
void start_case(const NewOptions& options);

}  // namespace ringfilm::app
