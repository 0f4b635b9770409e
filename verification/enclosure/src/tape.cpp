// SPDX-License-Identifier: Apache-2.0
#include "tape.hpp"

namespace enclosure {
Term Tape::constant(const Ball& value) {
  nodes_.push_back({.op = Op::constant, .low = value});
  return {this, static_cast<int>(nodes_.size()) - 1};
}

Term Tape::time(TimeSeries series) {
  nodes_.push_back({.op = Op::time, .series = std::move(series)});
  return {this, static_cast<int>(nodes_.size()) - 1};
}

Term Tape::state(int number) {
  nodes_.push_back({.op = Op::state, .a = number, .moves = true});
  return {this, static_cast<int>(nodes_.size()) - 1};
}

Term Tape::add(Op op, int a, int b) {
  const bool moves =
      nodes_[static_cast<std::size_t>(a)].moves || (b >= 0 && nodes_[static_cast<std::size_t>(b)].moves);
  nodes_.push_back({.op = op, .a = a, .b = b, .moves = moves});
  return {this, static_cast<int>(nodes_.size()) - 1};
}

Term Tape::within(Term a, const Ball* low, const Ball* high) {
  const Term result = add(Op::within, a.id);
  Node& node = nodes_.back();
  node.has_low = low != nullptr;
  node.has_high = high != nullptr;
  if (low) node.low = *low;
  if (high) node.high = *high;
  return result;
}

}  // namespace enclosure
