// SPDX-License-Identifier: Apache-2.0
// [[membrane.fold]] -> the folded start shape.
#pragma once

#include <optional>

#include "base/case_reader.hpp"
#include "membrane/bag_model.hpp"
#include "mesh/fold.hpp"

namespace driver {

/// Folds `start` as [[membrane.fold]] says; nothing if the case has no fold. `bag` has the fixed nodes.
std::optional<mesh::Folding> read_folds(TableReader& table, const mesh::Mesh& mesh,
                                        const Eigen::Matrix3Xd& start, const membrane::BagDescription& bag);

/// Texts for straps that are longer than their free length at the start, so that they pull.
std::vector<std::string> tight_straps(const std::vector<membrane::Strap>& straps,
                                      const Eigen::Matrix3Xd& start);

}  // namespace driver
