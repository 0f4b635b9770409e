// SPDX-License-Identifier: Apache-2.0
// The options --cap and --cap-length of `gasjet mesh convert`.
#pragma once

#include <string>
#include <vector>

#include "commands/command.hpp"
#include "mesh/mesh.hpp"

namespace driver::commands {

/// Closes the holes that the command line names, prints a line for each, and adds their panels to
/// `null_panels`. Throws CaseError, with a list of the holes.
void close_holes_of(mesh::Mesh& mesh, const MeshArguments& arguments, std::vector<std::string>& null_panels);

}  // namespace driver::commands
