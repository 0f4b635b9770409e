// SPDX-License-Identifier: Apache-2.0
#include "tape.hpp"

namespace enclosure {
namespace {

/// (x_0 y_{n-1} + ... + x_{n-1} y_0) of n terms from x and up to y on; `last` is y_{n-1}.
void convolve(arb_ptr out, arb_srcptr initial, bool subtract, arb_srcptr x, arb_srcptr last, slong n) {
  arb_dot(out, initial, subtract, x, 1, last, -1, n, bits);
}

}  // namespace

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

Series::Series(const Tape& tape, std::vector<int> rates, slong order, bool partials)
    : tape_(tape),
      rates_(std::move(rates)),
      order_(order),
      rows_(partials ? 1 + static_cast<int>(rates_.size()) : 1),
      states_(rates_.size()),
      data_(_arb_vec_init(static_cast<slong>(tape.nodes().size()) * rows_ * (order + 1))),
      weighted_(tape.nodes().size(), nullptr) {
  for (std::size_t i = 0; i < weighted_.size(); ++i) {
    const Node& node = tape.nodes()[i];
    if (node.op == Op::state) states_[static_cast<std::size_t>(node.a)] = static_cast<int>(i);
    if (node.op == Op::exponential || node.op == Op::logarithm) weighted_[i] = _arb_vec_init(order + 1);
  }
}

Series::~Series() {
  _arb_vec_clear(data_, static_cast<slong>(tape_.nodes().size()) * rows_ * (order_ + 1));
  for (arb_ptr row : weighted_)
    if (row) _arb_vec_clear(row, order_ + 1);
}

void Series::run(const Balls& x, const Span& span, Mode mode) {
  mode_ = mode;
  const auto& nodes = tape_.nodes();
  const int count = static_cast<int>(nodes.size());
  for (int id = 0; id < count; ++id) {
    const Node& node = nodes[static_cast<std::size_t>(id)];
    if (node.op == Op::constant) arb_set(row(id, 0), node.low.get());
    if (node.op == Op::time) node.series(span, mode, row(id, 0), order_ + 1);
    if (node.op != Op::state) continue;
    arb_set(row(id, 0), x[static_cast<std::size_t>(node.a)].get());
    for (int j = 1; j < rows_; ++j) arb_set_ui(row(id, j), j - 1 == node.a ? 1 : 0);
  }
  for (slong k = 0; k <= order_; ++k) {
    for (int id = 0; id < count; ++id) {
      value_coefficient(id, k);
      if (nodes[static_cast<std::size_t>(id)].moves)
        for (int j = 1; j < rows_; ++j) partial_coefficient(id, j, k);
    }
    if (k == order_) break;
    for (std::size_t i = 0; i < states_.size(); ++i)
      for (int j = 0; j < rows_; ++j)
        arb_div_si(row(states_[i], j) + k + 1, row(rates_[i], j) + k, k + 1, bits);
  }
}

void Series::value_coefficient(int id, slong k) {
  const Node& node = tape_.nodes()[static_cast<std::size_t>(id)];
  if (node.op == Op::constant || node.op == Op::time || node.op == Op::state) return;
  const arb_ptr c = row(id, 0), w = weighted_[static_cast<std::size_t>(id)];
  const arb_srcptr a = row(node.a, 0), b = node.b < 0 ? nullptr : row(node.b, 0);
  const Op left = tape_.nodes()[static_cast<std::size_t>(node.a)].op;
  switch (node.op) {
    case Op::add:
      arb_add(c + k, a + k, b + k, bits);
      break;
    case Op::subtract:
      arb_sub(c + k, a + k, b + k, bits);
      break;
    case Op::multiply:
      if (left == Op::constant) {
        arb_mul(c + k, a, b + k, bits);
      } else if (tape_.nodes()[static_cast<std::size_t>(node.b)].op == Op::constant) {
        arb_mul(c + k, a + k, b, bits);
      } else {
        convolve(c + k, nullptr, false, a, b + k, k + 1);
      }
      break;
    case Op::divide:
      convolve(c + k, a + k, true, b + 1, c + k - 1, k);
      arb_div(c + k, c + k, b, bits);
      break;
    case Op::root:
      if (k == 0) {
        mode_ != Mode::series ? arb_sqrtpos(c, a, bits) : arb_sqrt(c, a, bits);
        break;
      }
      convolve(c + k, a + k, true, c + 1, c + k - 1, k - 1);
      arb_div(c + k, c + k, c, bits);
      arb_mul_2exp_si(c + k, c + k, -1);
      break;
    case Op::exponential:
      if (k == 0) {
        arb_exp(c, a, bits);
        break;
      }
      arb_mul_si(w + k, a + k, k, bits);
      convolve(c + k, nullptr, false, w + 1, c + k - 1, k);
      arb_div_si(c + k, c + k, k, bits);
      break;
    case Op::logarithm:
      if (k == 0) {
        arb_log(c, a, bits);
        break;
      }
      convolve(c + k, nullptr, false, w + 1, a + k - 1, k - 1);
      arb_div_si(c + k, c + k, k, bits);
      arb_sub(c + k, a + k, c + k, bits);
      arb_div(c + k, c + k, a, bits);
      arb_mul_si(w + k, c + k, k, bits);
      break;
    case Op::within:
      arb_set(c + k, a + k);
      if (mode_ != Mode::series && node.has_low) arb_max(c, c, node.low.get(), bits);
      if (mode_ != Mode::series && node.has_high) arb_min(c, c, node.high.get(), bits);
      break;
    default:
      break;
  }
}

void Series::partial_coefficient(int id, int j, slong k) {
  const Node& node = tape_.nodes()[static_cast<std::size_t>(id)];
  if (node.op == Op::state) return;
  const auto moves = [&](int operand) {
    return operand >= 0 && tape_.nodes()[static_cast<std::size_t>(operand)].moves;
  };
  const arb_srcptr c = row(id, 0), a = row(node.a, 0), da = moves(node.a) ? row(node.a, j) : nullptr;
  const arb_srcptr b = node.b < 0 ? nullptr : row(node.b, 0), db = moves(node.b) ? row(node.b, j) : nullptr;
  const arb_ptr d = row(id, j);
  const auto start = [&] { da ? arb_set(d + k, da + k) : arb_zero(d + k); };
  switch (node.op) {
    case Op::add:
    case Op::subtract:
      start();
      if (db && node.op == Op::add) arb_add(d + k, d + k, db + k, bits);
      if (db && node.op == Op::subtract) arb_sub(d + k, d + k, db + k, bits);
      break;
    case Op::multiply:
      arb_zero(d + k);
      if (da) convolve(d + k, nullptr, false, da, b + k, k + 1);
      if (db) convolve(d + k, d + k, false, a, db + k, k + 1);
      break;
    case Op::divide:  // (da - c db)/b
      start();
      if (db) convolve(d + k, d + k, true, c, db + k, k + 1);
      convolve(d + k, d + k, true, b + 1, d + k - 1, k);
      arb_div(d + k, d + k, b, bits);
      break;
    case Op::root:  // da/(2 c)
      arb_mul_2exp_si(d + k, da + k, -1);
      convolve(d + k, d + k, true, c + 1, d + k - 1, k);
      arb_div(d + k, d + k, c, bits);
      break;
    case Op::exponential:  // c da
      convolve(d + k, nullptr, false, c, da + k, k + 1);
      break;
    case Op::logarithm:  // da/a
      convolve(d + k, da + k, true, a + 1, d + k - 1, k);
      arb_div(d + k, d + k, a, bits);
      break;
    case Op::within:
      start();
      break;
    default:
      break;
  }
}

}  // namespace enclosure
