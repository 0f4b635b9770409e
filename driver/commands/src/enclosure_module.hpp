// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "enclosure/enclose.hpp"
#include "enclosure/formula.hpp"

// Functions of the module beside the program. They throw CaseError if there is none, because the build had no
// Arb or the module was not installed.
namespace driver::commands {

/// `enclosure::enclose`.
enclosure::Tube enclose_by_module(const enclosure::Scene& scene, const enclosure::Request& request);
/// `enclosure::prove`.
enclosure::ProvedForm prove_by_module(const enclosure::Question& question);
/// `enclosure::formula_names`.
std::map<std::string, std::string> formula_names_by_module();

}  // namespace driver::commands
