// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "enclosure/enclose.hpp"

namespace driver::commands {

/// `enclosure::enclose` of the module beside the program. Throws CaseError if there is none, because the
/// build had no Arb or the module was not installed.
enclosure::Tube enclose_by_module(const enclosure::Scene& scene, const enclosure::Request& request);

}  // namespace driver::commands
