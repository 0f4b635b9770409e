// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <span>
#include <string>
#include <string_view>

namespace membrane {

// Throws std::invalid_argument: "<where>: <field> = <value>, allowed: <allowed>".
[[noreturn]] void reject(std::string_view where, const std::string& field, double value,
                         const std::string& allowed);
[[noreturn]] void reject(std::string_view where, const std::string& problem);

std::string shown(double value);  // with enough digits to distinguish it from its neighbours

void require_positive(std::string_view where, const char* field, double value);  // finite and > 0
void require_not_negative(std::string_view where, const char* field, double value);
void require_finite(std::string_view where, const char* field, double value);

// Throws unless `node` is the number of a node.
void require_node(std::string_view where, const char* field, int node, Eigen::Index node_count);

struct BagDescription;
struct BagModel;

// Every number is one of an element.
void require_elements(std::string_view where, const BagModel& model, std::span<const int> elements);

// Makes all checks of make_model that need no computation. Throws std::invalid_argument.
void check_description(const BagDescription& description);

}  // namespace membrane
