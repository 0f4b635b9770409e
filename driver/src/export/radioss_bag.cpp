// SPDX-License-Identifier: Apache-2.0
// Fabric and straps of a Radioss deck.
#include <fmt/format.h>

#include "export/radioss_starter.hpp"

namespace driver {

void RadiossStarter::triangles(int part_id, int first_element, int first_node,
                               const Eigen::Matrix3Xi& corners, const std::vector<int>& elements) {
  out_.line(fmt::format("/SH3N/{}", part_id));
  out_.line("#  sh3n_ID  node_ID1  node_ID2  node_ID3");
  for (const int e : elements)
    out_.card({whole(first_element + e, 10), whole(first_node + corners(0, e), 10),
               whole(first_node + corners(1, e), 10), whole(first_node + corners(2, e), 10)});
}

void RadiossStarter::void_material() {
  title(fmt::format("/MAT/VOID/{}", void_law), "no stress");
  const membrane::ElementProperties& fabric = a_fabric(deck_);
  out_.line("#        Init. dens.                   E");
  constexpr double weightless = 1e-6;  // share of the fabric's density
  out_.card(
      {real(weightless * fabric.density / u_.density(), 20), real(fabric.young_modulus / u_.pressure(), 20)});
  title(fmt::format("/PROP/VOID/{}", void_property), "no stress");
  out_.line("#              THICK");
  out_.card({real(fabric.thickness / u_.length, 20)});
}

void RadiossStarter::fabric() {
  void_material();
  for (const DeckPart& p : deck_.parts) {
    if (!p.null_panel) {
      fabric_material(p);
      fabric_property(p);
    }
    part(p.id, p.name, p.null_panel ? void_property : p.id, p.null_panel ? void_law : p.id);
    triangles(p.id, 1, 1, bag().mesh.elements, p.elements);
    if (!p.null_panel) reference(p);
  }
}

void RadiossStarter::fabric_material(const DeckPart& p) {
  const membrane::ElementProperties& f = p.fabric;
  const double shear = f.weave ? f.weave->shear : 0.5 * f.young_modulus / (1.0 + f.poisson);
  title(fmt::format("/MAT/FABRI/{}", p.id), p.name);
  out_.line("#              RHO_I");
  out_.card({real(f.density / u_.density(), 20)});
  out_.line("#                E11                 E22                NU12");
  out_.card({real(f.young_modulus / u_.pressure(), 20),
             real((f.weave ? f.weave->young_modulus_weft : f.young_modulus) / u_.pressure(), 20),
             real(f.poisson, 20)});
  out_.line("#                G12                 G23                 G31");
  const Field G = real(shear / u_.pressure(), 20);
  out_.card({G, G, G});
  out_.line("#                R_E");
  constexpr double slack = 1e-3;  // of the stress in compression, the least that the program takes
  out_.card({real(bag().model.description.compression == membrane::Compression::none ? slack : 1.0, 20)});
  for (const DeckLeak& leak : deck_.leaks)
    if (leak.part == p.id) porous(leak);
}

// The airbag takes of a porous surface what the material says is open of it, and nothing of a material that
// is silent.
void RadiossStarter::porous(const DeckLeak& leak) {
  constexpr int by_factors = 1;
  title(fmt::format("/LEAK/MAT/{}", leak.part), "share of the area that is open");
  out_.line("# Ileakage                      Ascale_T            Ascale_P");
  out_.card({whole(by_factors, 10), blank(10), real(1.0, 20), real(1.0, 20)});
  out_.line("#                Ac'Fct_ID_AC'                    Fscale_AC'");
  out_.card({real(1.0, 20), whole(0, 10), blank(10), real(1.0, 20)});
  out_.line("#                 LC                  AC");
  out_.card({real(leak.velocity ? 1.0 : leak.share, 20), real(1.0, 20)});
}

namespace {

// Strain by increments is logarithmic and close to the case's law. But its shear drifts in fabric that shears
// easily, which has a weave: there strain is a linear one about the design shape.
int strain_of(const DeckPart& p) {
  constexpr int by_increments = 4, total = 11;
  return p.fabric.weave ? total : by_increments;
}

}  // namespace

void RadiossStarter::fabric_property(const DeckPart& p) {
  // Of an isotropic fabric any direction that no element is normal to.
  const Eigen::Vector3d warp =
      p.fabric.weave ? p.fabric.weave->warp.normalized() : Eigen::Vector3d(0.5374, 0.6412, 0.5478);
  title(fmt::format("/PROP/SH_ORTH/{}", p.id), p.name);
  constexpr int plain_triangle = 2;
  out_.line("#   Ishell    Ismstr     Ish3n    Idrill                            P_Thick_Fail");
  out_.card({whole(0, 10), whole(strain_of(p), 10), whole(plain_triangle, 10), whole(0, 10), blank(20),
             real(0.0, 20)});
  out_.line(
      "#                 Hm                  Hf                  Hr                  Dm                  Dn");
  out_.card({real(0.0, 20), real(0.0, 20), real(0.0, 20), real(0.0, 20), real(0.0, 20)});
  out_.line("#        N   ISTRAIN               Thick              Ashear     Iskew    ITHICK     IPLAS");
  out_.card({whole(1, 10), whole(0, 10), real(p.fabric.thickness / u_.length, 20), real(0.0, 20),
             whole(0, 10), whole(0, 10), whole(0, 10)});
  out_.line(
      "#                 Vx                  Vy                  Vz                 Phi                  Ip");
  out_.card(
      {real(warp.x(), 20), real(warp.y(), 20), real(warp.z(), 20), real(0.0, 20), blank(10), whole(0, 10)});
}

void RadiossStarter::reference(const DeckPart& p) {
  title(fmt::format("/XREF/{}", p.id), p.name);
  out_.line("#    Nitrs");
  constexpr int increments = 10000;  // from design to start shape; of a bag that is folded flat 100 leave 4 %
  out_.card({whole(increments, 10)});
  out_.line("#  node_ID                   X                   Y                   Z");
  for (const int n : corners_of(deck_, p.elements)) node(n, bag().mesh.nodes.col(n - 1));
}

void RadiossStarter::straps() {
  const auto& straps = bag().model.description.straps;
  for (std::size_t i = 0; i < straps.size(); ++i) {
    const membrane::Strap& strap = straps[i];
    const int number = static_cast<int>(i), property = strap_property + number;
    const int curve = function_++;
    write_radioss_function(curve, "force of a strap", force_of(deck_, strap), u_.length, u_.force(), out_);
    title(fmt::format("/PROP/SPRING/{}", property), "strap");
    constexpr double light = 1e-6;  // of the fabric's mass
    out_.line("#               MASS                                 sens_ID    Isflag     Ileng");
    out_.card({real(light * bag().model.fabric_mass / u_.mass, 20), blank(30), whole(0, 10), whole(0, 10),
               whole(0, 10)});
    out_.line(
        "#                  K                   C                   A                   B                   "
        "D");
    out_.card({real(strap.stiffness / u_.stiffness(), 20), real(0.0, 20), real(1.0, 20), real(0.0, 20),
               real(0.0, 20)});
    out_.line(
        "# fct_ID11        H1  fct_ID21  fct_ID31  fct_ID41                      DeltaMin            "
        "DeltaMax");
    out_.card({whole(curve, 10), whole(0, 10), whole(0, 10), whole(0, 10), whole(0, 10), blank(10),
               real(0.0, 20), real(0.0, 20)});
    out_.line("#                 F1                  E1             AScale1             HScale1");
    out_.card({real(0.0, 20), real(0.0, 20), real(0.0, 20), real(0.0, 20)});
    part(ids_.strap_part + number, "strap", property, 0);
    out_.line(fmt::format("/SPRING/{}", ids_.strap_part + number));
    out_.line("#sprg_ID   node_ID1  node_ID2");
    out_.card(
        {whole(ids_.strap_element + number, 10), whole(strap.node_a + 1, 10), whole(strap.node_b + 1, 10)});
  }
}

}  // namespace driver
