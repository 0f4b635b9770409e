// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

// Plain data only: the kernels include this, once for each instruction set.
namespace membrane {

// The kernels handle elements in groups of this many lanes, whatever the instruction set.
inline constexpr int kLanes = 4;

// A block has at most this many elements and nodes, so that its positions and sums stay in the first-level
// cache. Blocks are what threads share out, and the bits of a sum depend on them alone.
inline constexpr int kBlockElements = 512;
inline constexpr int kBlockNodes = 384;  // see kBlockElements

// What four elements have in common with many others: a table of the few that differ stays in the first-level
// cache.
struct alignas(32) FabricGroup {
  double young_modulus[kLanes];     // see IsotropicConstants [Pa], 0 for null
  double spherical[kLanes];         // as above; of a woven bag see OrthotropicConstants
  double deviator[kLanes];          // as above
  double porosity[kLanes];          // eta [-]
  double porosity_squared[kLanes];  // eta^2 [-]
};

// All else that the kernels read of four elements and never changes, in one stream.
struct alignas(32) ElementGroup {
  std::uint16_t node[3][kLanes];  // corners a, b, c: places in the block's list of nodes
  std::int32_t fabric;            // place in the table of fabrics
  // Gradients of the corner functions in the element's frame (first axis along a-b):
  // grad N_b = (gradient_b1, gradient_b2), grad N_c = (0, gradient_c2), grad N_a = -(grad N_b + grad N_c).
  alignas(32) double gradient_b1[kLanes];
  double gradient_b2[kLanes];  // [1/m]
  double gradient_c2[kLanes];  // [1/m]
  double volume[kLanes];       // h * reference area [m3], 0 for null
};

// The bound of omega^2 (M.10) of four elements with their shares of the mass, 0 for null.
struct alignas(64) FrequencyGroup {
  double material[kLanes];   // [1/s2]
  double geometric[kLanes];  // per principal stress [1/(s2 Pa)]
};

// Beside `spherical` and `deviator` of its fabric, for a woven bag only: see OrthotropicConstants.
struct alignas(32) WeaveGroup {
  double cosine[kLanes];      // of twice the angle to the warp
  double sine[kLanes];        // of the same
  double warp_scale[kLanes];  // [-]
  double shear[kLanes];       // 2 G [Pa]
  double series[kLanes];      // [Pa], 0 for null
  double skew[kLanes];        // [-]
  double taut[kLanes];        // [-]
};

// Elements and nodes of one block. Its nodes are those of its own first, then those it shares with others.
struct ElementBlock {
  std::int32_t first_group;   // in BlockTable::group
  std::int32_t last_group;    // one past it
  std::int32_t first_node;    // in BlockTable::node: of its own
  std::int32_t first_shared;  // the shared ones follow
  std::int32_t last_node;     // one past them
  std::int32_t first_slot;    // of its shared nodes, in BagState::shared_sums
};

// Force of the fabric and gradient of the volume at one node, or one block's share of them.
struct alignas(64) NodeSums {
  double force[4];     // [N], fourth 0
  double gradient[4];  // three times dV/dx [m2], fourth 0
};

}  // namespace membrane
