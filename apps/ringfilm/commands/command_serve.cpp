#include <iostream>
#include <string>

#include "command_options.hpp"
#include "commands/commands.hpp"
#include "inverse/case_server.hpp"

namespace ringfilm::app {
namespace {

struct ServeRequest {
  std::string base;
  bool stdio = false;
};

constexpr const char* kServeFooter = R"(Example:
  echo '{"set": {"operating.speed": "3000 rpm"}}' | ringfilm serve --stdio case.toml

One request a line, as JSON: "set" (keys of the case with their values), "case" (another file) or "toml" (a case as
text), "quantities" and "curves" (names; all values and no curve without them), "id" (comes back). One line of JSON for
each: "values" in SI, or "errors". docs/manual/serve.md describes both.
)";

void declare_serve(CommandOptions& add, ServeRequest& request) {
  add.text("CASE.toml", request.base, "", "case of requests that name none");
  const CLI::Option* stdio =
      add.flag("--stdio", request.stdio, "requests from standard input, answers to standard output");
  add.require(stdio, "ringfilm serve has one way to take requests", "add --stdio");
}

void serve(const ServeRequest& request) {
  CaseServer server(request.base);
  for (std::string line; std::getline(std::cin, line);) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    std::cout << server.answer(line) << std::endl;  // each at once: the other side waits for it
    if (!std::cout) return;
  }
}

}  // namespace

void add_serve_command(Program& program) {
  program.add("serve", "Compute cases that come line by line as JSON", kServeFooter, declare_serve, serve);
}

}  // namespace ringfilm::app
