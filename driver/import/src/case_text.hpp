// SPDX-License-Identifier: Apache-2.0
// Text of a case that grows table by table.
#pragma once

#include "import/bag_deck.hpp"

namespace driver::imported {

/// TOML, and the CSV files of its curves.
class CaseText {
 public:
  void table(const std::string& header, const std::string& source = {});
  void line(const std::string& key, const std::string& value, const std::string& remark = {});
  void line(const std::string& key, double value, const std::string& unit = {});
  void line(const std::string& key, const Eigen::Vector3d& value, const std::string& unit = {});
  /// A number if the curve is constant, else its knots, inline or in a CSV file of this name.
  void curve(const std::string& key, const Knots& knots, const std::string& abscissa, const std::string& unit,
             const std::string& file);
  void remark(const std::string& text);

  const std::string& text() const { return text_; }
  const DeckFiles& files() const { return files_; }

 private:
  std::string text_;
  DeckFiles files_;
};

/// The shortest text that reads back to the same number.
std::string number(double value);
std::string vector(const Eigen::Vector3d& value);

}  // namespace driver::imported
