// SPDX-License-Identifier: Apache-2.0
#include "import/bag_surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "mesh/surface_check.hpp"
#include "mesh/turn_outward.hpp"
#include "surface_edges.hpp"

namespace driver::imported {
namespace {

/// Builds the surface step by step.
class SurfaceBuilder {
 public:
  SurfaceBuilder(const BagDeck& bag, const DeckCard& card, ImportReport& report)
      : bag_(bag), card_(card), report_(report) {}
  std::optional<BagSurface> build();

 private:
  std::set<std::string> meshed_nulls() const;
  bool take_facets();
  bool split();
  void put_elements();
  bool close_holes();
  double close(const std::vector<int>& rim, double fabric);
  bool is_sound();
  void place_reference();
  int index_of(long node);
  int panel_of(const std::string& name);
  bool fail(const std::string& what) {
    report_.refuse(card_, what);
    return false;
  }
  std::string at(int node) const {
    const Eigen::Vector3d& x = places_[static_cast<std::size_t>(node)];
    return fmt::format("({:.3g}, {:.3g}, {:.3g}) m", x.x(), x.y(), x.z());
  }

  const BagDeck& bag_;
  const DeckCard& card_;
  ImportReport& report_;
  BagSurface surface_;
  std::vector<Eigen::Vector3d> places_;  // of the nodes that the surface has
  std::vector<Polygon> polygons_;
  bool closed_by_deck_ = false;  // by null panels that caps replace
  std::vector<std::array<int, 3>> triangles_;
};

int SurfaceBuilder::index_of(long node) {
  const auto [found, is_new] = surface_.index.try_emplace(node, static_cast<int>(places_.size()));
  if (is_new) {
    places_.push_back(bag_.nodes.at(node));
    surface_.numbers.push_back(node);
  }
  return found->second;
}

int SurfaceBuilder::panel_of(const std::string& name) {
  auto& names = surface_.mesh.panel_names;
  const auto found = std::ranges::find(names, name);
  if (found != names.end()) return static_cast<int>(found - names.begin());
  names.push_back(name);
  return static_cast<int>(names.size()) - 1;
}

// Null panels of the deck that have nodes inside, where no fabric would hold them: caps on their rims replace
// them.
std::set<std::string> SurfaceBuilder::meshed_nulls() const {
  std::map<std::string, std::set<long>> of_null;
  std::set<long> of_fabric;
  for (const Facet& facet : bag_.facets) {
    const bool is_null = std::ranges::find(bag_.null_panels, facet.panel) != bag_.null_panels.end();
    (is_null ? of_null[facet.panel] : of_fabric).insert(facet.nodes.begin(), facet.nodes.end());
  }
  std::set<std::string> meshed;
  for (const auto& [panel, nodes] : of_null)
    if (!std::ranges::includes(of_fabric, nodes)) meshed.insert(panel);
  return meshed;
}

bool SurfaceBuilder::take_facets() {
  const auto meshed = meshed_nulls();
  for (const std::string& panel : meshed)
    report_.note(fmt::format(
        "the null panel {} has nodes inside: caps on the nodes of its rim close the volume instead", panel));
  closed_by_deck_ = !meshed.empty();
  int collapsed = 0, repeated = 0;
  std::set<std::vector<int>> seen;
  for (const Facet& facet : bag_.facets) {
    if (meshed.contains(facet.panel)) continue;
    Polygon polygon{{}, 0};
    for (const long node : facet.nodes) {
      if (!bag_.nodes.contains(node)) {
        report_.refuse("node", facet.at,
                       fmt::format("an element has node {}, which the deck does not have", node));
        return false;
      }
      const int index = index_of(node);
      if (std::ranges::find(polygon.corners, index) == polygon.corners.end())
        polygon.corners.push_back(index);
    }
    if (polygon.corners.size() < 3) {
      ++collapsed;
      continue;
    }
    std::vector<int> sorted = polygon.corners;
    std::ranges::sort(sorted);
    if (!seen.insert(std::move(sorted)).second) {
      ++repeated;
      continue;
    }
    polygon.panel = panel_of(facet.panel);
    polygons_.push_back(std::move(polygon));
  }
  if (collapsed > 0)
    report_.note(fmt::format("{} elements with fewer than three different nodes are left out", collapsed));
  if (repeated > 0)
    report_.note(fmt::format(
        "{} elements between the nodes of another one are left out: the bag is one layer there", repeated));
  return !polygons_.empty() || fail("the control volume has no shells or segments in this deck");
}

bool SurfaceBuilder::split() {
  const int joined = join_hanging_nodes(places_, polygons_);
  if (joined > 0)
    report_.note(
        fmt::format("{} nodes lie on edges of larger elements, as adaptivity leaves them: these elements are "
                    "cut so that all nodes are tied",
                    joined));
  const auto reference = [&](int node) {
    const auto found = bag_.reference.find(surface_.numbers[static_cast<std::size_t>(node)]);
    return found != bag_.reference.end() ? found->second : places_[static_cast<std::size_t>(node)];
  };
  Sides sides(polygons_);
  for (const Polygon& polygon : polygons_) {
    const auto pieces = pieces_of(polygon, reference, sides);
    if (pieces.empty())
      return fail(fmt::format("an element with {} corners at {} has no area or crosses itself",
                              polygon.corners.size(), at(polygon.corners.front())));
    for (const auto& piece : pieces) {
      triangles_.push_back(piece);
      surface_.mesh.panel.push_back(polygon.panel);
    }
  }
  surface_.mesh.nodes.resize(3, static_cast<Eigen::Index>(places_.size()));
  for (std::size_t i = 0; i < places_.size(); ++i)
    surface_.mesh.nodes.col(static_cast<Eigen::Index>(i)) = places_[i];
  put_elements();
  return true;
}

void SurfaceBuilder::put_elements() {
  surface_.mesh.elements.resize(3, static_cast<Eigen::Index>(triangles_.size()));
  for (std::size_t e = 0; e < triangles_.size(); ++e)
    for (int i = 0; i < 3; ++i)
      surface_.mesh.elements(i, static_cast<Eigen::Index>(e)) = triangles_[e][static_cast<std::size_t>(i)];
}

bool SurfaceBuilder::close_holes() {
  mesh::Mesh& mesh = surface_.mesh;
  const int turned = mesh::turn_outward(mesh);
  if (turned > 0)
    report_.note(fmt::format("{} of {} elements are turned outward", turned, mesh.element_count()));
  for (std::size_t e = 0; e < triangles_.size(); ++e)
    for (int i = 0; i < 3; ++i)
      triangles_[e][static_cast<std::size_t>(i)] = mesh.elements(i, static_cast<Eigen::Index>(e));
  const Rims found = rims_of(mesh.elements);
  if (found.seams > 0)
    return fail(
        fmt::format("the control volume has {} edges with more than two elements, as seams between chambers "
                    "or tethers make them, which have no counterpart",
                    found.seams));
  if (!found.shared.empty())
    return fail(
        fmt::format("the control volume has holes that meet at {} nodes, the first at {}, so that their rims "
                    "cannot be told "
                    "apart; close them by shells or segments",
                    found.shared.size(), at(found.shared.front())));
  const double fabric = mesh::element_areas(mesh.nodes, mesh.elements).sum();
  double closed = 0.0;
  for (const auto& rim : found.rims) {
    const double area = close(rim, fabric);
    if (area == 0.0) return false;
    closed += area;
  }
  constexpr double most = 0.5;  // of the fabric's area, as of a hemisphere; a flat sheet has 1
  if (closed > most * fabric && !closed_by_deck_)
    return fail(
        fmt::format("the control volume is open: its {} holes have {:.3g} m2, {:.2g} of the fabric's area, "
                    "allowed: {:g}; close it by shells or segments",
                    found.rims.size(), closed, closed / fabric, most));
  put_elements();
  return true;
}

// Adds a cap; returns its area [m2], 0 if there is none.
double SurfaceBuilder::close(const std::vector<int>& rim, double fabric) {
  std::vector<Eigen::Vector3d> corners;
  for (const int node : rim) corners.push_back(places_[static_cast<std::size_t>(node)]);
  Eigen::Vector3d twice = Eigen::Vector3d::Zero();  // the area, as a vector
  double perimeter = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Eigen::Vector3d& next = corners[(i + 1) % corners.size()];
    twice += (corners[i] - corners[0]).cross(next - corners[0]);
    perimeter += (next - corners[i]).norm();
  }
  constexpr double slit = 1e-6;  // area over the square of the perimeter: what six digits of a deck leave
  if (twice.norm() <= slit * perimeter * perimeter) {
    fail(
        fmt::format("the control volume has a slit with {} nodes at {}, whose sides lie on each other; join "
                    "them in the deck",
                    rim.size(), at(rim.front())));
    return 0.0;
  }
  constexpr std::size_t most_nodes = 2000;
  const auto pieces = rim.size() > most_nodes ? std::vector<std::array<int, 3>>{} : triangles_of(corners);
  if (pieces.empty()) {
    fail(fmt::format(
        "the control volume has a hole with {} nodes at its rim, at {}, that no flat cap closes; close it by "
        "shells or segments",
        rim.size(), at(rim.front())));
    return 0.0;
  }
  const auto place = [&](int i) -> const Eigen::Vector3d& { return corners[static_cast<std::size_t>(i)]; };
  double area = 0.0;
  for (const auto& [a, b, c] : pieces) area += 0.5 * (place(b) - place(a)).cross(place(c) - place(a)).norm();
  const std::string name = fmt::format("cap_{}", surface_.caps.size() + 1);
  for (const auto& [a, b, c] : pieces) {
    const auto corner = [&](int i) { return rim[static_cast<std::size_t>(i)]; };
    triangles_.push_back({corner(a), corner(b), corner(c)});
    surface_.mesh.panel.push_back(panel_of(name));
  }
  surface_.caps.push_back(name);
  report_.note(fmt::format(
      "a hole with {} nodes at its rim, at {}, is closed by the null panel {} of {:.3g} m2, {:.2g} of the "
      "fabric's area{}",
      rim.size(), at(rim.front()), name, area, area / fabric,
      closed_by_deck_
          ? ", in place of what the deck has there"
          : ": the deck has nothing there, so its volume is that of an open surface, and no pressure acts on "
            "the opening"));
  return area;
}

bool SurfaceBuilder::is_sound() {
  mesh::turn_outward(surface_.mesh);
  const auto faults = mesh::check_closed_surface(surface_.mesh.nodes, surface_.mesh.elements);
  if (faults.ok()) return true;
  if (faults.components.size() > 1)
    return fail(fmt::format("the control volume has {} separate surfaces, allowed: one closed surface",
                            faults.components.size()));
  std::string text = faults.describe();
  while (text.ends_with('\n')) text.pop_back();
  std::ranges::replace(text, '\n', ';');
  return fail("the control volume is not one closed surface: " + text);
}

void SurfaceBuilder::place_reference() {
  if (bag_.reference.empty()) return;
  Eigen::Matrix3Xd reference = surface_.mesh.nodes;
  for (std::size_t i = 0; i < surface_.numbers.size(); ++i)
    if (const auto found = bag_.reference.find(surface_.numbers[i]); found != bag_.reference.end())
      reference.col(static_cast<Eigen::Index>(i)) = found->second;
  if (reference != surface_.mesh.nodes) surface_.reference = std::move(reference);
}

std::optional<BagSurface> SurfaceBuilder::build() {
  if (!take_facets() || !split() || !close_holes() || !is_sound()) return std::nullopt;
  place_reference();
  return std::move(surface_);
}

}  // namespace

std::optional<BagSurface> surface_of(const BagDeck& bag, const DeckCard& card, ImportReport& report) {
  return SurfaceBuilder(bag, card, report).build();
}

}  // namespace driver::imported
