// SPDX-License-Identifier: Apache-2.0
// Bound of omega^2 of the assembled fabric by matrix shares of the nodal masses (M.15).
#include <Eigen/Eigenvalues>
#include <array>

#include "blocks.hpp"
#include "element.hpp"
#include "membrane/orthotropic.hpp"
#include "membrane/time_step.hpp"

namespace membrane {

namespace {

using Stiffness = Eigen::Matrix<double, 9, 9>;
using Shares = std::array<Eigen::Matrix3d, 3>;  // one block a corner

// Taut tangent in the element's frame: stresses of the three unit strains.
Eigen::Matrix3d tangent(const BagModel& model, const ElementPlace& place) {
  const ElementGroup& g = model.elements.group[place.group];
  const std::size_t k = place.lane;
  Eigen::Matrix3d d;
  for (int i = 0; i < 3; ++i) {
    const PlaneStrain<double> unit{i == 0 ? 1.0 : 0.0, i == 1 ? 1.0 : 0.0, i == 2 ? 0.5 : 0.0};
    PlaneResponse<double> r;
    if (model.woven) {
      const WeaveGroup& w = model.elements.weave[place.group];
      r = orthotropic_response<Compression::linear>(
          unit, {w.cosine[k], w.sine[k], w.warp_scale[k], g.spherical[k], g.deviator[k], w.shear[k],
                 w.series[k], w.skew[k], w.taut[k]});
    } else {
      r = isotropic_response<Compression::linear>(unit, {g.young[k], g.spherical[k], g.deviator[k]});
    }
    d.col(i) << r.s11, r.s22, r.s12;
  }
  return 0.5 * (d + d.transpose());
}

// The part of the stress that stiffens: negative principal values count as none.
Eigen::Matrix2d tension(const PlaneResponse<double>& r) {
  Eigen::Matrix2d s;
  s << r.s11, r.s12, r.s12, r.s22;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(s);
  return solver.eigenvectors() * solver.eigenvalues().cwiseMax(0.0).asDiagonal() *
         solver.eigenvectors().transpose();
}

Stiffness stiffness(const BagModel& model, const BagState& state, int element) {
  const ElementPlace place = place_of(model.elements, static_cast<std::size_t>(element));
  const ElementGroup& g = model.elements.group[place.group];
  const std::size_t k = place.lane;
  Eigen::Matrix<double, 2, 3> gradient;
  gradient.col(1) << g.gradient_b1[k], g.gradient_b2[k];
  gradient.col(2) << 0.0, g.gradient_c2[k];
  gradient.col(0) = -(gradient.col(1) + gradient.col(2));
  Eigen::Matrix<double, 3, 2> f = Eigen::Matrix<double, 3, 2>::Zero();
  for (int a = 0; a < 3; ++a)
    f += state.position.map().col(model.description.elements(a, element)) * gradient.col(a).transpose();
  Eigen::Matrix<double, 3, 9> strain;  // rows E_11, E_22, 2 E_12 of a displacement
  for (int a = 0; a < 3; ++a) {
    strain.block<1, 3>(0, 3 * a) = gradient(0, a) * f.col(0).transpose();
    strain.block<1, 3>(1, 3 * a) = gradient(1, a) * f.col(1).transpose();
    strain.block<1, 3>(2, 3 * a) =
        gradient(1, a) * f.col(0).transpose() + gradient(0, a) * f.col(1).transpose();
  }
  Stiffness result = strain.transpose() * tangent(model, place) * strain;
  const Eigen::Matrix3d geometric =
      gradient.transpose() * tension(element_response(model, state, element).response) * gradient;
  for (int a = 0; a < 3; ++a)
    for (int b = 0; b < 3; ++b) result.block<3, 3>(3 * a, 3 * b).diagonal().array() += geometric(a, b);
  return g.volume[k] * result;
}

// How much of the mass of its corners an element asks for: its diagonal blocks. The floor gives directions in
// which it is not stiff some mass too; a tenth is near the best on airbag meshes, any value above 0 is safe.
Shares demand(const Stiffness& k) {
  constexpr double floor = 0.1;
  Shares shares;
  for (int a = 0; a < 3; ++a)
    shares[static_cast<std::size_t>(a)] =
        k.block<3, 3>(3 * a, 3 * a) + floor * k.trace() / 3.0 * Eigen::Matrix3d::Identity();
  return shares;
}

Eigen::Matrix3d square_root(const Eigen::Matrix3d& m) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(m).operatorSqrt();
}

// lambda_max(M_e^-1 K_e) with M_e^-1 = root P^-1 root / m at each corner, 0 where it is fixed.
double frequency(const BagModel& model, const Stiffness& k, const Eigen::Vector3i& corner,
                 const std::vector<Eigen::Matrix3d>& root) {
  const Shares shares = demand(k);
  Stiffness mobility = Stiffness::Zero();
  for (int a = 0; a < 3; ++a) {
    const auto n = static_cast<std::size_t>(corner[a]);
    mobility.block<3, 3>(3 * a, 3 * a) = square_root(model.inverse_mass[n] * root[n] *
                                                     shares[static_cast<std::size_t>(a)].inverse() * root[n]);
  }
  return Eigen::SelfAdjointEigenSolver<Stiffness>(mobility * k * mobility, Eigen::EigenvaluesOnly)
      .eigenvalues()[8];
}

}  // namespace

double assembled_frequency(const BagModel& model, const BagState& state) {
  std::vector<Eigen::Matrix3d> root(static_cast<std::size_t>(model.node_count), Eigen::Matrix3d::Zero());
  std::vector<Stiffness> elements;
  for (int e = 0; e < model.element_count; ++e) {
    elements.push_back(stiffness(model, state, e));
    const Shares shares = demand(elements.back());
    for (int a = 0; a < 3; ++a)
      root[static_cast<std::size_t>(model.description.elements(a, e))] += shares[static_cast<std::size_t>(a)];
  }
  for (Eigen::Matrix3d& r : root) r = square_root(r);
  double largest = 0.0;
  for (int e = 0; e < model.element_count; ++e) {
    const Stiffness& k = elements[static_cast<std::size_t>(e)];
    if (k.trace() > 0.0)
      largest = std::max(largest, frequency(model, k, model.description.elements.col(e), root));
  }
  return largest;
}

}  // namespace membrane
