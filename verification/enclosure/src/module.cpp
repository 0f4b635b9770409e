// SPDX-License-Identifier: Apache-2.0
// What `gasjet enclose` and `gasjet exact --proved` load when they need it: Arb with what it rests on takes
// as long to load as a short run.
#include "enclosure/enclose.hpp"
#include "enclosure/formula.hpp"

extern "C" [[gnu::visibility("default")]] void gasjet_enclose(const enclosure::Scene& scene,
                                                              const enclosure::Request& request,
                                                              enclosure::Tube& tube) {
  tube = enclosure::enclose(scene, request);
}

extern "C" [[gnu::visibility("default")]] void gasjet_prove(const enclosure::Question& question,
                                                            enclosure::ProvedForm& form) {
  form = enclosure::prove(question);
}

extern "C" [[gnu::visibility("default")]] void gasjet_formula_names(
    std::map<std::string, std::string>& names) {
  names = enclosure::formula_names();
}
