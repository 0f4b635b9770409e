// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <numbers>

#include "commands.hpp"
#include "driver/case_reader.hpp"
#include "driver/results.hpp"
#include "membrane/obj.hpp"
#include "membrane/passenger_bag.hpp"
#include "membrane/surface_check.hpp"

namespace driver::commands {
namespace {

template <typename Number>
void assign(const std::string& text, std::size_t equals, Number& out) {
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, out);
  if (error != std::errc{} || stop != end)
    throw CaseError(fmt::format("--set {}: a number is allowed", text));
}

membrane::PassengerBagOptions passenger_options(const std::vector<std::string>& overrides) {
  membrane::PassengerBagOptions options;
  for (const auto& text : overrides) {
    const auto equals = std::min(text.find('='), text.size() - 1);
    const std::string key = text.substr(0, equals);
    if (key == "depth")
      assign(text, equals, options.depth);
    else if (key == "width")
      assign(text, equals, options.width);
    else if (key == "height")
      assign(text, equals, options.height);
    else if (key == "depth_cells")
      assign(text, equals, options.depth_cells);
    else if (key == "width_cells")
      assign(text, equals, options.width_cells);
    else if (key == "height_cells")
      assign(text, equals, options.height_cells);
    else
      throw CaseError(
          fmt::format("--set {}: unknown option, allowed are depth, width, height [m], depth_cells, "
                      "width_cells, height_cells",
                      text));
  }
  return options;
}

}  // namespace

int mesh_passenger(const MeshArguments& arguments) {
  membrane::PassengerBag bag;
  membrane::ElementQuality quality{};
  try {
    bag = membrane::passenger_bag(passenger_options(arguments.overrides));
    membrane::require_closed_surface(bag.mesh.nodes, bag.mesh.elements);
    quality = membrane::element_quality(bag.mesh.nodes, bag.mesh.elements);
    membrane::write_obj(bag.mesh, arguments.out);
  } catch (const std::invalid_argument& error) {
    throw CaseError(error.what());
  } catch (const membrane::MeshFileError& error) {
    throw OutputError(error.what());
  }
  fmt::print("{}: {} elements, {} nodes, design volume {:.5g} m3\n", arguments.out.string(),
             bag.mesh.element_count(), bag.mesh.node_count(),
             membrane::enclosed_volume(bag.mesh.nodes, bag.mesh.elements));
  fmt::print(
      "smallest angle {:.1f} degrees, smallest altitude {:.4g} m, mean {:.4g} m, largest aspect {:.3g}\n",
      quality.min_angle * 180.0 / std::numbers::pi, quality.min_altitude, quality.mean_altitude,
      quality.max_aspect);
  for (const auto& [back, front] : bag.strap_anchors)
    fmt::print("strap anchors: nodes {} and {}\n", back, front);
  return exit_done;
}

}  // namespace driver::commands
