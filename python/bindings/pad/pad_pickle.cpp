#include "arguments.hpp"
#include "pad/pad_object.hpp"

// A pickle of a pad: every number by the name that result files give it, so that another order of members does no harm.
namespace ringfilm::python {
namespace {

constexpr int kPadStateVersion = 2;

std::vector<pad::PadQuantity> numbers() {
  std::vector<pad::PadQuantity> all = pad::pad_quantities();
  all.insert(all.end(), pad::width_quantities().begin(), pad::width_quantities().end());
  return all;
}

py::dict stored(const std::vector<pad::Sample>& samples) {
  py::dict columns;
  for (const auto& quantity : numbers()) {
    std::vector<double> values;
    for (const pad::Sample& sample : samples) values.push_back(sample.*quantity.value);
    columns[py::str(quantity.name)] = array_of(values);
  }
  for (const auto& quantity : pad::front_quantities()) {
    py::list lists;
    for (const pad::Sample& sample : samples) lists.append(array_of(sample.*quantity.value));
    columns[py::str(quantity.name)] = lists;
  }
  return columns;
}

std::vector<pad::Sample> samples_of(const py::dict& columns) {
  std::vector<pad::Sample> samples;
  for (const auto& quantity : numbers()) {
    const std::vector<double> values = pickled_row(columns[py::str(quantity.name)]);
    if (samples.empty()) samples.resize(values.size());
    if (values.size() != samples.size()) throw py::value_error("this pickle of a pad is damaged");
    for (std::size_t i = 0; i < values.size(); ++i) samples[i].*quantity.value = values[i];
  }
  for (const auto& quantity : pad::front_quantities()) {
    const auto lists = py::cast<py::list>(columns[py::str(quantity.name)]);
    if (lists.size() != samples.size()) throw py::value_error("this pickle of a pad is damaged");
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i].*quantity.value = pickled_row(lists[i]);
  }
  return samples;
}

py::list stored(const std::vector<pad::Profile>& profiles) {
  py::list list;
  for (const pad::Profile& one : profiles)
    list.append(
        py::make_tuple(one.time, array_of(one.film_thickness), array_of(one.pressure), array_of(one.film_content)));
  return list;
}

std::vector<pad::Profile> profiles_of(const py::handle& list) {
  std::vector<pad::Profile> profiles;
  for (const auto& item : py::cast<py::list>(list)) {
    const auto one = py::cast<py::tuple>(item);
    profiles.push_back({py::cast<double>(one[0]), pickled_row(one[1]), pickled_row(one[2]), pickled_row(one[3])});
  }
  return profiles;
}

py::tuple stored(const pad::Effort& effort) {
  return py::make_tuple(effort.time_steps, effort.sub_steps, effort.newton_iterations, effort.cut_steps,
                        effort.eased_starts, effort.max_newton_step);
}

pad::Effort effort_of(const py::handle& stored) {
  const auto of = py::cast<py::tuple>(stored);
  return {py::cast<long>(of[0]), py::cast<long>(of[1]), py::cast<long>(of[2]),
          py::cast<long>(of[3]), py::cast<long>(of[4]), py::cast<double>(of[5])};
}

}  // namespace

py::tuple pad_state(const PadObject& self) {
  const io::PadDocument& document = self.document();
  const pad::PadResult& result = document.result;
  py::list inputs, notes;
  for (const io::CaseEntry& entry : document.inputs)
    inputs.append(
        py::make_tuple(entry.key, entry.value, entry.shown, entry.assumed, entry.help, entry.value_si, entry.unit));
  for (const cycle::Note& note : result.notes) notes.append(py::make_tuple(note.topic, note.message, note.count));
  const io::Provenance& from = document.provenance;
  return py::make_tuple(kPadStateVersion, document.title, inputs, document.input_notes,
                        py::make_tuple(from.program, from.commit, from.compiler, from.kernels), stored(result.samples),
                        array_of(result.x), array_of(result.y), stored(result.profiles), stored(result.fields), notes,
                        stored(result.effort), result.is_history, result.complete);
}

PadObject pad_of_state(const py::tuple& state) {
  if (state.size() != 14 || py::cast<int>(state[0]) != kPadStateVersion)
    throw py::value_error("this is a pickle of a pad of another version of ringfilm");
  io::PadDocument document;
  document.title = py::cast<std::string>(state[1]);
  for (const auto& item : py::cast<py::list>(state[2])) {
    const auto entry = py::cast<py::tuple>(item);
    document.inputs.push_back({py::cast<std::string>(entry[0]), py::cast<std::string>(entry[1]),
                               py::cast<std::string>(entry[2]), py::cast<bool>(entry[3]),
                               py::cast<std::string>(entry[4]), py::cast<double>(entry[5]),
                               py::cast<std::string>(entry[6])});
  }
  document.input_notes = py::cast<std::vector<std::string>>(state[3]);
  const auto from = py::cast<std::vector<std::string>>(state[4]);
  document.provenance.program = from.at(0);
  document.provenance.commit = from.at(1);
  document.provenance.compiler = from.at(2);
  document.provenance.kernels = from.at(3);
  pad::PadResult& result = document.result;
  result.samples = samples_of(py::cast<py::dict>(state[5]));
  result.x = pickled_row(state[6]);
  result.y = pickled_row(state[7]);
  result.profiles = profiles_of(state[8]);
  result.fields = profiles_of(state[9]);
  for (const auto& item : py::cast<py::list>(state[10])) {
    const auto note = py::cast<py::tuple>(item);
    result.notes.push_back({py::cast<std::string>(note[0]), py::cast<std::string>(note[1]), py::cast<long>(note[2])});
  }
  result.effort = effort_of(state[11]);
  result.is_history = py::cast<bool>(state[12]);
  result.complete = py::cast<bool>(state[13]);
  return PadObject(std::move(document));
}

}  // namespace ringfilm::python
