// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "membrane/fabric_laws.hpp"

/// Plain data only, because the kernels include this once for each instruction set.
namespace membrane {

/// Elements of a group, which the kernels handle together, with every instruction set.
inline constexpr int kLanes = 4;

/// Most elements and nodes of a block, so that its positions and sums stay in the first-level cache. Threads
/// take whole blocks, so the bits of a sum depend only on the blocks.
inline constexpr int kBlockElements = 512;
inline constexpr int kBlockNodes = 384;  // see kBlockElements

/// Constants of four elements, shared by groups. The table has each distinct one once; for isotropic fabric
/// it stays in the first-level cache.
struct alignas(32) FabricGroup {
  double porosity[kLanes];                   // eta [-]
  double porosity_squared[kLanes];           // eta^2 [-]
  double constants[kMostConstants][kLanes];  // constants of the law, in the order of its Constants; then 0
};

/// All other constants of four elements that the kernels read, as one stream.
struct alignas(32) ElementGroup {
  std::uint16_t node[3][kLanes];  // corners a, b, c, as places in the block's list of nodes
  std::int32_t fabric;            // place in the table of fabrics
  /// [1/m] Gradients of the corner functions in the element's frame (first axis along a-b):
  ///   grad N_b = (gradient_b1, gradient_b2), grad N_c = (0, gradient_c2), grad N_a = -(grad N_b + grad N_c).
  alignas(32) double gradient_b1[kLanes];
  double gradient_b2[kLanes];  // [1/m]
  double gradient_c2[kLanes];  // [1/m]
  double volume[kLanes];       // h * reference area [m3], 0 for null elements
};

/// Bound of omega^2 (M.10) of four elements with their shares of the mass; 0 for null elements.
struct alignas(64) FrequencyGroup {
  double material[kLanes];   // [1/s2]
  double geometric[kLanes];  // per unit of principal stress [1/(s2 Pa)]
};

/// Elements and nodes of one block. Its own nodes come first, then those it shares with other blocks.
struct ElementBlock {
  std::int32_t first_group;   // place in BlockTable::group
  std::int32_t last_group;    // one past the last
  std::int32_t first_node;    // place in BlockTable::node of the first own node
  std::int32_t first_shared;  // first shared node, one past the own ones
  std::int32_t last_node;     // one past the shared nodes
  std::int32_t first_slot;    // first slot of its shared nodes in BagState::shared_sums
};

/// Force of the fabric and gradient of the volume at one node: the total, or the part of one block.
struct alignas(64) NodeSums {
  double force[4];     // [N], the fourth is 0
  double gradient[4];  // three times dV/dx [m2], the fourth is 0
};

}  // namespace membrane
