// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "closed_form/catalogue.hpp"

// The catalogue's entries, in its order.
namespace closed_form::entries {

std::vector<Entry> tanks();
std::vector<Entry> tank_tests();
std::vector<Entry> outflow();
std::vector<Entry> emptying_tanks();
std::vector<Entry> exchanging_tanks();
std::vector<Entry> bags();
std::vector<Entry> polyhedra();
std::vector<Entry> inflated_shapes();
std::vector<Entry> flat_membranes();
std::vector<Entry> logarithmic_bags();
std::vector<Entry> discs();
std::vector<Entry> vibration();
std::vector<Entry> tension();
std::vector<Entry> waves();
std::vector<Entry> weave();
std::vector<Entry> time_steps();
std::vector<Entry> drifts();
std::vector<Entry> jets();
std::vector<Entry> jet_targets();
std::vector<Entry> shadows();
std::vector<Entry> swings();
std::vector<Entry> contact();
std::vector<Entry> coupled();

}  // namespace closed_form::entries
