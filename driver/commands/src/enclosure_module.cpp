// SPDX-License-Identifier: Apache-2.0
#include "enclosure_module.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include "base/case_reader.hpp"

namespace driver::commands {
namespace {

/// The function of this name and type in the module.
template <class Function>
Function* of_module(const char* name) {
  // By the program's own search path, in the build folder as installed.
  void* module = dlopen(GASJET_ENCLOSURE_MODULE, RTLD_NOW | RTLD_LOCAL);
  if (!module)
    throw CaseError(fmt::format(
        "no ball arithmetic: {}; if it is not there, install Arb (Debian: libflint-arb-dev), then "
        "configure and build again; if a library of it is not, install that (Debian: libflint-arb2)",
        dlerror()));
  auto* function = reinterpret_cast<Function*>(dlsym(module, name));
  if (!function) throw CaseError(fmt::format("{} is of another program", GASJET_ENCLOSURE_MODULE));
  return function;
}

}  // namespace

enclosure::Tube enclose_by_module(const enclosure::Scene& scene, const enclosure::Request& request) {
  enclosure::Tube tube;
  of_module<void(const enclosure::Scene&, const enclosure::Request&, enclosure::Tube&)>("gasjet_enclose")(
      scene, request, tube);
  return tube;
}

enclosure::ProvedForm prove_by_module(const enclosure::Question& question) {
  enclosure::ProvedForm form;
  of_module<void(const enclosure::Question&, enclosure::ProvedForm&)>("gasjet_prove")(question, form);
  return form;
}

std::map<std::string, std::string> formula_names_by_module() {
  std::map<std::string, std::string> names;
  of_module<void(std::map<std::string, std::string>&)>("gasjet_formula_names")(names);
  return names;
}

}  // namespace driver::commands
