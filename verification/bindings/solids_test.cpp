// SPDX-License-Identifier: Apache-2.0
// Membrane, contact and pendulum through gasjet.h.
#include "meshes.hpp"

using namespace border_test;

namespace {

const gasjet_fabric_model kFabric{4e-4, 800.0, 3e8, 0.3, 0, GASJET_SAINT_VENANT_KIRCHHOFF};

struct Bag {
  explicit Bag(const Mesh& given, const gasjet_fabric_model& fabric = kFabric) : mesh(given) {
    EXPECT_OK(gasjet_membrane_create(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                     mesh.triangle_count(), nullptr, &fabric, nullptr, 0, nullptr, 0,
                                     &handle.value));
  }
  gasjet_membrane_sums at(const std::vector<double>& nodes) {
    gasjet_membrane_sums sums{};
    force.resize(nodes.size());
    gradient.resize(nodes.size());
    EXPECT_OK(gasjet_membrane_evaluate(handle.value, nodes.data(), mesh.node_count(), nullptr, 1.4, 2e5,
                                       force.data(), gradient.data(), static_cast<int64_t>(force.size()),
                                       &sums));
    return sums;
  }
  Mesh mesh;
  Handle handle;
  std::vector<double> force, gradient;
};

/// Stretched and sheared, so that every element has a strain.
std::vector<double> deformed(const Mesh& mesh) {
  auto nodes = mesh.nodes;
  for (std::size_t i = 0; i < nodes.size(); i += 3) {
    nodes[i] *= 1.02;
    nodes[i + 1] += 0.01 * nodes[i] * nodes[i + 2];
    nodes[i + 2] *= 1.03 + 0.01 * nodes[i + 1];
  }
  return nodes;
}

TEST(c_membrane, box_has_its_volume_area_and_mass) {
  Bag bag(box(3, 0.5));
  const auto sums = bag.at(bag.mesh.nodes);
  EXPECT_NEAR(sums.volume, 0.125, 1e-15);
  EXPECT_NEAR(sums.area, 1.5, 1e-14);
  EXPECT_NEAR(sums.mass, 1.5 * 4e-4 * 800.0, 1e-15);
  EXPECT_NEAR(sums.strain_energy, 0.0, 1e-20);
  std::vector<double> mass(static_cast<std::size_t>(bag.mesh.node_count()));
  ASSERT_OK(gasjet_membrane_masses(bag.handle.value, mass.data(), bag.mesh.node_count()));
  double sum = 0.0;
  for (const double m : mass) sum += m;
  EXPECT_NEAR(sum, sums.mass, 1e-15);
  EXPECT_DOUBLE_EQ(sums.critical_step, 2.0 / std::sqrt(sums.element_frequency + sums.gas_frequency));
}

TEST(c_membrane, forces_and_gradient_eq_differences_of_energy_and_volume) {
  Bag bag(box(2, 0.5));
  auto nodes = deformed(bag.mesh);
  bag.at(nodes);
  const auto force = bag.force, gradient = bag.gradient;
  constexpr double step =
      1e-6;  // [m] error of the central difference: step^2 of a third derivative, and round-off / step
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const double x = nodes[i];
    nodes[i] = x + step;
    const auto after = bag.at(nodes);
    nodes[i] = x - step;
    const auto before = bag.at(nodes);
    nodes[i] = x;
    EXPECT_NEAR(-(after.strain_energy - before.strain_energy) / (2.0 * step), force[i],
                1e-3);  // of some 1e3 N
    EXPECT_NEAR((after.volume - before.volume) / (2.0 * step), gradient[i], 1e-9);
  }
}

// Stretched alike in both directions by s, fabric of thickness h, E and nu has an energy an area of
// h E/(1 - nu) ((s^2 - 1)/2)^2 if stress is linear in Green-Lagrange strain, and if Cauchy's is linear in
// ln s, of the integral of 2 h E/(1 - nu) s ln s ds = h E/(1 - nu) (s^2 ln s - (s^2 - 1)/2).
TEST(c_membrane, energy_of_an_even_stretch_is_that_of_the_law) {
  constexpr double stretch = 1.2, modulus = 4e-4 * 3e8 / 0.7, half = (stretch * stretch - 1.0) / 2.0;
  const Mesh mesh = box(2, 0.5);
  auto nodes = mesh.nodes;
  for (double& x : nodes) x *= stretch;
  const double linear = Bag(mesh).at(nodes).strain_energy;
  gasjet_fabric_model fabric = kFabric;
  fabric.wrinkles = 1;
  fabric.law = GASJET_HENCKY;
  const double hencky = Bag(mesh, fabric).at(nodes).strain_energy;
  // 1.5 m2; some ten operations and, for the logarithm, cancellation by a factor of 13.
  EXPECT_NEAR(linear, 1.5 * modulus * half * half, 1e-14 * linear);
  EXPECT_NEAR(hencky, 1.5 * modulus * (stretch * stretch * std::log(stretch) - half), 1e-13 * hencky);
}

TEST(c_membrane, layouts_give_the_same_bits) {
  Bag bag(box(2, 0.5));
  const auto nodes = deformed(bag.mesh);
  const double energy = bag.at(nodes).strain_energy;
  for (const Layout& layout : layouts_of(nodes)) {
    gasjet_membrane_sums sums;
    ASSERT_OK(gasjet_membrane_evaluate(bag.handle.value, layout.data.data() + layout.first,
                                       bag.mesh.node_count(), layout.stride, 0.0, 0.0, nullptr, nullptr, 0,
                                       &sums));
    EXPECT_EQ(sums.strain_energy, energy);
    EXPECT_EQ(sums.gas_frequency, 0.0);
  }
}

TEST(c_contact, sphere_on_a_flat_side_is_pushed_off_with_equal_and_opposite_force) {
  const Mesh mesh = box(20, 0.4);
  const std::vector<double> mass(static_cast<std::size_t>(mesh.node_count()), 1e-4);
  Handle contact;
  ASSERT_OK(gasjet_contact_create(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                  mesh.triangle_count(), nullptr, mass.data(), 3.0, 0.1, 1e6, 0.0,
                                  &contact.value));
  std::vector<double> force(mesh.nodes.size(), 0.0);
  gasjet_contact_sums sums;
  const double centre[] = {0.2, 0.2, 0.4 + 0.1 - 0.01};
  ASSERT_OK(gasjet_contact_evaluate(contact.value, mesh.nodes.data(), mesh.node_count(), nullptr, centre,
                                    nullptr, force.data(), static_cast<int64_t>(force.size()), &sums));
  double down = 0.0;
  for (std::size_t i = 2; i < force.size(); i += 3) down += force[i];
  EXPECT_NEAR(down, -sums.force[2], 1e-12 * sums.force[2]);
  // kappa times the integral of (r - d) cos over the disc where d < r, h = 0.09 m from the plane:
  // 2 pi kappa h (r (r - h) - (r^2 - h^2)/2) = pi kappa h (r - h)^2, by quadrature points 10 mm apart.
  const double exact = std::acos(-1.0) * 1e6 * 0.09 * 1e-4;
  EXPECT_NEAR(sums.force[2], exact, 0.1 * exact);
  EXPECT_GT(sums.penetration, 0.008);
  EXPECT_GE(sums.deepest_element, 0);
  const double deep[] = {0.2, 0.2, 0.43};
  EXPECT_EQ(gasjet_contact_evaluate(contact.value, mesh.nodes.data(), mesh.node_count(), nullptr, deep,
                                    nullptr, force.data(), static_cast<int64_t>(force.size()), &sums),
            GASJET_DOMAIN);
}

TEST(c_contact, every_shape_pushes_and_a_tilted_one_turns) {
  const Mesh mesh = box(20, 0.4);
  const std::vector<double> mass(static_cast<std::size_t>(mesh.node_count()), 1e-4);
  const auto made = [&](int64_t shape, double first, double second, double third, Handle& contact) {
    const gasjet_impactor impactor{shape, {first, second, third}};
    return gasjet_contact_create_body(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                      mesh.triangle_count(), nullptr, mass.data(), 3.0, &impactor, 1e6, 0.0,
                                      &contact.value);
  };
  // Axes x, y, z of the body: a turn about y by the angle with cosine 0.8.
  const double axes[] = {0.8, 0.0, -0.6, 0.0, 1.0, 0.0, 0.6, 0.0, 0.8};
  struct Body {
    int64_t shape;
    double dimensions[3];
    double below;  // from the centre to its lowest point
    bool turns;
  };
  const Body bodies[] = {{GASJET_SPHERE, {0.1, 0.0, 0.0}, 0.1, false},
                         {GASJET_ELLIPSOID, {0.1, 0.1, 0.08}, std::hypot(0.06, 0.064), true},
                         {GASJET_CYLINDER, {0.05, 0.06, 0.0}, 0.05 + 0.048, true},
                         {GASJET_DISC, {0.06, 0.05, 0.0}, 0.05 + 0.036, true}};
  for (const Body& body : bodies) {
    Handle contact;
    ASSERT_OK(made(body.shape, body.dimensions[0], body.dimensions[1], body.dimensions[2], contact));
    std::vector<double> force(mesh.nodes.size(), 0.0);
    gasjet_contact_sums sums;
    const double centre[] = {0.2, 0.2, 0.4 + body.below - 0.01};
    ASSERT_OK(gasjet_contact_evaluate_body(contact.value, mesh.nodes.data(), mesh.node_count(), nullptr,
                                           centre, axes, nullptr, force.data(),
                                           static_cast<int64_t>(force.size()), &sums));
    double down = 0.0;
    for (std::size_t i = 2; i < force.size(); i += 3) down += force[i];
    EXPECT_NEAR(down, -sums.force[2], 1e-12 * sums.force[2]);
    EXPECT_GT(sums.penetration, 0.005);
    EXPECT_LE(sums.penetration, 0.01 + 1e-12);
    EXPECT_EQ(std::abs(sums.couple[1]) > 1e-3 * sums.force[2], body.turns) << body.shape;
  }
  Handle none, disc;
  ASSERT_OK(made(GASJET_DISC, 0.06, 0.05, 0.0, disc));
  const double skewed[] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.1, 0.0, 0.0, 1.0}, far[] = {0.0, 0.0, 5.0};
  const double spoilt[] = {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, std::nan(""), 1.0};
  std::vector<double> force(mesh.nodes.size(), 0.0);
  gasjet_contact_sums sums;
  for (const double* bad : {skewed, spoilt}) {
    EXPECT_EQ(
        gasjet_contact_evaluate_body(disc.value, mesh.nodes.data(), mesh.node_count(), nullptr, far, bad,
                                     nullptr, force.data(), static_cast<int64_t>(force.size()), &sums),
        GASJET_BAD_INPUT);
    EXPECT_NE(std::string(gasjet_last_error()).find("axes"), std::string::npos);
  }
  EXPECT_EQ(gasjet_contact_create_body(mesh.nodes.data(), mesh.node_count(), nullptr, mesh.triangles.data(),
                                       mesh.triangle_count(), nullptr, mass.data(), 3.0, nullptr, 1e6, 0.0,
                                       &none.value),
            GASJET_BAD_INPUT);
  EXPECT_EQ(made(4, 0.1, 0.1, 0.1, none), GASJET_BAD_INPUT);
  EXPECT_EQ(made(-1, 0.1, 0.1, 0.1, none), GASJET_BAD_INPUT);
  EXPECT_EQ(made(GASJET_DISC, 0.1, 0.0, 0.1, none), GASJET_BAD_INPUT);
}

TEST(c_pendulum, swing_keeps_its_energy_to_second_order) {
  const gasjet_pendulum_model model = pendulum();
  double drift[2];
  for (const int level : {0, 1}) {
    const double dt = 1e-3 / (1 << level);
    double angle = 0.5, velocity = 0.8, before = 0.0, largest = 0.0, start = 0.0;
    for (int i = 0; i < (1000 << level); ++i) {
      gasjet_pendulum_point point;
      ASSERT_OK(gasjet_pendulum_evaluate(&model, angle, velocity, &point));
      const double middle = velocity + before / 2.0 * point.gravity_moment / point.axis_inertia;
      const double energy = point.potential_energy + 0.5 * point.axis_inertia * middle * middle;
      if (i == 0) start = energy;
      largest = std::max(largest, std::abs(energy - start));
      ASSERT_OK(gasjet_pendulum_advance(&model, point.gravity_moment, before, dt, &angle, &velocity));
      before = dt;
    }
    drift[level] = largest;
  }
  EXPECT_GT(drift[0] / drift[1], 3.8);
  EXPECT_LT(drift[0] / drift[1], 4.2);
}

TEST(c_pendulum, moment_eq_lever_times_force) {
  const gasjet_pendulum_model model = pendulum();
  const double force[] = {10.0, 3.0, 0.0}, point[] = {0.0, 0.0, 0.1};
  double moment = 0.0;
  ASSERT_OK(gasjet_pendulum_moment(&model, force, point, &moment));
  EXPECT_NEAR(moment, -0.9 * 10.0, 1e-14);  // about +y, 0.9 m below the pivot
}

}  // namespace
