#include "tables.hpp"

#include <cmath>
#include <cstdio>

#include "markdown.hpp"
#include "ringfilm/film/kernels/kernels.hpp"

namespace ringfilm::benchmarks {
namespace {

using cycle::Cavitation;
using Cells = std::vector<std::string>;
constexpr auto kReynolds = Cavitation::kReynoldsExit, kFilmContent = Cavitation::kMassConserving;

class Printer {
 public:
  Printer(const Figures& figures, const Extent& extent)
      : figures_(figures), extent_(extent), threads_(std::to_string(extent.threads) + " threads") {}

  void times() const {
    const Cells methods = {"point-relaxation", "coupled-newton", "batched", "batched-all-threads"};
    MarkdownTable table({"model", "cells", "point relaxation", "coupled Newton", "batched", "batched, " + threads_,
                         "cycles/s, core", "set up"});
    for (const auto model : {kReynolds, kFilmContent}) {
      for (const int cells : kCells) {
        Cells values;
        for (const auto& method : methods) values.push_back(text("%.3f", Value(1e3) * time(method, model, cells)));
        values.push_back(text("%.0f", Value(1) / time("batched", model, cells)));
        values.push_back(text("%.3f", of("batched", model, cells, "making_ready_ms")));
        table.row({name_of(model), std::to_string(cells)}, values);
      }
      Cells growth;
      for (const auto& method : methods) growth.push_back(text("N^%.2f", exponent(method, model)));
      growth.insert(growth.end(), 2, text("", std::nullopt));
      table.row({name_of(model), "growth"}, growth);
    }
    table.print("Processor time of an integrated cycle [ms]; set up: of a scenario before it is integrated [ms]");
  }

  void ratios() const {
    MarkdownTable table({"cells", "coupled RE : yardstick", "batched RE : yardstick", "batched MC : yardstick",
                         "batched : coupled, RE", "batched : coupled, MC", threads_ + " : 1, RE",
                         threads_ + " : 1, MC"});
    for (const int cells : kCells) {
      const auto faster = [&](const char* than, Cavitation than_model, const char* what, Cavitation model) {
        return time(than, than_model, cells) / time(what, model, cells);
      };
      table.row({std::to_string(cells)},
                {text("%.0f", faster("point-relaxation", kReynolds, "coupled-newton", kReynolds)),
                 text("%.0f", faster("point-relaxation", kReynolds, "batched", kReynolds)),
                 text("%.0f", faster("point-relaxation", kReynolds, "batched", kFilmContent)),
                 text("%.2f", faster("coupled-newton", kReynolds, "batched", kReynolds)),
                 text("%.2f", faster("coupled-newton", kFilmContent, "batched", kFilmContent)),
                 text("%.2f", faster("batched", kReynolds, "batched-all-threads", kReynolds)),
                 text("%.2f", faster("batched", kFilmContent, "batched-all-threads", kFilmContent))});
    }
    table.print(
        "Times as fast (yardstick: point relaxation; RE: reynolds-exit, as the yardstick; MC: mass-conserving)");
  }

  void effort() const {
    MarkdownTable table({"model", "cells", "best factor", "sweeps/step", "failed", "coupled: iter./step",
                         "batched: iter./step", "lanes occupied", "found alone", "stopped", "cycles/scenario"});
    for (const auto model : {kReynolds, kFilmContent}) {
      for (const int cells : kCells) {
        const auto reported = [&](const char* format, const char* what, const char* counter) {
          return text(format, of(what, model, cells, counter));
        };
        table.row(
            {name_of(model), std::to_string(cells)},
            {reported("%.4g", "point-relaxation", "factor"), reported("%.0f", "point-relaxation", "effort_per_step"),
             reported("%.0f", "point-relaxation", "failed_steps"),
             reported("%.3f", "coupled-newton", "iterations_per_step"),
             reported("%.3f", "batched", "iterations_per_step"),
             text("%.1f %%", Value(100) * of("batched", model, cells, "occupation")),
             reported("%.0f", "batched", "single_solves"), reported("%.0f", "batched", "stopped"),
             reported("%.3f", "batched", "cycles_per_scenario")});
      }
    }
    table.print("Effort (failed: steps that the method did not solve; found alone: films that a lane did not find)");
  }

  void operations() const {
    MarkdownTable table({"model", "cells", "flop/node, iteration", "flop/node, step", "sweep alone: Gflop/s", "of peak",
                         "batch, its sweeps: Gflop/s", "of peak", "batch, all: Gflop/s", "of peak"});
    for (const auto model : {kReynolds, kFilmContent}) {
      for (const int cells : kCells) {
        const Value per_iteration = of("newton-sweep", model, cells, "operations_per_node_and_iteration");
        const Value per_step = of("newton-sweep", model, cells, "operations_per_node_and_step");
        const Value nodes = cells + 1;
        const Value batch = time("batched", model, cells);
        const Value alone = Value(film::kernels().width) * per_iteration / time("newton-sweep", model, cells);
        const Value sweeps = of("batched", model, cells, "lane_sweeps_per_cycle") * nodes * per_iteration / batch;
        const Value all = sweeps + of("batched", model, cells, "steps_per_cycle") * nodes * per_step / batch;
        const auto rate = [](Value flops) { return text("%.2f", Value(1e-9) * flops); };
        const auto share = [&](Value flops, const char* beside) {
          return text("%.1f %%", Value(100) * flops / of(beside, model, cells, "peak_flops"));
        };
        table.row({name_of(model), std::to_string(cells)},
                  {text("%.1f", per_iteration), text("%.1f", per_step), rate(alone), share(alone, "newton-sweep"),
                   rate(sweeps), share(sweeps, "batched"), rate(all), share(all, "batched")});
      }
    }
    std::printf("\nFMA peak: %s Gflop/s on one thread, %s on %s\n",
                text("%.2f", Value(1e-9) / figures_.seconds("fma-peak")).c_str(),
                text("%.2f", Value(1e-9) / figures_.seconds("fma-peak-all-threads")).c_str(), threads_.c_str());
    table.print(
        "Floating-point operations (a sum, a product and a quotient are one each, everything else counts zero) against "
        "the peak\n"
        "measured right before and after; batch: of lanes at work only, over all of its time");
  }

  void memory() const {
    MarkdownTable table({"cells", "block: byte/cell", "byte/cell and lane", "scenario in flight: kB"});
    for (const int cells : kCells) {
      const Value block = of("newton-sweep", kFilmContent, cells, "block_bytes_per_cell");
      table.row({std::to_string(cells)},
                {text("%.0f", block), text("%.0f", block / Value(film::kernels().width)),
                 text("%.0f", Value(1e-3) * of("batched", kFilmContent, cells, "heap_per_scenario"))});
    }
    table.print("Memory of a block of lanes, and of a scenario on its way with its share of the block");
  }

  void sizes() const {
    MarkdownTable table({"scenarios", "ms/scenario", "lanes occupied", "peak memory of the process: MB", "stopped"});
    for (const std::size_t size : extent_.batch_sizes) {
      const std::string name = "batch-of/" + std::to_string(size);
      table.row({std::to_string(size)}, {text("%.3f", Value(1e3) * figures_.seconds(name)),
                                         text("%.1f %%", Value(100) * figures_.counter(name, "occupation")),
                                         text("%.1f", Value(1e-6) * figures_.counter(name, "peak_resident_bytes")),
                                         text("%.0f", figures_.counter(name, "stopped"))});
    }
    table.print("Scenarios in one call (mass-conserving, 200 cells; set up and integrated)");
  }

 private:
  Value time(const std::string& what, Cavitation model, int cells) const {
    return figures_.seconds(name_of(what, model, cells));
  }
  Value of(const std::string& what, Cavitation model, int cells, const std::string& counter) const {
    return figures_.counter(name_of(what, model, cells), counter);
  }
  /// Of time with the number of cells, from the fewest to the most.
  Value exponent(const std::string& what, Cavitation model) const {
    const Value ratio = time(what, model, kCells.back()) / time(what, model, kCells.front());
    if (!ratio) return std::nullopt;
    return std::log(*ratio) / std::log(static_cast<double>(kCells.back()) / kCells.front());
  }
  const Figures& figures_;
  const Extent& extent_;
  std::string threads_;
};

}  // namespace

void print_tables(const Figures& figures, const Extent& extent) {
  const Printer printer(figures, extent);
  printer.times();
  printer.ratios();
  printer.effort();
  printer.operations();
  printer.memory();
  printer.sizes();
}

}  // namespace ringfilm::benchmarks
