// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "radioss_blocks.hpp"

namespace driver {

void RadiossCards::title(const std::string& header, std::string_view text) {
  line(header);
  label(text, title_columns);
}

void RadiossCards::node(int id, const Eigen::Vector3d& x) {
  card(
      {whole(id, 10), real(x.x() / u_.length, 20), real(x.y() / u_.length, 20), real(x.z() / u_.length, 20)});
}

void RadiossCards::point(const Eigen::Vector3d& x) {
  card({real(x.x() / u_.length, 20), real(x.y() / u_.length, 20), real(x.z() / u_.length, 20)});
}

void RadiossCards::part(int id, std::string_view name, int property, int law) {
  title(fmt::format("/PART/{}", id), name);
  line("#  prop_ID    mat_ID subset_ID");
  card({whole(property, 10), whole(law, 10), whole(0, 10)});
}

void RadiossCards::group(Group id, std::string_view name, const std::vector<int>& nodes) {
  title(fmt::format("/GRNOD/NODE/{}", static_cast<int>(id)), name);
  list(nodes, 10);
}

void RadiossCards::hold(int id, std::string_view code, Group nodes, int axes) {
  title(fmt::format("/BCS/{}", id), "held");
  line("#  Tra rot   skew_ID  grnod_ID");
  card({word(code, 10), whole(axes, 10), whole(nodes, 10)});
}

void RadiossCards::triangles(int part_id, int first_element, int first_node, const Eigen::Matrix3Xi& corners,
                             const std::vector<int>& elements) {
  line(fmt::format("/SH3N/{}", part_id));
  line("#  sh3n_ID  node_ID1  node_ID2  node_ID3");
  for (const int e : elements)
    card({whole(first_element + e, 10), whole(first_node + corners(0, e), 10),
          whole(first_node + corners(1, e), 10), whole(first_node + corners(2, e), 10)});
}

void RadiossCards::spring(const RadiossSpring& s) {
  const int curve = function(fmt::format("force of a {}", s.name), s.force, u_.length, u_.force());
  title(fmt::format("/PROP/SPRING/{}", s.property), s.name);
  line("#               MASS                                 sens_ID    Isflag     Ileng");
  card({real(s.mass / u_.mass, 20), blank(30), whole(0, 10), whole(0, 10), whole(0, 10)});
  line(
      "#                  K                   C                   A                   B                   "
      "D");
  card({real(s.stiffness / u_.stiffness(), 20), real(s.damping / (u_.force() / u_.velocity()), 20),
        real(1.0, 20), real(0.0, 20), real(0.0, 20)});
  line(
      "# fct_ID11        H1  fct_ID21  fct_ID31  fct_ID41                      DeltaMin            "
      "DeltaMax");
  card({whole(curve, 10), whole(0, 10), whole(0, 10), whole(0, 10), whole(0, 10), blank(10), real(0.0, 20),
        real(0.0, 20)});
  line("#                 F1                  E1             AScale1             HScale1");
  card({real(0.0, 20), real(0.0, 20), real(0.0, 20), real(0.0, 20)});
  part(s.part, s.name, s.property, 0);
  line(fmt::format("/SPRING/{}", s.part));
  line("#sprg_ID   node_ID1  node_ID2");
  card({whole(s.element, 10), whole(s.nodes[0], 10), whole(s.nodes[1], 10)});
}

int RadiossCards::function(std::string_view name, const DeckCurve& curve, double x_unit, double y_unit) {
  line(fmt::format("/FUNCT/{}", ++functions_));
  line(name);
  line("#                  X                   Y");
  for (const auto& [x, y] : curve) card({real(x / x_unit, 20), real(y / y_unit, 20)});
  return functions_;
}

void RadiossCards::contact(const RadiossContact& contact) {
  title(fmt::format("/INTER/TYPE7/{}", contact.id), contact.name);
  const auto zeros = [](int count) {
    return std::vector<Field>(static_cast<std::size_t>(count), real(0.0, 20));
  };
  line(
      "# grnod_id   surf_id      Istf      Ithe      Igap                Ibag      Idel     Icurv      Iadm");
  card({whole(all_nodes, 10), whole(contact.surface, 10), whole(contact.stiffness, 10), whole(0, 10),
        whole(0, 10), blank(10), whole(0, 10), whole(0, 10), whole(0, 10), whole(0, 10)});
  line("#          Fscalegap             Gap_max             Fpenmax                         Itied");
  card({real(0.0, 20), real(0.0, 20), real(0.0, 20), blank(20), whole(0, 10)});
  line(
      "#              Stmin               Stmax   Percent_mesh_size               dtmin  Irem_gap   Irem_i2");
  auto stiffness = zeros(4);
  stiffness.push_back(whole(0, 10));
  stiffness.push_back(whole(0, 10));
  card(stiffness);
  line(
      "#              Stfac                Fric              GAPmin              Tstart               Tstop");
  card({real(1.0, 20), real(contact.friction, 20), real(contact.gap / u_.length, 20), real(0.0, 20),
        real(0.0, 20)});
  line(
      "#      IBC                        Inacti               VIS_S               VIS_F              Bumult");
  card(
      {word("000", 10), blank(20), whole(contact.at_start, 10), real(0.0, 20), real(0.0, 20), real(0.0, 20)});
  line(
      "#    Ifric    Ifiltr               Xfreq     Iform   sens_ID   fct_IDF             AscaleF   fric_ID");
  constexpr int by_stiffness = 2;
  card({whole(0, 10), whole(0, 10), real(0.0, 20), whole(by_stiffness, 10), whole(0, 10), whole(0, 10),
        real(0.0, 20), whole(0, 10)});
}

}  // namespace driver
