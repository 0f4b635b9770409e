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

std::string three_digits(double value);  // for reading
std::string shown(double value);         // with enough digits to distinguish it from its neighbours

void require_positive(std::string_view where, const char* field, double value);  // finite and > 0

// Throws unless every corner is the number of a node.
void require_nodes(std::string_view where, const Eigen::Ref<const Eigen::Matrix3Xi>& elements,
                   Eigen::Index node_count);
void require_panels(std::string_view where, const Mesh& mesh);  // throws unless each element has the index of
                                                                // a panel

}  // namespace mesh
