// SPDX-License-Identifier: Apache-2.0
// What `gasjet enclose` loads when it needs it: Arb with what it rests on takes as long to load as a short
// run.
#include "enclosure/enclose.hpp"

extern "C" [[gnu::visibility("default")]] void gasjet_enclose(const enclosure::Scene& scene,
                                                              const enclosure::Request& request,
                                                              enclosure::Tube& tube) {
  tube = enclosure::enclose(scene, request);
}
