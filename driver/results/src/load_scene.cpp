// SPDX-License-Identifier: Apache-2.0
#include "results/load_scene.hpp"

#include "results/mesh_reader.hpp"
#include "results/skin_checks.hpp"

namespace driver {

Scene load_scene(CaseDocument& document) {
  Scene scene = read_scene(document, read_any_mesh);
  if (scene.skin_contact) require_separate_layers(document, scene);
  return scene;
}

}  // namespace driver
