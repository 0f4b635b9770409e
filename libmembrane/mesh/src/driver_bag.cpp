// SPDX-License-Identifier: Apache-2.0
#include "mesh/driver_bag.hpp"

#include <cmath>
#include <elementary/trigonometric.hpp>
#include <numbers>
#include <vector>

#include "checks.hpp"

namespace mesh {
namespace {

void require(bool allowed, const char* field, double value, const char* range) {
  if (!allowed) reject("driver_bag", field, value, range);
}

const DriverBagOptions& checked(const DriverBagOptions& o) {
  constexpr double longest = 1e6;  // [m] so that squares stay finite
  require(o.radius > 0.0 && o.radius <= longest, "radius", o.radius, "above 0, at most 1e6");
  require(o.inflator_radius > 0.0 && o.inflator_radius < o.radius, "inflator_radius", o.inflator_radius,
          "above 0 and below radius");
  require(o.opening > 0.0 && o.opening < o.radius - o.inflator_radius, "opening", o.opening,
          "above 0 and below radius - inflator_radius");
  require(o.rings >= 4 && o.rings <= 100, "rings", o.rings, "4 to 100");
  require(o.inflator_rings >= 1 && o.inflator_rings <= o.rings - 3, "inflator_rings", o.inflator_rings,
          "1 to rings - 3");
  require(o.vents >= 0 && o.vents <= 2, "vents", o.vents, "0 to 2");
  if (o.vents > 0)
    require(o.vent_ring > o.inflator_rings && o.vent_ring < o.rings - 1, "vent_ring", o.vent_ring,
            "above inflator_rings and below rings - 1");
  return o;
}

// A disc of rings with 6 k nodes in ring k, counter-clockwise seen from +x, beginning above the middle.
class DriverBagBuilder {
  enum Panel { kFront, kBack, kAttachment, kVentLeft, kVentRight, kPanelCount };

 public:
  explicit DriverBagBuilder(const DriverBagOptions& options)
      : o_(options), disc_(1 + 3 * o_.rings * (o_.rings + 1)) {
    for (int sector = 0; sector < 6; ++sector)
      for (int ring = 0; ring < o_.rings; ++ring) add_cells(sector, ring);
  }

  DriverBag build() const {
    DriverBag bag;
    bag.mesh.panel_names = {"front", "back", "attachment"};
    if (o_.vents > 0) bag.mesh.panel_names.emplace_back(o_.vents == 2 ? "vent_left" : "vent_right");
    if (o_.vents == 2) bag.mesh.panel_names.emplace_back("vent_right");
    set_elements(bag.mesh);
    set_nodes(bag);
    for (int i = 0; i < 3; ++i) {
      const int along = 2 * o_.inflator_rings * i;
      bag.tether_anchors[static_cast<std::size_t>(i)] = {back(o_.inflator_rings, along),
                                                         front(o_.inflator_rings, along)};
    }
    return bag;
  }

 private:
  static int first_of(int ring) { return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1); }
  int front(int ring, int along) const { return ring == 0 ? 0 : first_of(ring) + along % (6 * ring); }
  int back(int ring, int along) const {
    return ring == o_.rings ? front(ring, along) : disc_ + front(ring, along);  // the rim is shared
  }

  // The elements between two rings in a sixth of the disc, alternately pointing in and out.
  void add_cells(int sector, int ring) {
    for (int place = 0; place <= 2 * ring; ++place) {
      const int inner = sector * ring + place / 2, outer = sector * (ring + 1) + (place + 1) / 2;
      const bool pointing_in = place % 2 == 0;
      const auto corners = [&](const auto& node) {
        return pointing_in
                   ? Eigen::Vector3i(node(ring, inner), node(ring + 1, outer), node(ring + 1, outer + 1))
                   : Eigen::Vector3i(node(ring, inner), node(ring + 1, outer), node(ring, inner + 1));
      };
      panels_[kFront].push_back(corners([&](int r, int j) { return front(r, j); }));
      const Eigen::Vector3i b = corners([&](int r, int j) { return back(r, j); });
      panels_[static_cast<std::size_t>(back_panel(sector, ring, place))].emplace_back(b[0], b[2], b[1]);
    }
  }

  // Vents: four neighbours in the middle of the sectors at +-y, mirror images of each other.
  Panel back_panel(int sector, int ring, int place) const {
    if (ring < o_.inflator_rings) return kAttachment;
    const int first = 2 * ((ring - 1) / 2);
    const auto inside = [&](int p) { return ring == o_.vent_ring && p >= first && p < first + 4; };
    if (o_.vents > 0 && sector == 4 && inside(place)) return kVentRight;
    if (o_.vents > 1 && sector == 1 && inside(2 * ring - place)) return kVentLeft;
    return kBack;
  }

  void set_elements(Mesh& mesh) const {
    std::vector<Eigen::Vector3i> all;
    int panel = 0;
    for (const auto& elements : panels_) {
      if (elements.empty()) continue;
      all.insert(all.end(), elements.begin(), elements.end());
      mesh.panel.insert(mesh.panel.end(), elements.size(), panel++);
    }
    mesh.elements.resize(3, static_cast<Eigen::Index>(all.size()));
    for (std::size_t e = 0; e < all.size(); ++e) mesh.elements.col(static_cast<Eigen::Index>(e)) = all[e];
  }

  double ring_radius(int ring) const {
    if (ring <= o_.inflator_rings) return o_.inflator_radius * ring / o_.inflator_rings;
    return o_.inflator_radius +
           (o_.radius - o_.inflator_radius) * (ring - o_.inflator_rings) / (o_.rings - o_.inflator_rings);
  }

  void set_nodes(DriverBag& bag) const {
    bag.mesh.nodes.setZero(3, disc_ + first_of(o_.rings));
    bag.opened = bag.mesh.nodes;
    const double slope = 0.5 * o_.opening / (o_.radius - o_.inflator_radius);  // sine of the cones' angle
    for (int ring = 0; ring <= o_.rings; ++ring)
      for (int along = 0; along < (ring == 0 ? 1 : 6 * ring); ++along) {
        const double angle = ring == 0 ? 0.0 : std::numbers::pi * along / (3 * ring);
        const Eigen::Vector3d direction(0.0, -elementary::sin(angle), elementary::cos(angle));
        const double radius = ring_radius(ring), on_cone = std::max(radius - o_.inflator_radius, 0.0);
        const Eigen::Vector3d flat = radius * direction;
        Eigen::Vector3d bent = (radius - on_cone + on_cone * std::sqrt(1.0 - slope * slope)) * direction;
        bent.x() = slope * on_cone;
        for (const int node : {back(ring, along), front(ring, along)}) {
          bag.mesh.nodes.col(node) = flat;
          bag.opened.col(node) = bent;
          bent.x() = o_.opening - bent.x();
        }
      }
  }

  DriverBagOptions o_;
  int disc_;  // nodes of one disc
  std::array<std::vector<Eigen::Vector3i>, kPanelCount> panels_;
};

}  // namespace

DriverBag driver_bag(const DriverBagOptions& options) {
  return DriverBagBuilder(checked(options)).build();
}

}  // namespace mesh
