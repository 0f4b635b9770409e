// SPDX-License-Identifier: Apache-2.0
// gasjet._gasjet: gasjet.h for Python. Names, defaults and docstrings are in the package beside it.
#include "module.hpp"

PYBIND11_MODULE(_gasjet, m) {
  py::class_<Handle>(m, "Handle");
  py::class_<gasjet_jet_model>(m, "JetModel");
  m.def("version", &gasjet_version);
  add_gas(m);
  add_bodies(m);
  add_coupling(m);
  add_rigid_body(m);
  add_runs(m);
  add_simulation(m);
}
