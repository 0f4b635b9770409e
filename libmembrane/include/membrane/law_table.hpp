// SPDX-License-Identifier: Apache-2.0
// The fabric laws by their names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "membrane/law.hpp"

namespace membrane {

/// What all laws are for, in the order of FabricLaws.
std::span<const LawTraits> fabric_laws();

/// Place in fabric_laws() of the law of this name for woven or for isotropic fabric. None: there is none.
std::optional<int> find_law(std::string_view name, bool woven);

/// The same where at least one of the two must be there, as for a law's compression, curves and own
/// constants: they are the same for both. Throws std::invalid_argument, naming what is allowed.
const LawTraits& law_named(std::string_view name);

/// The names, each once, in the order of FabricLaws.
std::vector<std::string> law_names();

}  // namespace membrane
