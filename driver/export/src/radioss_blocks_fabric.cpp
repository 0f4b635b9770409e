// SPDX-License-Identifier: Apache-2.0
// Fabric and straps of a Radioss deck.
#include <fmt/format.h>

#include "radioss_blocks.hpp"

namespace driver {
namespace {

/// Writes the fabric, one method a block.
class RadiossFabric : private RadiossIds {
 public:
  RadiossFabric(const Deck& deck, RadiossCards& out) : deck_(deck), u_(out.units()), out_(out) {}
  void write();

 private:
  const BagPart& bag() const { return *deck_.scene->bag; }
  void void_material();
  void material(const DeckPart& p);
  void porous(const DeckLeak& leak);
  void property(const DeckPart& p);
  void thread_functions();
  void thread_material(const DeckPart& p);
  void thread_property(const DeckPart& p);
  void reference(const DeckPart& p);

  const Deck& deck_;
  const Units& u_;
  std::array<int, 2> threads_{0, 0};  // functions of warp and weft, of fabric by measured curves
  RadiossCards& out_;
};

void RadiossFabric::void_material() {
  out_.title(fmt::format("/MAT/VOID/{}", void_law), "no stress");
  const membrane::ElementProperties& fabric = a_fabric(deck_);
  out_.line("#        Init. dens.                   E");
  constexpr double weightless = 1e-6;  // share of the fabric's density
  out_.card(
      {real(weightless * fabric.density / u_.density(), 20), real(fabric.young_modulus / u_.pressure(), 20)});
  out_.title(fmt::format("/PROP/VOID/{}", void_property), "no stress");
  out_.line("#              THICK");
  out_.card({real(fabric.thickness / u_.length, 20)});
}

void RadiossFabric::write() {
  void_material();
  thread_functions();
  for (const DeckPart& p : deck_.parts) {
    if (!p.null_panel) {
      threads_[0] ? thread_material(p) : material(p);
      for (const DeckLeak& leak : deck_.leaks)
        if (leak.part == p.id) porous(leak);
      threads_[0] ? thread_property(p) : property(p);
    }
    out_.part(p.id, p.name, p.null_panel ? void_property : p.id, p.null_panel ? void_law : p.id);
    out_.triangles(p.id, 1, 1, bag().mesh.elements, p.elements);
    if (!p.null_panel) reference(p);
  }
}

void RadiossFabric::material(const DeckPart& p) {
  const membrane::ElementProperties& f = p.fabric;
  const double shear = f.weave ? f.weave->shear : 0.5 * f.young_modulus / (1.0 + f.poisson);
  out_.title(fmt::format("/MAT/FABRI/{}", p.id), p.name);
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
  constexpr double slack = 1e-3;  // share of the stress in compression, the smallest that the program accepts
  out_.card({real(bag().model.description.compression == membrane::Compression::none ? slack : 1.0, 20)});
}

// Sets the open share in the material: without it the airbag treats a porous surface as tight.
void RadiossFabric::porous(const DeckLeak& leak) {
  constexpr int by_factors = 1;
  out_.title(fmt::format("/LEAK/MAT/{}", leak.part), "share of the area that is open");
  out_.line("# Ileakage                      Ascale_T            Ascale_P");
  out_.card({whole(by_factors, 10), blank(10), real(1.0, 20), real(1.0, 20)});
  out_.line("#                Ac'Fct_ID_AC'                    Fscale_AC'");
  out_.card({real(1.0, 20), whole(0, 10), blank(10), real(1.0, 20)});
  out_.line("#                 LC                  AC");
  out_.card({real(leak.velocity ? 1.0 : leak.share, 20), real(1.0, 20)});
}

// Incremental strain is logarithmic and close to the case's law, but its shear drifts in woven fabric, which
// shears easily. Woven fabric therefore has a linear strain about the design shape.
int strain_of(const DeckPart& p) {
  constexpr int by_increments = 4, total = 11;
  return p.fabric.weave ? total : by_increments;
}

void RadiossFabric::property(const DeckPart& p) {
  // For isotropic fabric, any direction that is not normal to an element.
  const Eigen::Vector3d warp =
      p.fabric.weave ? p.fabric.weave->warp.normalized() : Eigen::Vector3d(0.5374, 0.6412, 0.5478);
  out_.title(fmt::format("/PROP/SH_ORTH/{}", p.id), p.name);
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

// Functions of threads, with almost no stress in compression: the program needs functions that rise
// everywhere.
void RadiossFabric::thread_functions() {
  constexpr double slack = 1e-6;  // share of the steepest slope
  for (std::size_t i = 0; i < 2; ++i) {
    const DeckThread& thread = deck_.threads[i];
    DeckCurve curve = thread.curve;
    if (curve.empty()) return;
    curve.insert(curve.begin(), {-1.0, -slack * thread.steepest});
    threads_[i] = out_.function(i == 0 ? "warp" : "weft", curve, 1.0, u_.pressure());
  }
}

// LAW58: nominal stress over the elongation of the fibres of a weave. Its crimp, which couples warp and weft,
// is almost zero here: it adds at most three times its value to a strain.
void RadiossFabric::thread_material(const DeckPart& p) {
  const Field none = real(0.0, 20), crimp = real(1e-6, 20), flex = real(0.01, 20);
  const double shear = p.fabric.weave->shear / u_.pressure();
  const double locking = 45.0;  // [deg] its tangent squared is 1: beyond it the shear follows the same line.
  out_.title(fmt::format("/MAT/FABR_A/{}", p.id), p.name);
  out_.line("#              RHO_I");
  out_.card({real(p.fabric.density / u_.density(), 20)});
  out_.line(
      "#                 E1                  B1                  E2                  B2                Flex");
  out_.card({real(deck_.threads[0].steepest / u_.pressure(), 20), none,
             real(deck_.threads[1].steepest / u_.pressure(), 20), none, flex});
  out_.line(
      "#                 G0                  GT              AlphaT                 Gsh           sensor_ID");
  out_.card(
      {real(shear, 20), real(2.0 * shear, 20), real(locking, 20), real(shear, 20), blank(10), whole(0, 10)});
  out_.line(
      "#                 Df                  Ds               GFROT                             ZERO_STRESS");
  out_.card({none, none, none, blank(20), none});
  out_.line(
      "#       N1        N2                  S1                  S2               FLEX1               FLEX2");
  out_.card({whole(1, 10), whole(1, 10), crimp, crimp, flex, flex});
  for (const int thread : {threads_[0], threads_[1], 0}) {
    out_.line("#   FCT_ID                        Fscale");
    out_.card({whole(thread, 10), blank(10), real(1.0, 20)});
  }
  out_.line("#  FCT_ID4   FCT_ID5             Fscale4             Fscale5   FCT_ID6             Fscale6");
  out_.card({whole(0, 10), whole(0, 10), none, none, whole(0, 10), none});
}

void RadiossFabric::thread_property(const DeckPart& p) {
  const Eigen::Vector3d warp = p.fabric.weave->warp.normalized();
  const Field thickness = real(p.fabric.thickness / u_.length, 20), none = real(0.0, 20);
  constexpr int plain_triangle = 2, by_increments = 4;
  out_.title(fmt::format("/PROP/SH_FABR/{}", p.id), p.name);
  out_.line("#   Ishell    Ismstr     Ish3n                                      P_Thick_Fail");
  out_.card({whole(0, 10), whole(by_increments, 10), whole(plain_triangle, 10), blank(30), none});
  out_.line(
      "#                 Hm                  Hf                  Hr                  Dm                  Dn");
  out_.card({none, none, none, none, none});
  out_.line("#        N   Istrain               Thick              Ashear              Ithick");
  out_.card({whole(1, 10), whole(0, 10), thickness, none, blank(10), whole(0, 10)});
  out_.line(
      "#                 Vx                  Vy                  Vz   Skew_ID      Ipos                  Ip");
  out_.card({real(warp.x(), 20), real(warp.y(), 20), real(warp.z(), 20), whole(0, 10), whole(0, 10),
             blank(10), whole(0, 10)});
  out_.line("#              Phi_i             Alpha_i                 T_i                 Z_i   mat_IDi");
  out_.card({none, real(90.0, 20), thickness, none, whole(p.id, 10)});
}

void RadiossFabric::reference(const DeckPart& p) {
  out_.title(fmt::format("/XREF/{}", p.id), p.name);
  out_.line("#    Nitrs");
  constexpr int increments = 10000;  // from design to start shape; for a bag folded flat 100 steps leave an
                                     // error of 4 %
  out_.card({whole(increments, 10)});
  out_.line("#  node_ID                   X                   Y                   Z");
  for (const int n : corners_of(deck_, p.elements)) out_.node(n, bag().mesh.nodes.col(n - 1));
}

}  // namespace

void write_radioss_fabric(const Deck& deck, RadiossCards& out) {
  RadiossFabric(deck, out).write();
}

void write_radioss_straps(const Deck& deck, RadiossCards& out) {
  const membrane::BagModel& bag = deck.scene->bag->model;
  constexpr double light = 1e-6;  // share of the fabric's mass
  const DeckIds ids(deck);
  int number = 0;
  for (const membrane::Strap& strap : bag.description.straps) {
    out.spring({.property = RadiossIds::strap_property + number,
                .part = ids.strap_part + number,
                .element = ids.strap_element + number,
                .name = "strap",
                .nodes = {strap.node_a + 1, strap.node_b + 1},
                .mass = light * bag.fabric_mass,
                .stiffness = strap.stiffness,
                .force = force_of(deck, strap)});
    ++number;
  }
}

}  // namespace driver
