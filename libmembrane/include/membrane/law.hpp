// SPDX-License-Identifier: Apache-2.0
// What a fabric law says of itself, and what it is told of a fabric. Plain data only: the kernels include
// this.
#pragma once

namespace membrane {

struct YarnCurves;

/// Elastic data of a woven fabric, as on a data sheet. The Poisson ratio is the contraction along the weft in
/// tension along the warp. The stiffness is positive definite for moduli > 0 and
/// poisson^2 < young_modulus_warp / young_modulus_weft.
struct Weave {
  double young_modulus_warp;  // [Pa] > 0
  double young_modulus_weft;  // [Pa] > 0
  double poisson;             // nu_12 [-]
  double shear;               // G [Pa] > 0
};

/// Everything that a law makes its constants from: the fabric of one element, checked.
struct LawInput {
  Weave moduli;              // of isotropic fabric the same along warp and weft; not of laws by curves
  double cosine;             // [-] of twice the angle from the element's first axis to the warp
  double sine;               // [-] of the same angle
  const YarnCurves* curves;  // of the bag, of laws by curves
  const double* own;         // one for each of LawTraits::own
};

/// A constant that one law alone reads. It is a key of [fabric] in case files.
struct LawConstant {
  const char* name;  // of the key
  const char* unit;  // empty: a pure number
  double least;      // allowed from here
  double most;       // to here
};

/// What a law is for. A law for isotropic and for woven fabric is two of one name.
struct LawTraits {
  const char* name;                  // in case files, and of BagDescription::law
  bool woven = false;                // for woven fabric; else for isotropic fabric
  bool compression = false;          // may carry compression; else Compression::none alone
  bool curves = false;               // reads curves, and no moduli but the shear
  const char* end = nullptr;         // what happened to an element past the end of the law; null: no end
  const LawConstant* own = nullptr;  // the constants that are the law's own
  int own_count = 0;                 // how many
};

/// Some numbers.
template <class T, int kCount>
struct Row {
  T value[kCount];  // in their order
};

/// What a law says if it says nothing else. A law derives from it and has these members, where T is a number
/// or a SIMD lane type:
/// - `traits`: its LawTraits;
/// - `Constants`, of T: an aggregate of numbers T; {} is that of an element without stress;
/// - `constants(fabric)`: the Constants of a LawInput;
/// - `response(strain, constants, notes, curves)`, of the Compression and of T: the PlaneResponse.
struct LawDefaults {
  /// Bounds the stiffness of the taut fabric (M.10): the critical step rests on it. The rest of the bound is
  /// PlaneResponse::tangent_factor.
  static Weave stiffness(const LawInput& fabric) { return fabric.moduli; }
  /// Steps before the response, for formulas whose roots and quotients take long: the kernels do each step
  /// for several groups of elements. `step<K>(strain, constants, notes)` returns Row<T, n>, the notes that it
  /// adds from kNotesBefore[K] on.
  static constexpr int kSteps = 0;
  /// An aggregate of numbers T: what the steps leave for the next and for the response.
  template <class T>
  struct Notes {};
};

}  // namespace membrane
