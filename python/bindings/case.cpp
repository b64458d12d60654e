#include <algorithm>
#include <functional>

#include "arguments.hpp"
#include "case_object.hpp"
#include "case_values.hpp"
#include "members.hpp"
#include "result_object.hpp"
#include "ringfilm/base/error.hpp"
#include "ringfilm/case/keys/case_fields.hpp"
#include "ringfilm/cycle/advice/advice.hpp"
#include "ringfilm/cycle/pack/gas_of_pack.hpp"
#include "ringfilm/cycle/pack/rails_of_pack.hpp"
#include "ringfilm/cycle/setup/setup.hpp"
#include "ringfilm/io/case/case_edit.hpp"
#include "ringfilm/io/case/case_file.hpp"
#include "ringfilm/io/case/case_text.hpp"
#include "ringfilm/io/case/case_value_text.hpp"
#include "ringfilm/io/data/trace_file.hpp"
#include "ringfilm/io/result/input_members.hpp"
#include "ringfilm/io/result/result_file.hpp"
#include "ringfilm/io/start/start_case.hpp"
#include "ringfilm/io/text/suggestion.hpp"
#include "ringfilm/pad/pad_setup.hpp"
#include "ringfilm/run/inverse/gradients.hpp"
#include "ringfilm/study/design/scenario.hpp"
#include "ringfilm/study/ensemble/ledger.hpp"
#include "run.hpp"

namespace ringfilm::python {
namespace {

using cycle::Case;
using cycle::Field;
using io::known_field;

constexpr const char* kKeyExample = "engine.bore";

std::string key_of(const GivenText& given) { return text_of("key", given.value, kKeyExample); }

/// @param name of a key in messages
/// The field of a key, of one ring of a pack as well.
const Field& field_of(const std::string& key) {
  const auto of_ring = cycle::ring_key(key);
  return known_field(of_ring ? of_ring->key : key);
}

std::vector<io::Change> changes_of(const char* name, const py::dict& values) {
  std::vector<io::Change> changes;
  std::vector<Fault> faults;
  for (const auto& [given, value] : values) {
    const std::string key = text_of(name, given, kKeyExample);
    const Field& field = field_of(key);
    try {
      changes.push_back({key, toml_value(value, field)});
    } catch (const InputError& refusal) {
      faults.insert(faults.end(), refusal.faults().begin(), refusal.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(std::move(faults));
  return changes;
}

CaseObject read_case(const py::object& path, const std::optional<py::dict>& overrides) {
  const auto name = path_of("path", path);
  auto units = std::make_shared<const io::Units>();
  if (!overrides || overrides->empty()) return {io::read_case(name, {}, *units), units};
  // As --set has them, so that what is missing in the file may be among them.
  std::vector<io::Override> stated;
  for (const auto& [key, value] : changes_of("a key of overrides", *overrides))
    stated.push_back({key, value ? written(*value) : ""});
  std::vector<io::DroppedKey> dropped;
  CaseObject read{io::read_case_dropping(name, stated, *units, dropped), units};
  const std::string text = "overrides make keys of the case unused, they are dropped: " + io::listed(dropped);
  if (!dropped.empty() && PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
  return read;
}

/// Those of a ring pack: of the engine, then of each ring.
std::vector<std::string> keys_in_use(const CaseObject& self) {
  std::vector<std::string> keys;
  const Case& c = self.value();
  const std::size_t n_rings = c.rings.size();
  for (std::size_t ring = 0; ring <= n_rings; ++ring) {
    const Case& of = n_rings == 0 ? c : c.rings[ring == 0 ? 0 : ring - 1];
    for (const Field& field : cycle::case_fields()) {
      const bool is_listed = n_rings == 0 || cycle::is_of_ring(field.key) == (ring > 0);
      const bool is_implied = cycle::is_implied_in_pack(ring, field.key);
      if (!is_listed || is_implied || !cycle::belongs(field, of) || !cycle::is_active(field, of)) continue;
      keys.push_back(ring > 0 ? cycle::pack_key(ring, field.key) : field.key);
    }
  }
  return keys;
}

std::vector<std::string> check(CaseObject& self) {
  self.check();
  const Case& c = self.value();
  std::vector<std::string> notes = c.notes;
  if (c.problem == cycle::Problem::kPad) {
    pad::prepare_pad(c);
  } else {
    const Case with_gas = cycle::with_gas_path(cycle::with_rails(c));
    for (const Case& one : c.is_pack() ? with_gas.rings : std::vector<Case>{with_gas}) {
      for (const cycle::Note& note : cycle::advice(cycle::prepare(one))) notes.push_back(note.message);
    }
  }
  return notes;
}

std::string key_text(const CaseObject& self, const std::string& key) {
  const auto [field, of] = io::located_key(self.value(), key);
  return is_missing(field, of) ? "" : io::written_value(field, of, self.units());
}

py::dict assumed(const CaseObject& self) {
  py::dict assumed;
  for (const std::string& key : keys_in_use(self)) {
    if (self.value().stated.contains(key)) continue;
    const std::string text = key_text(self, key);
    if (!text.empty()) assumed[py::str(key)] = text;
  }
  return assumed;
}

std::vector<std::string> assumptions(CaseObject& self) {
  self.check();
  std::vector<std::string> statements;
  const Case c = cycle::with_gas_path(cycle::with_rails(self.value()));
  for (const study::LedgerEntry& entry : study::assumptions(c.is_pack() ? c.rings.front() : c)) {
    statements.push_back(entry.statement);
  }
  return statements;
}

std::string case_words(const CaseObject& self) {
  const Case& c = self.value();
  std::string text = c.problem == cycle::Problem::kPad ? "<ringfilm.Case of a pad"
                     : c.is_pack() ? "<ringfilm.Case of " + std::to_string(c.rings.size()) + " rings"
                                   : "<ringfilm.Case";
  if (!c.title.empty()) text += " \"" + c.title + "\"";
  if (!c.files.empty()) text += " from " + c.files.front().path;
  return text + ": " + std::to_string(c.stated.size()) + " keys stated>";
}

constexpr int kCaseStateVersion = 3;

/// The samples that files gave, in the order of a pickle; those that copies of a case share are next to it.
auto samples(Case& c, cycle::SampledTrace& cylinder, cycle::OilTable& oil) {
  return std::tie(cylinder.crank_angle_deg, cylinder.value, c.ring.face.x, c.ring.face.height, oil.temperature,
                  oil.pressure, oil.viscosity, oil.density, c.pad.gap_x, c.pad.gap_y, c.pad.gap_height,
                  c.pad.history_time, c.pad.history_separation);
}

py::tuple case_state(const CaseObject& self) {
  Case c = self.value();
  if (c.is_pack()) {
    py::list rings;
    for (const Case& ring : c.rings) rings.append(case_state(CaseObject(ring)));
    return py::make_tuple(kCaseStateVersion, rings);
  }
  py::dict values;
  for (const Field& field : cycle::case_fields()) {
    if (cycle::belongs(field, c)) values[py::str(field.key)] = stored_value(field, c);
  }
  py::list arrays;
  cycle::SampledTrace cylinder = *c.gas.cylinder_pressure;
  cycle::OilTable oil = *c.lubricant.table;
  std::apply([&](auto&... each) { (arrays.append(array_of(each)), ...); }, samples(c, cylinder, oil));
  py::object crankcase = py::none();
  if (c.gas.crankcase_trace) {
    const cycle::SampledTrace& trace = **c.gas.crankcase_trace;
    crankcase = py::make_tuple(array_of(trace.crank_angle_deg), array_of(trace.value));
  }
  return py::make_tuple(kCaseStateVersion, static_cast<int>(c.problem), values, arrays, crankcase,
                        members_list(c.files), std::vector<std::string>(c.stated.begin(), c.stated.end()), c.notes);
}

CaseObject from_state(const py::tuple& state) {
  if (state.size() == 2 && py::cast<int>(state[0]) == kCaseStateVersion) {
    std::vector<Case> rings;
    for (const py::handle ring : state[1]) rings.push_back(from_state(py::cast<py::tuple>(ring)).value());
    return CaseObject(io::ring_pack(std::move(rings)));
  }
  if (state.size() != 8 || py::cast<int>(state[0]) != kCaseStateVersion)
    throw py::value_error("this is a pickle of a case of another version of ringfilm");
  Case c = cycle::blank_case(static_cast<cycle::Problem>(py::cast<int>(state[1])));
  for (const auto& [key, value] : py::cast<py::dict>(state[2]))
    restore_value(known_field(py::cast<std::string>(key)), value, c);
  const auto arrays = py::cast<py::list>(state[3]);
  std::size_t i = 0;
  cycle::SampledTrace cylinder;
  cycle::OilTable oil;
  std::apply([&](auto&... each) { ((each = pickled_row(arrays[i++])), ...); }, samples(c, cylinder, oil));
  c.gas.cylinder_pressure = std::move(cylinder);
  c.lubricant.table = std::move(oil);
  if (!state[4].is_none()) {
    const auto trace = py::cast<py::tuple>(state[4]);
    c.gas.crankcase_trace = cycle::SampledTrace{pickled_row(trace[0]), pickled_row(trace[1])};
  }
  c.files = records_of<cycle::InputFile>(state[5]);
  const auto stated = py::cast<std::vector<std::string>>(state[6]);
  c.stated = {stated.begin(), stated.end()};
  c.notes = py::cast<std::vector<std::string>>(state[7]);
  return CaseObject(std::move(c));
}

constexpr const char* kCaseDoc =
    R"(The input of one engine cycle or of one pad, as a table of keys (docs/manual/case-file.md, ringfilm.fields()).

Read one with Case.read, then read and change it key by key: case["operating.speed"] is a number in SI, and
case["operating.speed"] = "2000 rpm" or = ringfilm.SI(209.4) states another one; 209.4 alone has no unit and is refused.
None, or del, takes a key out; update() changes keys that only fit together. A value out of its range is refused at once
with InputError; what joins several keys is looked at by check() and run().
Cases can be copied, compared and pickled; a pickle holds the numbers of all files that were read.)";

}  // namespace

namespace {

/// What changes one key; a refusal that another key can lift names the way to change both.
void change_alone(const std::function<void()>& change) {
  try {
    change();
  } catch (const io::TraceKeyError& refusal) {
    std::vector<Fault> faults = refusal.faults();
    std::string& remedy = faults.back().remedy;
    remedy += (remedy.empty() ? "" : "; ") + std::string("keys that only fit together are changed by one update()");
    throw InputError(std::move(faults));
  }
}

/// A function of what notebooks show.
py::object in_notebook(const char* function) { return plain_layer("ringfilm._notebook", function); }

}  // namespace

void CaseObject::set(const std::string& key, const py::handle& value) {
  const std::optional<io::TomlValue> stated = toml_value(value, field_of(key));
  if (!stated) return remove(key);
  is_checked_ = false;
  change_alone([&] { io::state(value_, key, *stated, units()); });
}

void CaseObject::remove(const std::string& key) {
  io::located_key(value_, key);
  is_checked_ = false;
  change_alone([&] { io::retract(value_, key, units()); });
}

void CaseObject::update(const py::dict& values) {
  const std::vector<io::Change> changes = changes_of("a key of update", values);
  is_checked_ = false;
  io::update(value_, changes, units());
}

void CaseObject::check() {
  if (!is_checked_) io::check_case(value_);
  is_checked_ = true;
}

void bind_case(py::module_& module) {
  py::class_<CaseObject> type(module, "Case", kCaseDoc);
  type.def(py::init([](const py::dict& values) { return in_notebook("case_of")(values).cast<CaseObject>(); }),
           py::arg("values"),
           R"(A case of {key: value}, as update() takes them; files relative to the working folder.
Raises InputError with everything that is wrong.)");
  type.def_static("read", &read_case, py::arg("path"), py::arg("overrides") = py::none(),
                  R"(A case from a TOML file, with all files that it names.

path: name of the file, a str or a path.
overrides: {key: value}, as --set of the program, values as for case[key] = value; None takes a key out.
A key of the file that they make unused is dropped, with a UserWarning.
Raises InputError with every fault of every file, as the program prints them.
Source: docs/manual/case-file.md.)");
  type.def(
      "__getitem__",
      [](const CaseObject& self, const GivenText& key) {
        const auto [field, of] = io::located_key(self.value(), key_of(key));
        return si_value(field, of);
      },
      py::arg("key"),
      R"(The value of a key: a float in SI, an int, a str, a list; of values at temperatures a list of pairs
(temperature [K], value [SI]); of crank angles [degree]; None where the case has none.
Raises UnknownKeyError, a KeyError, for a key that does not exist.)");
  type.def(
      "__setitem__",
      [](CaseObject& self, const GivenText& key, const py::object& value) { self.set(key_of(key), value); },
      py::arg("key"), py::arg("value"),
      R"(States a key: a text as in a case file ("2000 rpm"), ringfilm.SI(209.4) for a value in SI, a list or an
array of them. A bare number is accepted where it has no unit, or where its SI unit is the one that people write.
Raises UnknownKeyError for a key that does not exist, InputError for a missing or wrong unit and a value out of range;
TypeError for an object that is not a value.)");
  type.def(
      "__delitem__", [](CaseObject& self, const GivenText& key) { self.remove(key_of(key)); }, py::arg("key"),
      "Takes a key out, so that its default holds again. Raises UnknownKeyError for a key that does not exist.");
  type.def("update", &CaseObject::update, py::arg("values"),
           R"(States several keys at once, for keys that only fit together: a trace file and the name of its column.

values: {key: value}, values as for case[key] = value; None takes a key out. Files are read after all changes. Keys next
to lubricant.file are stated on top of the oil file. Where anything is refused the case stays as it was.
Raises as case[key] = value; InputError with the faults of all values.)");
  type.def(
      "__contains__",
      [](const CaseObject& self, const GivenText& key) { return self.value().stated.contains(key_of(key)); },
      py::arg("key"), "Does the case state this key?");
  type.def(
      "__iter__", [](const CaseObject& self) { return py::iter(py::cast(keys_in_use(self))); }, "Over keys().");
  type.def("keys", &keys_in_use, "The keys that are in use, stated or not, in the order of a case file.");
  type.def(
      "items",
      [](const CaseObject& self) {
        py::list items;
        for (const std::string& key : keys_in_use(self)) {
          const auto [field, of] = io::located_key(self.value(), key);
          items.append(py::make_tuple(key, si_value(field, of)));
        }
        return items;
      },
      "The keys in use with their values, a list of tuples (key, value).");
  type.def(
      "__len__", [](const CaseObject& self) { return keys_in_use(self).size(); }, "How many keys are in use.");
  type.def(
      "text", [](const CaseObject& self, const GivenText& key) { return key_text(self, key_of(key)); }, py::arg("key"),
      R"(The value of a key as a case file has it, in the unit people use: '"2000 rpm"'. Empty where there is none.
Raises UnknownKeyError, a KeyError, for a key that does not exist.)");
  type.def("assumed", &assumed, "The keys in use that the case does not state, with their values as text().");
  type.def("assumptions", &assumptions,
           "What a cycle of this case takes for granted, a sentence each. Raises InputError as check() does. Source: "
           "docs/theory/assumptions.md.");
  type.def("check", &check,
           R"(Checks the case as a whole. Returns the notes of the program on it, a list of sentences.
Raises InputError with everything that is wrong.)");
  type.def(
      "run",
      [](CaseObject& self, const py::object& progress, bool ledger, bool error_estimate, const py::object& threads) {
        return run_case(self, progress,
                        {.ledger = ledger, .error_estimate = error_estimate, .threads = threads_of(threads)});
      },
      py::arg("progress") = py::none(), py::arg("ledger") = false, py::arg("error_estimate") = false,
      py::arg("threads") = py::none(),
      R"(Computes the cycle, or the film of a pad.

progress: called now and then, at most every 20 ms, as progress(cycle, crank_angle) with the number of the cycle from 1
    and the crank angle [degree]; of a pad as progress(time, end_time) [s]. What it raises ends the run.
ledger: also run the other choice for every assumption that can be lifted; see Result.ledger. Rings only.
error_estimate: also run finer and coarser cells and crank steps (cost: docs/theory/error-estimate.md); the errors are
    next to their quantities: result["cycle_fmep_error"], result["min_film_thickness_error"]. Always done where
    solver.accuracy is stated. Rings only.
threads: for these others, 1 to 1024; None: as many as the machine runs at once. The numbers do not depend on it.
Returns a Result, of a ring pack a PackResult, of a pad a PadResult. Other threads continue meanwhile; Ctrl-C
ends the run with KeyboardInterrupt.
Raises InputError, and ConvergenceError with all up to the last good crank angle in its attribute `result`.
Source: docs/theory/film.md. The same case gives the same bits as `ringfilm run`.)");
  type.def(
      "gradient",
      [](const CaseObject& self, const std::vector<std::string>& keys, const py::object& threads) {
        std::vector<run::Gradient> found;
        const int n = threads_of(threads);
        {
          const py::gil_scoped_release other_threads_continue;
          found = run::gradients(self.value(), keys, n);
        }
        py::dict by_quantity;
        for (const run::Gradient& one : found) {
          if (!one.reason.empty()) py::module_::import("warnings").attr("warn")(one.key + ": " + one.reason);
          for (const auto& [quantity, derivative] : one.derivatives) {
            const py::str name(quantity);
            if (!by_quantity.contains(name)) by_quantity[name] = py::dict();
            by_quantity[name][py::str(one.key)] = py::make_tuple(derivative.value, derivative.error);
          }
        }
        return by_quantity;
      },
      py::arg("keys") = std::vector<std::string>(), py::arg("threads") = py::none(),
      R"(What a small change of an input makes of each value: {quantity: {key: (derivative, error)}} in SI.

keys: numbers of the case, such as "ring.face_width"; without them all that it states. Four runs each, on fixed crank
    steps. threads: 1 to 1024; None: as many as the machine runs at once.
Keys for which a run has no solution are absent, with a UserWarning.
Raises InputError for a key whose value is not a number. Source: docs/theory/error-estimate.md, eq-gradient.)");
  type.def(
      "resolved", [](const CaseObject& self) { return io::resolved_case(self.value()); },
      "The case as a complete case file in SI, which gives the same bits again.");
  type.def_property_readonly(
      "title", [](const CaseObject& self) { return self.value().title; }, "Title of the case, a str.");
  type.def_property_readonly(
      "is_pad", [](const CaseObject& self) { return self.value().problem == cycle::Problem::kPad; },
      "Is it a film without engine and ring?");
  type.def_property_readonly(
      "rings",
      [](const CaseObject& self) {
        py::list rings;
        for (const Case& ring : self.value().rings) rings.append(CaseObject(ring));
        return rings;
      },
      "Of a ring pack ([[ring]]) the case of each ring alone, from the chamber down, a list of Case; else empty.");
  type.def_property_readonly(
      "files",
      [](const CaseObject& self) {
        py::list files;
        for (const cycle::InputFile& file : self.value().files)
          files.append(py::make_tuple(file.role, file.path, file.sha256));
        return files;
      },
      "The files that the case was read from: tuples (role, path, SHA-256).");
  type.def(
      "copy",
      [](const CaseObject& self, const py::dict& changes, const py::kwargs& named) {
        return in_notebook("changed")(py::cast(CaseObject(self)), changes, named);
      },
      py::arg("changes") = py::dict(),
      R"(A case of its own with the same values, but for some.

changes: {key: value}, as update() takes them. named: the same, with two underscores for the dot of a key:
case.copy(operating__speed="2000 rpm"). Raises as update() does.)");
  type.def_static(
      "new",
      [](const py::object& engine, const py::object& load, const py::object& state, const py::object& pack,
         const py::object& trace) { return in_notebook("new_case")(engine, load, state, pack, trace); },
      py::arg("engine") = std::string(io::kDefaultEngine), py::arg("load") = "full", py::arg("state") = "run-in",
      py::arg("pack") = false, py::arg("trace") = py::none(),
      R"(The case that `ringfilm new` writes, as a Case.

engine: a file in data/engines ("passenger-car", "heavy-duty", ...), or one of that form.
load: "part" or "full". state: "new", "run-in" or "worn", of the
surfaces. pack: all rings in place of the top ring. trace: a file of the cylinder pressure.
Raises InputError, also where the trace does not show what must be stated.)");
  type.def(
      "_repr_html_", [](const py::object& self) { return in_notebook("case_html")(self); },
      "The keys that the case states, as a notebook shows them.");
  type.def(
      "_without_file", [](CaseObject& self, const std::string& path) { self.forget_file(path); }, py::arg("path"),
      "Forgets a file that is read and removed.");
  type.def("_ipython_key_completions_", &keys_in_use, "What a notebook completes in case[...].");
  type.def(
      "__copy__", [](const CaseObject& self) { return self; }, "As copy().");
  type.def(
      "__deepcopy__", [](const CaseObject& self, const py::object&) { return self; }, py::arg("memo"), "As copy().");
  type.def(
      "__eq__",
      [](const CaseObject& self, const py::object& other) -> py::object {
        if (!py::isinstance<CaseObject>(other)) return py::reinterpret_borrow<py::object>(Py_NotImplemented);
        const auto& that = other.cast<const CaseObject&>().value();
        const auto same = [](const Case& a, const Case& b) {
          return a.problem == b.problem && study::digest_text(a) == study::digest_text(b);
        };
        return py::bool_(same(self.value(), that) && std::equal(self.value().rings.begin(), self.value().rings.end(),
                                                                that.rings.begin(), that.rings.end(), same));
      },
      py::arg("other"), "Have both cases the same values, from files with the same bytes?");
  type.attr("__hash__") = py::none();
  type.def("__repr__", &case_words, "Title, file and number of stated keys.");
  type.def(py::pickle(&case_state, &from_state));
  module.def(
      "starting_case",
      [](const std::string& engine, const std::optional<std::string>& trace, const std::string& load,
         const std::string& state, bool pack, bool all_keys) {
        return io::start_case({engine, load, state, pack, trace, "", {}, all_keys}).text;
      },
      py::arg("engine") = std::string(io::kDefaultEngine), py::arg("trace") = py::none(), py::arg("load") = "full",
      py::arg("state") = "run-in", py::arg("pack") = false, py::arg("all_keys") = false,
      R"(A commented case file to start from, a str, as `ringfilm new` writes it.

engine: a file in data/engines ("passenger-car", "heavy-duty", ...), or one of that form.
load: "part" or "full". state: "new", "run-in" or "worn", of the
surfaces. pack: all rings of the engine in place of the top ring alone. trace: a file of the cylinder pressure, whose
columns and units are read; what the file does not show is marked MISSING in the text. all_keys: every other key of a
ring as a comment.)");
}

}  // namespace ringfilm::python
