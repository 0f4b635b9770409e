// SPDX-License-Identifier: Apache-2.0
// Every wrong input is refused by name.
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <stdexcept>
#include <string>

#include "membrane/node_order.hpp"
#include "refusal.hpp"
#include "scenes.hpp"

using membrane::BagDescription;

namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

BagDescription good() {
  return scenes::describe(mesh::icosphere(0.3, 1), membrane::Compression::none);
}

struct BadInput {
  std::function<void(BagDescription&)> spoil;
  std::vector<std::string> named;  // what the message must name
};

void collapse(BagDescription& d) {
  d.reference.col(d.elements(1, 4)) = d.reference.col(d.elements(0, 4));
}

// All elements around node 7 are null.
void hole_with_inner_node(BagDescription& d) {
  for (Eigen::Index e = 0; e < d.elements.cols(); ++e)
    if ((d.elements.col(e).array() == 7).any()) {
      d.properties[static_cast<std::size_t>(e)] = {};
      d.properties[static_cast<std::size_t>(e)].null_panel = true;
    }
}

const std::vector<BadInput> kBadInputs = {
    {[](auto& d) { d.properties[3].thickness = 0.0; }, {"element 3", "thickness", "> 0"}},
    {[](auto& d) { d.properties[3].thickness = kNaN; }, {"element 3", "thickness"}},
    {[](auto& d) { d.properties[2].density = -1.0; }, {"element 2", "density", "-1"}},
    {[](auto& d) { d.properties[2].young_modulus = kInf; }, {"element 2", "young_modulus"}},
    {[](auto& d) { d.properties[2].poisson = 1.0; }, {"element 2", "poisson", "1"}},
    {[](auto& d) { d.properties[2].porosity = 1.5; }, {"element 2", "porosity", "0 to 1"}},
    {[](auto& d) { d.properties[2] = {}; }, {"element 2", "thickness"}},
    {[](auto& d) { d.properties.pop_back(); }, {"properties", "79", "80"}},
    {[](auto& d) {
       d.law = "hencky";
       d.compression = membrane::Compression::linear;
     },
     {"bag", "hencky", "no compression", "Compression::none"}},
    {[](auto& d) {
       d.law = "hencky";
       d.properties[7].weave = membrane::WeaveProperties{20e6, 5e6, {1.0, 0.0, 0.0}};
     },
     {"element 7", "hencky", "without weave"}},
    {[](auto& d) { d.law = "henky"; }, {"bag", "law = henky", "saint_venant_kirchhoff, hencky, curve"}},
    {[](auto& d) { d.elements(1, 5) = 42; }, {"element 5", "42", "0 to 41"}},
    {[](auto& d) { d.elements(1, 5) = -1; }, {"element 5", "-1"}},
    {[](auto& d) { d.elements(1, 5) = d.elements(0, 5); }, {"element 5", "repeated"}},
    {[](auto& d) { d.reference(1, 9) = kNaN; }, {"node 9", "coordinate"}},
    {collapse, {"reference area"}},
    {[](auto& d) { d.reference *= 1e120; }, {"reference area"}},  // its square has no double
    {[](auto& d) {
       d.reference.conservativeResize(3, 43);
       d.reference.col(42).setZero();
     },
     {"node 42", "no element"}},
    {hole_with_inner_node, {"node 7", "null panel", "rim"}},
    {[](auto& d) {
       d.properties[1].null_panel = true;
       d.properties[1].porosity = 0.1;
     },
     {"element 1", "porosity", "null"}},
    {[](auto& d) {
       d.fixed_nodes = {0, 42};
     },
     {"fixed_nodes", "42"}},
    {[](auto& d) {
       d.held_nodes[2] = {0, -1};
     },
     {"held_nodes", "-1"}},
    {[](auto& d) {
       d.straps = {{0, 50, 1.0, 1.0}};
     },
     {"strap 0", "node_b", "50"}},
    {[](auto& d) {
       d.straps = {{3, 3, 1.0, 1.0}};
     },
     {"strap 0", "same node"}},
    {[](auto& d) {
       d.straps = {{0, 1, 1.0, 1.0}, {0, 2, -1.0, 1.0}};
     },
     {"strap 1", "stiffness"}},
    {[](auto& d) {
       d.straps = {{0, 1, 1.0, 0.0}};
     },
     {"strap 0", "free_length"}},
    {[](auto& d) {
       d.plates = {{{0, 0, 0}, {0, 0, 0}, 1.0}};
     },
     {"plate 0", "normal"}},
    {[](auto& d) {
       d.plates = {{{0, 0, 0}, {0, 0, 1}, 0.0}};
     },
     {"plate 0", "stiffness"}},
    {[](auto& d) { d.plates.resize(1); }, {"plate 0", "point"}},
    {[](auto& d) { d.mass_damping = -1.0; }, {"mass_damping"}},
    {[](auto& d) { d.gravity[2] = kInf; }, {"gravity"}},
    {[](auto& d) { d.elements.resize(3, 0); }, {"no elements"}},
};

}  // namespace

TEST(Input, wrong_description_is_refused_by_name) {
  EXPECT_NO_THROW(make_model(good()));
  for (std::size_t i = 0; i < kBadInputs.size(); ++i) {
    BagDescription d = good();
    kBadInputs[i].spoil(d);
    const std::string message = refusal([&] { make_model(d); });
    for (const auto& name : kBadInputs[i].named)
      EXPECT_NE(message.find(name), std::string::npos) << "input " << i << ": " << message;
  }
}

TEST(Input, wrong_state_and_stage_arguments_are_refused) {
  const auto model = make_model(good());
  Eigen::Matrix3Xd x = model.description.reference;
  EXPECT_NE(refusal([&] { membrane::make_state(model, x.leftCols(41)); }).find("41"), std::string::npos);
  x(2, 5) = kNaN;
  EXPECT_NE(refusal([&] { membrane::make_state(model, x); }).find("node 5"), std::string::npos);
  auto state = membrane::make_state(model, model.description.reference);
  EXPECT_NE(refusal([&] { membrane::advance(model, state, 1e-5, 0.0); }).find("dt_after"), std::string::npos);
  EXPECT_NE(refusal([&] { membrane::advance(model, state, -1e-5, 1e-5); }).find("dt_before"),
            std::string::npos);
  const std::vector<double> dp(80, 0.0);
  EXPECT_NE(refusal([&] { membrane::jet_forces(model, state, dp); }).find("LoadKinds"), std::string::npos);
  EXPECT_NE(refusal([&] { membrane::update_geometry(model, state); }).find("LoadKinds"), std::string::npos);
  auto jet_state = membrane::make_state(model, model.description.reference, {.jet = true});
  const std::vector<int> absent{3, 80};
  const std::vector<membrane::JetLoad> loads{{dp, absent}};
  EXPECT_NE(refusal([&] { membrane::jet_forces(model, jet_state, loads); }).find("element = 80"),
            std::string::npos);
  EXPECT_NE(refusal([&] { membrane::update_geometry(model, jet_state, absent); }).find("element = 80"),
            std::string::npos);
  EXPECT_NE(refusal([&] { element_response(model, state, 80); }).find("80"), std::string::npos);
}

// Of another model, or of none: every stage compares sizes before it reads.
TEST(Input, state_of_another_model_is_refused) {
  const auto model = make_model(good());
  const auto finer = make_model(scenes::describe(mesh::icosphere(0.3, 2), membrane::Compression::none));
  auto d = good();
  d.stiffness_damping = 1e-4;
  d.straps = {{0, 1, 4500.0, 0.1}};
  const auto damped = make_model(d);
  const membrane::LoadKinds loads{.jet = true, .contact = true};
  const std::vector<double> dp(80, 0.0);
  std::vector<double> strains(80);
  using Call = std::function<void(membrane::BagState&)>;
  const std::vector<Call> stages = {[&](auto& s) { membrane::update_skin(model, s); },
                                    [&](auto& s) { membrane::update_surface(model, s); },
                                    [&](auto& s) { membrane::membrane_forces(model, s); },
                                    [&](auto& s) { membrane::update_geometry(model, s); },
                                    [&](auto& s) { membrane::update_geometry(model, s, std::vector{3}); },
                                    [&](auto& s) { membrane::jet_forces(model, s, dp); },
                                    [&](auto& s) { membrane::support_forces(model, s); },
                                    [&](auto& s) { membrane::viscous_forces(model, s, 0.0); },
                                    [&](auto& s) { membrane::update_mass_shares(model, s); },
                                    [&](auto& s) { membrane::advance(model, s, 0.0, 1e-6); },
                                    [&](auto& s) { membrane::stiffness_shares(model, s, 0.0, 0.0); },
                                    [&](auto& s) { membrane::force_mobility(model, s); },
                                    [&](auto& s) { membrane::strap_mobility(model, s); },
                                    [&](auto& s) { membrane::element_response(model, s, 0); },
                                    [&](auto& s) { membrane::largest_strains(model, s, strains); },
                                    [&](auto& s) { membrane::governing_element(model, s); }};
  auto own = membrane::make_state(model, model.description.reference, loads);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    EXPECT_EQ(refusal([&] { stages[i](own); }), "accepted") << i;
    for (auto foreign :
         {membrane::BagState(), membrane::make_state(finer, finer.description.reference, loads),
          membrane::make_state(damped, d.reference, loads)})
      EXPECT_NE(refusal([&] { stages[i](foreign); }).find("make_state"), std::string::npos) << i;
  }
}

TEST(Input, node_order_refuses_a_number_of_no_node) {
  Eigen::Matrix3Xi elements = good().elements;
  for (const int wrong : {-1, 42}) {
    elements(2, 7) = wrong;
    EXPECT_NE(refusal([&] { membrane::node_order(elements, 42); }).find("node_order: node number"),
              std::string::npos);
  }
}

TEST(Input, null_panel_with_rim_nodes_only_is_accepted) {
  auto d = good();
  d.properties[0] = {};
  d.properties[0].null_panel = true;
  EXPECT_NO_THROW(make_model(d));
}
