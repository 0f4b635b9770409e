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

/// Traits of all laws, in the order of FabricLaws.
std::span<const LawTraits> fabric_laws();

/// Place in fabric_laws() of the law of this name for woven or for isotropic fabric; empty if there is none.
std::optional<int> find_law(std::string_view name, bool woven);

/// Traits of the law of this name, of either kind: compression, curves and own constants are the same for
/// both. Throws std::invalid_argument that lists the names.
const LawTraits& law_named(std::string_view name);

/// The names, each once, in the order of FabricLaws.
std::vector<std::string> law_names();

}  // namespace membrane
