#pragma once
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ringfilm/io/case/case_file.hpp"

/// The commands of the program: arguments in, text and files out. Each has its options and what it does with them in
/// one file; it returns normally or throws one of the errors of ringfilm/base/error.hpp, which main turns into exit
/// codes.
namespace ringfilm::app {

class Program;

// Each adds a command with its options, or several.
void add_check_command(Program& program);
void add_cite_command(Program& program);
void add_completion_command(Program& program);
void add_conform_command(Program& program);
void add_contact_command(Program& program);
void add_data_commands(Program& program);  ///< fields, oils, pairs
void add_face_command(Program& program);
void add_fit_command(Program& program);
void add_gas_command(Program& program);
void add_land_command(Program& program);
void add_lateral_force_command(Program& program);
void add_life_command(Program& program);
void add_new_command(Program& program);
void add_optimise_command(Program& program);
void add_report_command(Program& program);
void add_reproduce_command(Program& program);
void add_run_command(Program& program);
void add_serve_command(Program& program);
void add_study_command(Program& program);
void add_sweep_command(Program& program);
void add_surface_commands(Program& program);  ///< surface, pair
void add_synthetic_command(Program& program);
void add_verify_command(Program& program);

enum class SummaryForm { kTable, kJson, kNothing };

/// Prints on standard error which keys of a case --set makes unused.
void print_dropped(const std::vector<io::DroppedKey>& dropped);

/// The case of a command with what it states on the command line; prints the keys that this makes unused.
cycle::Case case_with_settings(const std::string& path, const std::vector<io::Override>& settings,
                               cycle::CasePurpose purpose = cycle::CasePurpose::kFilm);

/// A case and what the command line states in place of it.
struct CaseOptions {
  std::string case_path;
  std::vector<io::Override> overrides;
  SummaryForm summary = SummaryForm::kTable;
};
struct CaseWithOutputs : CaseOptions {
  std::optional<std::string> output;  ///< NetCDF
  std::optional<std::string> csv;
};

/// Are the maps pressed against each other, and their film computed with each contact law?
enum class FrictionBands { kNone, kComputed };

struct ReproduceOptions {
  std::string publication;
  std::string folder;
  FrictionBands bands = FrictionBands::kNone;  ///< friction bands of the publication "measured"
  int jobs = 0;                                ///< threads; 0: as many as the machine runs at once
};

/// Reproduces rings from the synthetic instrument files of cases/measured/: surfaces, faces and friction loops are
/// measured as by the single commands, the results become cases, and these are run.
void reproduce_measured(const ReproduceOptions& options);

/// Everything was computed and written, but something in it is not as it should be (exit code 4).
class FailedChecks : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace ringfilm::app
