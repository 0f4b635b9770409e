// SPDX-License-Identifier: Apache-2.0
#include "scene/read_fold.hpp"

#include <fmt/format.h>

namespace driver {
namespace {

enum class Step { press, letter, accordion, roll };

mesh::FoldOptions read_options(TableReader& table, Step step) {
  mesh::FoldOptions options;
  options.type = step == Step::letter      ? mesh::FoldType::letter
                 : step == Step::accordion ? mesh::FoldType::accordion
                                           : mesh::FoldType::roll;
  options.axis = table.at("axis").choice<int>({{"x", 0}, {"y", 1}, {"z", 2}});
  options.at = table.at("at").numbers(any_number.in("m"));
  options.easing = table.at("easing").number(Bounds{0.0, 10.0, false, "0 to 10"}, options.easing);
  return options;
}

}  // namespace

std::optional<mesh::Folding> read_folds(TableReader& table, const mesh::Mesh& mesh,
                                        const Eigen::Matrix3Xd& start, const membrane::BagDescription& bag) {
  auto tables = table.tables("fold");
  if (tables.empty()) return {};
  mesh::Folding folding(mesh, start, bag.fixed_nodes, mesh::thin_side(start, bag.fixed_nodes));
  for (TableReader& reader : tables) {
    const auto step = reader.at("type").choice<Step>({{"press", Step::press},
                                                      {"letter", Step::letter},
                                                      {"accordion", Step::accordion},
                                                      {"roll", Step::roll}});
    const double gap = reader.at("gap").number(positive.in("m"));
    if (step == Step::press) {
      reader.finish();
      reader.located("", [&] { folding.press(gap); });
      continue;
    }
    mesh::FoldOptions options = read_options(reader, step);
    options.gap = gap;
    reader.finish();
    reader.located("", [&] { folding.fold(options); });
  }
  return folding;
}

std::vector<std::string> tight_straps(const std::vector<membrane::Strap>& straps,
                                      const Eigen::Matrix3Xd& start) {
  std::vector<std::string> texts;
  for (std::size_t i = 0; i < straps.size(); ++i) {
    const double length = (start.col(straps[i].node_b) - start.col(straps[i].node_a)).norm();
    if (length > straps[i].free_length)
      texts.push_back(fmt::format(
          "membrane.strap.{}: is {:.3g} m long in the folded start, its free length is {:.3g} m: it "
          "pulls; move a fold line, or give it free length",
          i, length, straps[i].free_length));
  }
  return texts;
}

}  // namespace driver
