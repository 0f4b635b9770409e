// SPDX-License-Identifier: Apache-2.0
#include "lsdyna_context.hpp"

#include <fmt/format.h>

#include "deck_reader.hpp"

namespace driver::imported {
namespace {

DeckFields fields_of(const DeckText& text, const LsDynaEntry& entry, std::size_t line) {
  return {
      text, *entry.card, line_or_blank(*entry.card, entry.first + line), {10, 10, 10, 10, 10, 10, 10, 10}};
}

}  // namespace

double LsDynaContext::real(const LsDynaEntry& entry, std::size_t line, std::size_t field,
                           const char* name) const {
  return fields_of(text, entry, line).real(field, name);
}

long LsDynaContext::whole(const LsDynaEntry& entry, std::size_t line, std::size_t field,
                          const char* name) const {
  return fields_of(text, entry, line).whole(field, name);
}

Knots LsDynaContext::curve(long id, double x_unit, double y_unit, const std::string& key, Place at) const {
  return take_curve(tables.curves, id, x_unit, y_unit, key, at, report);
}

Knots LsDynaContext::curve_of_pressure(long id, double y_unit, const std::string& key, Place at) const {
  Knots knots = curve(id, units.pressure(), y_unit, key, at);
  for (auto& knot : knots) knot[0] -= bag.ambient_pressure;
  return knots;
}

std::string LsDynaContext::title_of(const DeckCard& card) const {
  if (head_lines(card) == 0 || card.lines.empty()) return {};
  const std::string_view first = card.lines.front().text;
  return std::string(without_blanks(
      card.keyword.ends_with("_ID") ? first.substr(std::min<std::size_t>(10, first.size())) : first));
}

std::string LsDynaContext::source(const DeckCard& card) const {
  std::string text_of = fmt::format("{} {}", text.where(card.at), card.keyword);
  if (const std::string title = title_of(card); !title.empty()) text_of += ", " + title;
  for (const std::string_view remark : card.comments) text_of += fmt::format("; {}", remark);
  return text_of;
}

std::optional<LsDynaEntry> LsDynaContext::material_of(long part) const {
  const auto found = tables.parts.find(part);
  if (found == tables.parts.end()) return std::nullopt;
  const auto material = tables.materials.find(found->second.material);
  if (material == tables.materials.end()) return std::nullopt;
  return material->second;
}

bool LsDynaContext::is_rigid(long part, bool& held) const {
  const auto material = material_of(part);
  if (!material || !(is_keyword(*material->card, "*MAT_RIGID") || is_keyword(*material->card, "*MAT_020")))
    return false;
  constexpr long all_translations = 7;
  held = real(*material, 1, 0, "CMO") == 1.0 && whole(*material, 1, 1, "CON1") == all_translations;
  return true;
}

}  // namespace driver::imported
