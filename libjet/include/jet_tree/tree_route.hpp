// SPDX-License-Identifier: Apache-2.0
// Library jet_tree: the reference route through CGAL's AABB tree. That tree is GPL, so it stands apart from
// libjet.
#pragma once

namespace jet {

/// From now on VisibilityRoute::cgal_tree may be asked for in this program. Returns true, for initialisers.
bool add_tree_route();

}  // namespace jet
