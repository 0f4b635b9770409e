// SPDX-License-Identifier: Apache-2.0
// Library jet_tree: the reference route through CGAL's AABB tree. The tree is GPL, therefore it is a library
// of its own.
#pragma once

namespace jet {

/// Makes VisibilityRoute::cgal_tree available in this program. Returns true, so that an initialiser can call
/// it.
bool add_tree_route();

}  // namespace jet
