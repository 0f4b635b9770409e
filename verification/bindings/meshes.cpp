// SPDX-License-Identifier: Apache-2.0
#include "meshes.hpp"

#include <algorithm>
#include <iterator>
#include <map>

namespace border_test {
namespace {

/// Adds one side: corner + i u + j v, seen from outside u, v run counter-clockwise.
class BoxBuilder {
 public:
  BoxBuilder(int n, double size, double low) : n_(n), size_(size), low_(low) {}
  void side(const std::array<int, 3>& corner, const std::array<int, 3>& u, const std::array<int, 3>& v) {
    for (int i = 0; i < n_; ++i)
      for (int j = 0; j < n_; ++j) {
        const auto at = [&](int a, int b) {
          std::array<int, 3> place{};
          for (std::size_t k = 0; k < 3; ++k) place[k] = n_ * corner[k] + (i + a) * u[k] + (j + b) * v[k];
          return node(place);
        };
        const int32_t a = at(0, 0), b = at(1, 0), c = at(1, 1), d = at(0, 1);
        mesh_.triangles.insert(mesh_.triangles.end(), {a, b, c, a, c, d});
      }
  }
  Mesh mesh() { return std::move(mesh_); }

 private:
  int32_t node(const std::array<int, 3>& place) {
    const auto [found, is_new] = numbers_.emplace(place, static_cast<int32_t>(numbers_.size()));
    if (is_new)
      for (const int k : place) mesh_.nodes.push_back(low_ + size_ * k / n_);
    return found->second;
  }
  int n_;
  double size_, low_;
  Mesh mesh_;
  std::map<std::array<int, 3>, int32_t> numbers_;
};

}  // namespace

Mesh box(int n, double size, double low) {
  BoxBuilder builder(n, size, low);
  const std::array<int, 3> x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o{0, 0, 0};
  builder.side(o, y, x);  // below
  builder.side(z, x, y);  // above
  builder.side(o, x, z);  // front
  builder.side(y, z, x);  // back
  builder.side(o, z, y);  // left
  builder.side(x, y, z);  // right
  return builder.mesh();
}

std::vector<Layout> layouts_of(const std::vector<double>& rows) {
  const auto count = static_cast<std::ptrdiff_t>(rows.size() / 3);
  const auto make = [&](std::ptrdiff_t size, std::ptrdiff_t first, int64_t row, int64_t component) {
    Layout layout{std::vector<double>(static_cast<std::size_t>(size), kNan), first, {row, component}};
    for (std::ptrdiff_t i = 0; i < count; ++i)
      for (std::ptrdiff_t k = 0; k < 3; ++k)
        layout.data[static_cast<std::size_t>(first + i * row + k * component)] =
            rows[static_cast<std::size_t>(3 * i + k)];
    return layout;
  };
  return {make(3 * count, 0, 3, 1), make(4 * count, 0, 4, 1),
          make(3 * count, 0, 1, count),  // Fortran order of (n, 3)
          make(12 * count, 1, 12, 2), make(3 * count, 3 * (count - 1), -3, 1)};
}

gasjet_jet_model round_jet() {
  gasjet_jet_model model;
  EXPECT_EQ(gasjet_jet_defaults(&model), GASJET_OK);
  for (int i = 0; i < 3; ++i) model.centre[i] = 0.0, model.axis[i] = i == 0 ? 1.0 : 0.0;
  model.radius = 0.02;
  model.decay_coefficient = 0.08;
  return model;
}

gasjet_pendulum_model pendulum() {
  return {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, -1.0}, 5.0, 0.3, 0.7, 0.9, 0.08, {0.0, 0.0, -9.81}};
}

gasjet_rigid_body_model tumbling_body() {
  gasjet_rigid_body_model model;
  EXPECT_OK(gasjet_rigid_body_defaults(&model));
  model.mass = 4.5;
  for (int i = 0; i < 3; ++i) model.centre[i] = 0.1 * i;
  model.velocity[0] = 3.0;
  model.gravity[2] = -9.80665;
  model.angular_velocity[0] = 20.0;
  model.angular_velocity[2] = 30.0;
  // Axes turned about y by the angle of cosine 0.8; the principal ones by that of 0.6 about the body's z.
  const double axes[] = {0.8, 0.0, -0.6, 0.0, 1.0, 0.0, 0.6, 0.0, 0.8};
  std::copy(std::begin(axes), std::end(axes), model.axes);
  model.inertia[0] = 0.36 * 0.016 + 0.64 * 0.021;
  model.inertia[4] = 0.64 * 0.016 + 0.36 * 0.021;
  model.inertia[1] = model.inertia[3] = 0.48 * (0.016 - 0.021);
  model.inertia[8] = 0.026;
  return model;
}

gasjet_rigid_body_model guided_body() {
  gasjet_rigid_body_model model;
  EXPECT_OK(gasjet_rigid_body_defaults(&model));
  model.motion = GASJET_ON_RAIL;
  model.mass = 6.8;
  for (int i = 0; i < 3; ++i) model.centre[i] = 0.1 * i;
  model.velocity[0] = -9.0;
  model.gravity[0] = -4.0;
  model.gravity[2] = -9.0;
  model.direction[0] = -2.0;
  model.springs[0] = {30e3, 120.0, 0.01, 0};
  model.springs[2] = {2e5, 50.0, 0.1, 1};
  return model;
}

}  // namespace border_test
