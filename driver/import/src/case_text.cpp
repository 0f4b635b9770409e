// SPDX-License-Identifier: Apache-2.0
#include "case_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "base/case_reader.hpp"
#include "base/run_id.hpp"

namespace driver::imported {
namespace {

constexpr std::size_t most_inline = 8;

std::string column_of(const std::string& abscissa) {
  return abscissa == "time" ? "time_s" : abscissa == "overpressure" ? "overpressure_Pa" : abscissa;
}

}  // namespace

std::string number(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".en") == std::string::npos) text += ".0";
  return text;
}

std::string vector(const Eigen::Vector3d& value) {
  return fmt::format("[{}, {}, {}]", number(value.x()), number(value.y()), number(value.z()));
}

void CaseText::table(const std::string& header, const std::string& source) {
  if (!text_.empty()) text_ += '\n';
  text_ += header;
  if (!source.empty()) text_ += "  # " + one_line(source);
  text_ += '\n';
}

void CaseText::line(const std::string& key, const std::string& value, const std::string& remark) {
  text_ += fmt::format("{} = {}{}{}\n", key, value, remark.empty() ? "" : "  # ", one_line(remark));
}

void CaseText::line(const std::string& key, double value, const std::string& unit) {
  line(key, number(value), unit);
}

void CaseText::line(const std::string& key, const Eigen::Vector3d& value, const std::string& unit) {
  line(key, vector(value), unit);
}

void CaseText::remark(const std::string& text) {
  text_ += "# " + one_line(text) + '\n';
}

void CaseText::curve(const std::string& key, const Knots& knots, const std::string& abscissa,
                     const std::string& unit, const std::string& file) {
  if (knots.size() == 1) return line(key, knots.front()[1], unit);
  if (knots.size() <= most_inline) {
    std::vector<std::string> x, y;
    for (const auto& knot : knots) {
      x.push_back(number(knot[0]));
      y.push_back(number(knot[1]));
    }
    return line(
        key, fmt::format("{{ {} = [{}], value = [{}] }}", abscissa, fmt::join(x, ", "), fmt::join(y, ", ")),
        unit);
  }
  std::string csv = fmt::format("{},value\n", column_of(abscissa));
  for (const auto& knot : knots) csv += fmt::format("{},{}\n", knot[0], knot[1]);
  files_.emplace_back(file + ".csv", std::move(csv));
  line(key, fmt::format("{{ file = {}, column = \"value\" }}", quoted(file + ".csv")), unit);
}

}  // namespace driver::imported
