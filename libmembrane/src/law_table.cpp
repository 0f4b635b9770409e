// SPDX-License-Identifier: Apache-2.0
#include "membrane/law_table.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "checks.hpp"
#include "law_functions.hpp"

namespace membrane {

namespace {

template <class Law>
using Constants = typename Law::template Constants<double>;
template <class Law>
using Notes = typename Law::template Notes<double>;
template <class Law>
using Rows = std::array<double, kNumbersIn<Law::template Constants>>;

template <class Law>
void write(const Constants<Law>& constants, FabricGroup& group, std::size_t lane) {
  const auto rows = std::bit_cast<Rows<Law>>(constants);
  for (std::size_t i = 0; i < rows.size(); ++i) group.constants[i][lane] = rows[i];
}

template <class Law, int kStep>
void run_steps(const PlaneStrain<double>& strain, const Constants<Law>& constants, Notes<Law>& notes) {
  if constexpr (kStep < Law::kSteps) {
    const auto row = Law::template step<kStep>(strain, constants, notes);
    std::memcpy(reinterpret_cast<double*>(&notes) + Law::kNotesBefore[kStep], row.value, sizeof row.value);
    run_steps<Law, kStep + 1>(strain, constants, notes);
  }
}

template <class Law>
PlaneResponse<double> response(Compression compression, const PlaneStrain<double>& strain,
                               const FabricGroup& group, std::size_t lane, const YarnCurves& curves) {
  Rows<Law> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = group.constants[i][lane];
  const auto constants = std::bit_cast<Constants<Law>>(rows);
  Notes<Law> notes{};
  run_steps<Law, 0>(strain, constants, notes);
  if constexpr (Law::traits.compression)
    if (compression == Compression::linear)
      return Law::template response<Compression::linear>(strain, constants, notes, curves);
  return Law::template response<Compression::none>(strain, constants, notes, curves);
}

template <class Law>
constexpr LawFunctions kFunctionsOf{Law::stiffness,
                                    [](const LawInput& fabric, FabricGroup& group, std::size_t lane) {
                                      write<Law>(Law::constants(fabric), group, lane);
                                    },
                                    [](FabricGroup& group, std::size_t lane) { write<Law>({}, group, lane); },
                                    response<Law>};

template <class... Law>
constexpr std::array<LawTraits, sizeof...(Law)> traits_of(LawList<Law...>) {
  return {Law::traits...};
}
template <class... Law>
constexpr std::array<LawFunctions, sizeof...(Law)> functions_of(LawList<Law...>) {
  return {kFunctionsOf<Law>...};
}

constexpr auto kTraits = traits_of(FabricLaws{});
constexpr auto kFunctions = functions_of(FabricLaws{});

static_assert(std::ranges::all_of(kTraits, [](const LawTraits& law) { return law.woven || !law.curves; }),
              "curves are of warp and weft");

}  // namespace

std::span<const LawTraits> fabric_laws() {
  return kTraits;
}

const LawFunctions& law_functions(int law) {
  return kFunctions[static_cast<std::size_t>(law)];
}

std::optional<int> find_law(std::string_view name, bool woven) {
  for (std::size_t i = 0; i < kTraits.size(); ++i)
    if (name == kTraits[i].name && woven == kTraits[i].woven) return static_cast<int>(i);
  return std::nullopt;
}

const LawTraits& law_named(std::string_view name) {
  for (const LawTraits& law : kTraits)
    if (name == law.name) return law;
  std::string allowed;
  for (const std::string& known : law_names()) allowed += (allowed.empty() ? "" : ", ") + known;
  reject("bag", "law = " + std::string(name) + ", allowed: " + allowed);
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const LawTraits& law : kTraits)
    if (std::ranges::find(names, law.name) == names.end()) names.emplace_back(law.name);
  return names;
}

}  // namespace membrane
