// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>

namespace mesh {

struct Mesh;

// Throws std::invalid_argument: "<where>: <field> = <value>, allowed: <allowed>".
[[noreturn]] void reject(std::string_view where, const std::string& field, double value,
                         const std::string& allowed);

std::string shown(double value);  // enough digits to tell it from its neighbours

void require_positive(std::string_view where, const char* field, double value);  // finite and > 0

// Every corner is a number of a node.
void require_nodes(std::string_view where, const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                   Eigen::Index node_count);
void require_panels(std::string_view where, const Mesh& mesh);  // one index of a panel for each element

}  // namespace mesh
