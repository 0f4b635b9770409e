// SPDX-License-Identifier: Apache-2.0
#include "enclosure_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/case_reader.hpp"

namespace driver::commands {

enclosure::Tube enclose_by_module(const enclosure::Scene& scene, const enclosure::Request& request) {
  // By the program's own search path, in the build folder as installed.
  void* module = dlopen(GASJET_ENCLOSURE_MODULE, RTLD_NOW | RTLD_LOCAL);
  if (!module)
    throw CaseError(fmt::format(
        "enclose: no ball arithmetic: {}; if it is not there, install Arb (Debian: libflint-arb-dev), then "
        "configure and build again; if a library of it is not, install that (Debian: libflint-arb2)",
        dlerror()));
  using Enclose = void(const enclosure::Scene&, const enclosure::Request&, enclosure::Tube&);
  auto* enclose = reinterpret_cast<Enclose*>(dlsym(module, "gasjet_enclose"));
  if (!enclose) throw CaseError(fmt::format("enclose: {} is of another program", GASJET_ENCLOSURE_MODULE));
  enclosure::Tube tube;
  enclose(scene, request, tube);
  return tube;
}

}  // namespace driver::commands
