// SPDX-License-Identifier: Apache-2.0
// Fabric by measured curves of warp and weft (M.30), (M.31).
#include "membrane/yarns.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "claim.hpp"
#include "dense.hpp"
#include "energy_derivative.hpp"
#include "membrane/error.hpp"

using membrane::Compression;

namespace {

// Stiffening and softening, with the end far out.
const membrane::StressCurve kWarpCurve{{0.0, 0.02, 0.05, 0.3, 0.6}, {0.0, 4e5, 2e6, 2e7, 3e7}};
const membrane::StressCurve kWeftCurve{{0.0, 0.1, 0.6}, {0.0, 5e6, 1e7}};

membrane::BagDescription describe_yarns(const mesh::Mesh& mesh,
                                        const Eigen::Vector3d& warp = {0.3, 0.5, 0.8}) {
  auto d = scenes::describe(mesh, Compression::none);
  d.law = "curve";
  d.curves = {kWarpCurve, kWeftCurve};
  for (auto& p : d.properties) {
    p = {.thickness = 0.5e-3, .density = 620.0};
    p.weave = membrane::WeaveProperties{.shear = 2e6, .warp = warp};
  }
  return d;
}

double stress_at(const membrane::StressCurve& c, double strain) {
  if (strain <= 0.0) return 0.0;
  const auto i = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
      std::ranges::upper_bound(c.strain, strain) - c.strain.begin(), 1, std::ssize(c.strain) - 1));
  return c.stress[i - 1] +
         (c.stress[i] - c.stress[i - 1]) * (strain - c.strain[i - 1]) / (c.strain[i] - c.strain[i - 1]);
}

// By trapezia between the points.
double work_to(const membrane::StressCurve& c, double strain) {
  double work = 0.0, last = 0.0;
  for (const double point : c.strain) {
    const double next = std::min(point, strain);
    if (next <= last) continue;
    work += 0.5 * (next - last) * (stress_at(c, next) + stress_at(c, last));
    last = next;
  }
  return work;
}

mesh::Mesh lone_square() {
  return mesh::rectangle(1, 1, 0.1, 0.1, mesh::Diagonals::uniform);
}

// Of a square with the warp along x, stretched along x and y.
membrane::PlaneResponse<double> stretched(double x, double y) {
  const auto mesh = lone_square();
  const auto model = make_model(describe_yarns(mesh, Eigen::Vector3d::UnitX()));
  Eigen::Matrix3Xd at = mesh.nodes;
  at.row(0) *= 1.0 + x;
  at.row(1) *= 1.0 + y;
  return element_response(model, membrane::make_state(model, at), 0).response;
}

}  // namespace

// The element's first side runs along x: s11 is along the warp. A strip's own data, at points and between.
TEST(Yarns, strip_gives_back_the_curve_and_its_integral) {
  for (const double strain : {-0.2, 0.0, 1e-9, 0.01, 0.02, 0.035, 0.05, 0.2, 0.3, 0.45, 0.6})
    for (const bool along_warp : {true, false}) {
      const auto& curve = along_warp ? kWarpCurve : kWeftCurve;
      const auto r = along_warp ? stretched(strain, -0.1) : stretched(-0.1, strain);
      const double along = along_warp ? r.s11 : r.s22, across = along_warp ? r.s22 : r.s11;
      // Rounding of the strain, eps, by the steepest slope.
      claim::expect_near(
          {"M.30", "strip by a measured curve: nominal stress [Pa]", "rounding of the stretch"},
          along * (1.0 + strain), stress_at(curve, strain), 100 * scenes::kEps * 1e8);
      EXPECT_NEAR(r.energy_density, work_to(curve, strain), 100 * scenes::kEps * 3e7) << strain;
      EXPECT_EQ(across, 0.0);
    }
}

TEST(Yarns, force_eq_minus_energy_derivative) {
  const auto mesh = mesh::icosphere(0.3, 1);
  for (const double swelling : {0.9, 1.0, 1.05, 1.2})
    scenes::expect_force_eq_minus_energy_derivative(make_model(describe_yarns(mesh)),
                                                    scenes::shaken(swelling * mesh.nodes, 0.02, 8));
}

TEST(Yarns, forces_turn_with_the_bag) {
  const auto mesh = mesh::icosphere(0.3, 1);
  const auto model = make_model(describe_yarns(mesh));
  const Eigen::Matrix3Xd x = scenes::shaken(1.05 * mesh.nodes, 0.02, 8);
  const Eigen::Matrix3d turn = scenes::rotation();
  const Eigen::Matrix3Xd force = scenes::evaluated(model, x).membrane_force.map();
  const Eigen::Matrix3Xd turned = scenes::evaluated(model, turn * x).membrane_force.map();
  EXPECT_LE((turned - turn * force).cwiseAbs().maxCoeff(), 100 * scenes::kEps * 4e4);  // 7.2e7 Pa x 0.5 mm
}

TEST(Yarns, every_instruction_set_gives_the_same_bits) {
  const auto mesh = mesh::icosphere(0.3, 1);
  auto d = describe_yarns(mesh);
  const Eigen::Matrix3Xd x = scenes::shaken(1.05 * mesh.nodes, 0.03, 4);
  scenes::expect_same_bits(d, x);
}

// (M.31): random states of single elements, along curves that stiffen and soften.
TEST(Yarns, dense_eigenvalue_below_bound) {
  scenes::Random random(21);
  double closest = 0.0;
  for (int trial = 0; trial < 200; ++trial) {
    const auto mesh = lone_square();
    const auto model = make_model(describe_yarns(mesh, Eigen::Vector3d(random(), random(), 0.0)));
    Eigen::Matrix3d f = (1.1 + 0.12 * random()) * Eigen::Matrix3d::Identity();
    for (int i = 0; i < 9; ++i) f(i % 3, i / 3) += 0.12 * random();
    const Eigen::Matrix3Xd x = scenes::rotation() * f * mesh.nodes;
    const double bound = scenes::evaluated(model, x).forces.element_frequency;
    const double exact = scenes::greatest_frequency(
        model, x, [&](const Eigen::Matrix3Xd& at) { return scenes::membrane_force(model, at); }, 1e-9);
    EXPECT_LE(exact, bound * (1.0 + 1e-5)) << trial;
    closest = std::max(closest, exact / bound);
  }
  EXPECT_GT(closest, 0.3);  // the steepest piece of both curves is seldom met at once
}

TEST(Yarns, beyond_the_last_point_there_is_no_stress) {
  const auto mesh = lone_square();
  const auto model = make_model(describe_yarns(mesh, Eigen::Vector3d::UnitX()));
  Eigen::Matrix3Xd at = mesh.nodes;
  at.row(1) *= 1.61;
  try {
    scenes::evaluated(model, at);
    FAIL() << "accepted";
  } catch (const membrane::MembraneError& error) {
    EXPECT_NE(std::string(error.what()).find("beyond the last point of its curve"), std::string::npos);
  }
}

TEST(Yarns, faults_of_curves_are_refused) {
  const auto message = [](auto&& change) -> std::string {
    auto d = describe_yarns(lone_square());
    change(d);
    try {
      make_model(d);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "accepted";
  };
  const auto says = [&](auto&& change, const char* text) {
    EXPECT_NE(message(change).find(text), std::string::npos) << message(change);
  };
  says([](auto&) {}, "accepted");
  says([](auto& d) { d.curves[0] = {{0.0}, {0.0}}; }, "curve of the warp: points = 1");
  says([](auto& d) { d.curves[1].stress.pop_back(); }, "curve of the weft: stresses");
  says([](auto& d) { d.curves[0].strain[0] = 0.01; }, "first point is (0.01, 0)");
  says([](auto& d) { d.curves[0].stress[0] = 1.0; }, "first point is (0, 1)");
  says([](auto& d) { d.curves[0].stress[2] = 1e5; }, "stress 100000 follows");
  says([](auto& d) { d.curves[0].strain[2] = 0.02; }, "strain 0.02 follows 0.02");
  says([](auto& d) { d.curves[0].stress[2] = std::nan(""); }, "stress = nan");
  says([](auto& d) { d.curves[0].strain.assign(65, 0.0), d.curves[0].stress.assign(65, 0.0); },
       "points = 65");
  says([](auto& d) { d.properties[1].weave.reset(); }, "element 1: the law \"curve\" needs a weave");
  says([](auto& d) { d.properties[1].weave->shear = 0.0; }, "element 1: shear");
  says([](auto& d) { d.compression = Compression::linear; }, "carries no compression");
}
