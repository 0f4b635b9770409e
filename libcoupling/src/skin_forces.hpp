// SPDX-License-Identifier: Apache-2.0
// Forces, energy and stiffness of the parts of a skin that touch (K.44 to K.46, K.48).
#pragma once
#include <vector>

#include "skin_limits.hpp"
#include "skin_search.hpp"

namespace coupling::detail {

/// What a run remembers beside its search.
struct SkinMemory {
  explicit SkinMemory(const SkinParts& parts);
  SkinLimits limits;
  std::vector<double> stiffness;  // (N) [N/m] 0 between calls
  std::vector<int> loaded;        // nodes with a stiffness
};

/// Adds the forces of one level to `forces`, and fills the result but for what the search gives.
class SkinForces {
 public:
  SkinForces(const SkinSearch& search, const Nodes& nodes, SkinMemory& memory, NodalForces& forces,
             SkinContactResult& result)
      : search_(search),
        parts_(*search.parts()),
        nodes_(nodes),
        memory_(memory),
        forces_(forces),
        result_(result) {}
  void add();

 private:
  void add_node(const Touch& touch);
  void add_edges(const Touch& touch);
  void push(int node, int first, int second, double stiffness, double limit, double steepness);
  void push(const int (&node)[4], int corners, const double* weight, const Eigen::Vector3d& normal,
            double stiffness, double limit, double distance, double steepness);
  void stiffen(const int (&node)[4], int corners, const double* weight, double steepness);
  void add_kinks(const Touch& touch, double stiffness, double limit);
  void note(const Touch& touch);

  const SkinSearch& search_;
  const SkinParts& parts_;
  const Nodes& nodes_;
  SkinMemory& memory_;
  NodalForces& forces_;
  SkinContactResult& result_;
};

}  // namespace coupling::detail
