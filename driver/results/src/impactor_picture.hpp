// SPDX-License-Identifier: Apache-2.0
// Surface of an impactor for pictures.
#pragma once

#include "engine/scene.hpp"

namespace driver {

/// Its shape in the body's axes [m], as triangles.
mesh::Mesh impactor_picture(const coupling::Impactor& shape);

}  // namespace driver
