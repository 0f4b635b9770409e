// SPDX-License-Identifier: Apache-2.0
#include "import/case_writer.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>

#include "base/case_reader.hpp"
#include "case_blocks.hpp"
#include "case_text.hpp"

namespace driver::imported {
namespace {

std::string obj_of(const mesh::Mesh& mesh, const Eigen::Matrix3Xd& nodes) {
  std::string text;
  for (Eigen::Index n = 0; n < nodes.cols(); ++n)
    text += fmt::format("v {} {} {}\n", nodes(0, n), nodes(1, n), nodes(2, n));
  int panel = -1;
  for (Eigen::Index e = 0; e < mesh.elements.cols(); ++e) {
    const int own = mesh.panel[static_cast<std::size_t>(e)];
    if (own != panel) text += fmt::format("g {}\n", mesh.panel_names[static_cast<std::size_t>(own)]);
    panel = own;
    text += fmt::format("f {} {} {}\n", mesh.elements(0, e) + 1, mesh.elements(1, e) + 1,
                        mesh.elements(2, e) + 1);
  }
  return text;
}

std::string quoted_list(const std::vector<std::string>& names) {
  std::vector<std::string> all;
  for (const std::string& name : names) all.push_back(quoted(name));
  return fmt::format("[{}]", fmt::join(all, ", "));
}

// Factor of gravity just before or just after a time.
double factor_at(const Knots& knots, double time, bool after) {
  if (knots.empty()) return 1.0;
  const auto is_before = [&](const auto& knot) { return after ? knot[0] <= time : knot[0] < time; };
  const auto next = std::ranges::partition_point(knots, is_before);
  if (next == knots.begin()) return knots.front()[1];
  if (next == knots.end()) return knots.back()[1];
  const std::array<double, 2>& last = *std::prev(next);
  return last[1] + ((*next)[1] - last[1]) * ((time - last[0]) / ((*next)[0] - last[0]));
}

Eigen::Vector3d gravity_at(const BagDeck& bag, double time, bool after) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const BagGravity& gravity : bag.gravity) sum += factor_at(gravity.factor, time, after) * gravity.along;
  return sum;
}

// A vector if it is constant, else a row for each knot of any curve within the run, two at a jump.
void gravity_line(const BagDeck& bag, CaseText& out) {
  std::set<double> times{0.0, bag.end_time};
  for (const BagGravity& gravity : bag.gravity)
    for (const auto& knot : gravity.factor)
      if (knot[0] > 0.0 && knot[0] < bag.end_time) times.insert(knot[0]);
  std::vector<std::string> time, value;
  bool varies = false;
  const Eigen::Vector3d start = gravity_at(bag, 0.0, true);
  const auto add = [&](double at, const Eigen::Vector3d& row) {
    varies = varies || row != start;
    time.push_back(number(at));
    value.push_back(vector(row));
  };
  for (const double at : times) {
    const Eigen::Vector3d before = gravity_at(bag, at, false), after = gravity_at(bag, at, true);
    if (at > 0.0) add(at, before);
    if (at == 0.0 || (at < bag.end_time && after != before)) add(at, after);
  }
  if (varies)
    out.line("gravity",
             fmt::format("{{ time = [{}], value = [{}] }}", fmt::join(time, ", "), fmt::join(value, ", ")),
             "m/s2");
  else if (!start.isZero(0.0))
    out.line("gravity", start, "m/s2");
}

void scene_block(const BagDeck& bag, CaseText& out) {
  out.table("[scene]");
  out.line("format", "1");
  out.line("name", quoted(bag.name));
  out.line("end_time", bag.end_time, "s");
  gravity_line(bag, out);
}

std::string panel_list(const std::vector<const std::string*>& names) {
  std::vector<std::string> all;
  for (const std::string* name : names) all.push_back(*name);
  return quoted_list(all);
}

void weave_lines(const BagFabric& fabric, bool by_curves, CaseText& out) {
  if (!fabric.warp) return;
  const std::string weft =
      by_curves ? "" : fmt::format("young_modulus_weft = {}, ", number(fabric.weft_modulus));
  out.line(
      "weave",
      fmt::format("{{ {}shear_modulus = {}, warp = {} }}", weft, number(fabric.shear), vector(*fabric.warp)),
      "Pa");
}

void fabric_lines(const BagFabric& fabric, const BagDeck& bag, CaseText& out) {
  const bool by_curves = bag.law == "curve";
  if (!by_curves) {
    out.line("young_modulus", fabric.warp_modulus, "Pa");
    out.line("poisson_ratio", fabric.poisson);
  }
  out.line("density", fabric.density, "kg/m3");
  out.line("thickness", fabric.thickness, "m");
  weave_lines(fabric, by_curves, out);
  if (bag.leak != BagLeak::none) out.line("porosity", fabric.open_share);
}

bool equal(const BagFabric& a, const BagFabric& b) {
  return a.thickness == b.thickness && a.density == b.density && a.warp_modulus == b.warp_modulus &&
         a.weft_modulus == b.weft_modulus && a.poisson == b.poisson && a.shear == b.shear &&
         a.warp == b.warp && a.open_share == b.open_share;
}

// [fabric] is that of the first panel; a panel with another one has a table of its own. A weave of the base
// cannot be taken away, so an isotropic fabric is the base if there is one.
void fabric_block(const BagDeck& bag, CaseText& out) {
  const auto isotropic = std::ranges::find_if(bag.fabrics, [](const auto& f) { return !f.second.warp; });
  const BagFabric& base = isotropic != bag.fabrics.end() ? isotropic->second : bag.fabrics.begin()->second;
  out.table("[fabric]", base.source);
  out.line("law", quoted(bag.law));
  out.line("compression", bag.carries_compression ? "\"linear\"" : "\"none\"");
  out.line("leak_law", bag.leak == BagLeak::none     ? "\"none\""
                       : bag.leak == BagLeak::screen ? "\"screen\""
                                                     : "\"table\"");
  if (bag.leak == BagLeak::table)
    out.curve("velocity", bag.leak_velocity, "overpressure", "m/s", "leak_velocity");
  if (bag.law == "curve") {
    out.curve("warp_curve", bag.threads[0], "strain", "Pa", "warp");
    out.curve("weft_curve", bag.threads[1], "strain", "Pa", "weft");
  }
  fabric_lines(base, bag, out);
  std::vector<std::pair<const BagFabric*, std::vector<const std::string*>>> others;
  for (const auto& [panel, own] : bag.fabrics) {
    const BagFabric& fabric = own;
    if (equal(fabric, base)) continue;
    const auto found =
        std::ranges::find_if(others, [&](const auto& other) { return equal(*other.first, fabric); });
    if (found != others.end())
      found->second.push_back(&panel);
    else
      others.push_back({&fabric, {&panel}});
  }
  for (const auto& [fabric, panels] : others) {
    out.table("[[fabric.panel]]", fabric->source);
    out.line("panels", panel_list(panels));
    fabric_lines(*fabric, bag, out);
  }
}

std::string numbers_of(const std::vector<long>& nodes, const BagSurface& surface) {
  std::vector<int> numbers;
  for (const long node : nodes)
    if (const auto found = surface.index.find(node); found != surface.index.end())
      numbers.push_back(found->second + 1);
  std::ranges::sort(numbers);
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers.empty() ? std::string() : fmt::format("[{}]", fmt::join(numbers, ", "));
}

void membrane_block(const BagDeck& bag, const BagSurface& surface, CaseText& out) {
  out.table("[membrane]");
  const bool starts_elsewhere = surface.reference.has_value();
  out.line("mesh", starts_elsewhere ? "{ file = \"bag.obj\", initial_file = \"bag_start.obj\" }"
                                    : "{ file = \"bag.obj\" }");
  std::vector<std::string> nulls = surface.caps;
  for (const std::string& name : bag.null_panels)
    if (std::ranges::find(surface.mesh.panel_names, name) != surface.mesh.panel_names.end())
      nulls.push_back(name);
  if (!nulls.empty()) out.line("null_panels", quoted_list(nulls));
  std::vector<long> fixed;
  for (const BagSupport& support : bag.held.supports)
    if (support.along[0] && support.along[1] && support.along[2])
      fixed.insert(fixed.end(), support.nodes.begin(), support.nodes.end());
  if (const auto numbers = numbers_of(fixed, surface); !numbers.empty()) out.line("fixed_nodes", numbers);
  if (bag.held.mass_damping > 0.0) out.line("mass_damping", bag.held.mass_damping, "1/s");
  if (bag.held.stiffness_damping > 0.0) out.line("stiffness_damping", bag.held.stiffness_damping, "s");
  for (const BagSupport& support : bag.held.supports) {
    if (support.along[0] && support.along[1] && support.along[2]) continue;
    const auto numbers = numbers_of(support.nodes, surface);
    std::vector<std::string> axes;
    for (std::size_t axis = 0; axis < 3; ++axis)
      if (support.along[axis]) axes.emplace_back(1, "xyz"[axis]);
    if (numbers.empty() || axes.empty()) continue;
    out.table("[[membrane.roller]]");
    out.line("nodes", numbers);
    out.line("directions", quoted_list(axes));
  }
  for (const BagStrap& strap : bag.held.straps) {
    out.table("[[membrane.strap]]", strap.source);
    out.line("from_node", fmt::format("{}", surface.index.at(strap.from) + 1));
    out.line("to_node", fmt::format("{}", surface.index.at(strap.to) + 1));
    out.line("stiffness", strap.stiffness, "N/m");
    out.line("free_length", strap.free_length, "m");
  }
  if (bag.held.wall) {
    out.table("[membrane.plate]", bag.held.wall->source);
    out.line("point", bag.held.wall->point, "m");
    out.line("normal", bag.held.wall->normal);
  }
  if (bag.held.layer_thickness > 0.0) {
    out.table("[membrane.self_contact]");
    out.line("thickness", bag.held.layer_thickness, "m");
    if (bag.held.layer_friction > 0.0) out.line("friction", bag.held.layer_friction);
  }
}

}  // namespace

std::string plain_name(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_';
    if (plain || (!name.empty() && name.back() != '_')) name += plain ? c : '_';
  }
  while (name.ends_with('_')) name.pop_back();
  return name;
}

DeckFiles write_case(const BagDeck& bag, const BagSurface& surface, const std::string& name,
                     const std::string& deck) {
  CaseText out;
  out.remark("Made of the deck " + deck + ". import.md says what became of each of its cards.");
  scene_block(bag, out);
  gas_blocks(bag, out);
  fabric_block(bag, out);
  membrane_block(bag, surface, out);
  if (bag.history_every) {
    out.table("[output]");
    out.line("history_every", *bag.history_every, "s");
  }
  DeckFiles files{{name + ".toml", out.text()}};
  const mesh::Mesh& mesh = surface.mesh;
  files.emplace_back("bag.obj", obj_of(mesh, surface.reference ? *surface.reference : mesh.nodes));
  if (surface.reference) files.emplace_back("bag_start.obj", obj_of(mesh, mesh.nodes));
  files.insert(files.end(), out.files().begin(), out.files().end());
  return files;
}

}  // namespace driver::imported
