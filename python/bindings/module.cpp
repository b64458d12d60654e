#include "bindings.hpp"

PYBIND11_MODULE(_ringfilm, module) {
  using namespace ringfilm::python;
  module.doc() = "The compiled part of ringfilm; import ringfilm instead.";
  bind_errors(module);
  bind_tables(module);
  bind_pad(module);
  bind_result(module);
  bind_case(module);
  bind_gas_path(module);
  bind_batch(module);
  bind_study(module);
  bind_life(module);
  bind_inverse(module);
  bind_surface(module);
  bind_conform(module);
  bind_face(module);
  bind_lateral_force(module);
  bind_laws(module);
  complete_classes(module);
}
