#pragma once
#include <string>
#include <vector>

#include "command_options.hpp"
#include "ringfilm/run/inverse/run_inverse.hpp"
#include "stop_request.hpp"

namespace ringfilm::app {

/// The options of fits and optimisations.
struct InverseRequest {
  std::string path;    ///< file of the fit or the optimisation
  std::string output;  ///< folder
  int threads = 0;
  bool json = false;
  bool resume = false, overwrite = false;
};

/// Words of their help.
struct InverseWords {
  const char* file;     ///< name of the file that the command reads, "FIT.toml"
  const char* meaning;  ///< what that file is
  const char* output;   ///< meaning of the folder
  const char* printed;  ///< meaning of --json
};
/// The options of both commands.
void declare_inverse(CommandOptions& add, InverseRequest& request, const InverseWords& words);

/// Makes the folder of the output and, to overwrite, removes the points in it. Throws OutputError.
/// @returns the file of the points
std::string prepared_store(const InverseRequest& request);

/// How they are computed: a request to stop ends them.
run::InverseOptions inverse_options(const InverseRequest& request, const StopRequest& stop);

/// A file in the folder.
std::string in_folder(const std::string& folder, const std::string& name);

/// Numbers of a table in columns that are as wide as need be, the first on the left.
std::string aligned_table(const std::vector<std::vector<std::string>>& rows);

}  // namespace ringfilm::app
