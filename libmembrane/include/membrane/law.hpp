// SPDX-License-Identifier: Apache-2.0
// Members of a fabric law, and its input. Plain data only, because the kernels include this.
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

/// Input for a law's constants: the checked fabric of one element.
struct LawInput {
  Weave moduli;              // for isotropic fabric equal along warp and weft; not used by laws by curves
  double cosine;             // [-] cosine of twice the angle from the element's first axis to the warp
  double sine;               // [-] sine of the same angle
  const YarnCurves* curves;  // the bag's curves, for laws by curves
  const double* own;         // values, one for each of LawTraits::own
};

/// A constant that only one law uses. It is a key of [fabric] in case files.
struct LawConstant {
  const char* name;  // name of the key
  const char* unit;  // unit; empty for a pure number
  double least;      // lower bound
  double most;       // upper bound
};

/// Use of a law. A law for both isotropic and woven fabric is two laws of one name.
struct LawTraits {
  const char* name;                  // name in case files and in BagDescription::law
  bool woven = false;                // true: for woven fabric; false: for isotropic fabric
  bool compression = false;          // true: may carry compression; false: Compression::none only
  bool curves = false;               // uses curves, and of the moduli only the shear
  const char* end = nullptr;         // message about an element beyond the end of the law; null: it has no
                                     // end
  const LawConstant* own = nullptr;  // the law's own constants
  int own_count = 0;                 // number of these constants
};

/// Some numbers.
template <class T, int kCount>
struct Row {
  T value[kCount];  // the numbers in order
};

/// Defaults of a law. A law derives from this and has these members, where T is a number or a SIMD lane type:
/// - `traits`: its LawTraits;
/// - `Constants`, of T: an aggregate of numbers T; {} gives an element without stress;
/// - `constants(fabric)`: the Constants of a LawInput;
/// - `response(strain, constants, notes, curves)`, of Compression and T: the PlaneResponse.
struct LawDefaults {
  /// Bound of the taut fabric's stiffness (M.10), from which the critical step follows. The rest of the bound
  /// is PlaneResponse::tangent_factor.
  static Weave stiffness(const LawInput& fabric) { return fabric.moduli; }
  /// Steps before the response, for formulas with slow roots and quotients: the kernels do each step for
  /// several groups of elements. `step<K>(strain, constants, notes)` returns Row<T, n>, the notes that it
  /// adds at kNotesBefore[K].
  static constexpr int kSteps = 0;
  /// An aggregate of numbers T: results of the steps for later steps and the response.
  template <class T>
  struct Notes {};
};

}  // namespace membrane
