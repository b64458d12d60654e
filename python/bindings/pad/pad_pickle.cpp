#include "arguments.hpp"
#include "members.hpp"
#include "pad/pad_object.hpp"
#include "ringfilm/io/result/input_members.hpp"

// A pickle of a pad: every number by the name that result files give it, so that another order of members does no harm.
namespace ringfilm::python {
namespace {

constexpr int kPadStateVersion = 4;

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

}  // namespace

py::tuple pad_state(const PadObject& self) {
  const io::PadDocument& document = self.document();
  const pad::PadResult& result = document.result;
  return py::make_tuple(kPadStateVersion, document.title, members_list(document.inputs), document.input_notes,
                        members_dict(document.provenance), stored(result.samples), array_of(result.x),
                        array_of(result.y), members_list(result.profiles), members_list(result.fields),
                        members_list(result.notes), members_dict(result.effort), result.is_history, result.complete);
}

PadObject pad_of_state(const py::tuple& state) {
  if (state.size() != 14 || py::cast<int>(state[0]) != kPadStateVersion)
    throw py::value_error("this is a pickle of a pad of another version of ringfilm");
  io::PadDocument document;
  document.title = py::cast<std::string>(state[1]);
  document.inputs = records_of<io::CaseEntry>(state[2]);
  document.input_notes = py::cast<std::vector<std::string>>(state[3]);
  document.provenance = record_of<io::Provenance>(state[4]);
  pad::PadResult& result = document.result;
  result.samples = samples_of(py::cast<py::dict>(state[5]));
  result.x = pickled_row(state[6]);
  result.y = pickled_row(state[7]);
  result.profiles = records_of<pad::Profile>(state[8]);
  result.fields = records_of<pad::Profile>(state[9]);
  result.notes = records_of<cycle::Note>(state[10]);
  result.effort = record_of<pad::Effort>(state[11]);
  result.is_history = py::cast<bool>(state[12]);
  result.complete = py::cast<bool>(state[13]);
  return PadObject(std::move(document));
}

}  // namespace ringfilm::python
