// SPDX-License-Identifier: Apache-2.0
#include "results/load_scene.hpp"

#include "results/mesh_reader.hpp"

namespace driver {

Scene load_scene(CaseDocument& document) {
  return read_scene(document, read_any_mesh);
}

}  // namespace driver
