// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

#include "membrane/element_group.hpp"
#include "membrane/material.hpp"

namespace membrane {

// Functions of a law that the library needs outside the kernels.
struct LawFunctions {
  Weave (*stiffness)(const LawInput& fabric);
  // Writes the constants of one element.
  void (*write)(const LawInput& fabric, FabricGroup& group, std::size_t lane);
  // Writes the constants of an element without stress.
  void (*write_none)(FabricGroup& group, std::size_t lane);
  PlaneResponse<double> (*response)(Compression compression, const PlaneStrain<double>& strain,
                                    const FabricGroup& group, std::size_t lane, const YarnCurves& curves);
};

const LawFunctions& law_functions(int law);  // place in FabricLaws

}  // namespace membrane
