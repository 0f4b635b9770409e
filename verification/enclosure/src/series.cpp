// SPDX-License-Identifier: Apache-2.0
#include "series.hpp"

namespace enclosure {

template <class Number>
SeriesOf<Number>::SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values,
                           slong order, std::size_t rows)
    : tape_(tape),
      rates_(std::move(rates)),
      order_(order),
      rows_(rows),
      states_(rates_.size()),
      needed_(behind(values)),
      data_(tape.nodes().size() * rows_ * (static_cast<std::size_t>(order) + 1)),
      weighted_(tape.nodes().size()) {
  for (std::size_t i = 0; i < weighted_.size(); ++i) {
    const Node& node = tape.nodes()[i];
    if (node.op == Op::state) states_[static_cast<std::size_t>(node.a)] = static_cast<int>(i);
    if (node.op == Op::exponential || node.op == Op::logarithm)
      weighted_[i].resize(static_cast<std::size_t>(order) + 1);
  }
}

template <class Number>
SeriesOf<Number>::SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values,
                           slong order)
    : SeriesOf(tape, std::move(rates), values, order, std::size_t{1}) {}

template <class Number>
SeriesOf<Number>::SeriesOf(const Tape& tape, std::vector<int> rates, const std::vector<int>& values,
                           slong order, const std::vector<int>& slopes)
    : SeriesOf(tape, rates, values, order, 1 + rates.size()) {
  for (int id : behind(slopes))
    if (tape.nodes()[static_cast<std::size_t>(id)].moves) sloped_.push_back(id);
}

/// What the rates and `outputs` need, in order.
template <class Number>
std::vector<int> SeriesOf<Number>::behind(const std::vector<int>& outputs) const {
  const auto& nodes = tape_.nodes();
  std::vector<bool> is_needed(nodes.size(), false);
  const auto need = [&](int id) {
    if (id >= 0) is_needed[static_cast<std::size_t>(id)] = true;
  };
  for (int id : rates_) need(id);
  for (int id : outputs) need(id);
  std::vector<int> all;
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const bool is_state = nodes[i].op == Op::state;
    if (!is_state && !is_needed[i]) continue;
    all.push_back(static_cast<int>(i));
    if (is_state) continue;
    need(nodes[i].a);
    need(nodes[i].b);
  }
  return {all.rbegin(), all.rend()};
}

template <class Number>
void SeriesOf<Number>::begin(const Balls& x, const Span& span, slong last) {
  const auto& nodes = tape_.nodes();
  Balls in_time(static_cast<std::size_t>(last) + 1);
  for (int id : needed_) {
    const Node& node = nodes[static_cast<std::size_t>(id)];
    Number* const c = row(id, 0);
    if (node.op == Op::constant) into::assign(c[0], node.low);
    if (node.op == Op::time) {
      node.series(span, mode_, in_time.front().get(), last + 1);
      for (slong k = 0; k <= last; ++k) {
        Ball& from = in_time[static_cast<std::size_t>(k)];
        into::shift(from, from, unit_ * k);
        into::assign(c[k], from);
      }
    }
    if (node.op != Op::state) continue;
    into::assign(c[0], x[static_cast<std::size_t>(node.a)]);
    for (int j = 1; j < static_cast<int>(rows_); ++j)
      into::assign(row(id, j)[0], Ball(j - 1 == node.a ? 1.0 : 0.0));
  }
}

template <class Number>
void SeriesOf<Number>::next_of_state(int j, slong k) {
  for (std::size_t i = 0; i < states_.size(); ++i) {
    Number& next = row(states_[i], j)[k + 1];
    into::shift(next, row(rates_[i], j)[k], unit_);
    into::over(next, next, k + 1);
  }
}

template <class Number>
void SeriesOf<Number>::run(const Balls& x, const Span& span, slong last, Mode mode, slong unit) {
  mode_ = mode;
  unit_ = unit;
  begin(x, span, last);
  for (slong k = 0; k <= last; ++k) {
    for (int id : needed_) value_coefficient(id, k);
    if (k < last) next_of_state(0, k);
  }
}

template <class Number>
void SeriesOf<Number>::run_partials(slong last) {
  for (int j = 1; j < static_cast<int>(rows_); ++j)
    for (slong k = 0; k <= last; ++k) {
      for (int id : sloped_) partial_coefficient(id, j, k);
      if (k < last) next_of_state(j, k);
    }
}

template <class Number>
void SeriesOf<Number>::product_coefficient(int id, slong k) {
  const Node& node = tape_.nodes()[static_cast<std::size_t>(id)];
  const auto is_constant = [&](int operand) {
    return tape_.nodes()[static_cast<std::size_t>(operand)].op == Op::constant;
  };
  Number& c = row(id, 0)[k];
  const Number *a = row(node.a, 0), *b = row(node.b, 0);
  if (is_constant(node.a))
    into::multiply(c, a[0], b[k]);
  else if (is_constant(node.b))
    into::multiply(c, a[k], b[0]);
  else
    into::convolve(c, nullptr, false, a, b + k, k + 1);
}

template <class Number>
void SeriesOf<Number>::value_coefficient(int id, slong k) {
  const Node& node = tape_.nodes()[static_cast<std::size_t>(id)];
  if (node.op == Op::constant || node.op == Op::time || node.op == Op::state) return;
  Number *c = row(id, 0), *w = weighted_[static_cast<std::size_t>(id)].data();
  const Number *a = row(node.a, 0), *b = node.b < 0 ? nullptr : row(node.b, 0);
  switch (node.op) {
    case Op::add:
      into::add(c[k], a[k], b[k]);
      break;
    case Op::subtract:
      into::subtract(c[k], a[k], b[k]);
      break;
    case Op::multiply:
      product_coefficient(id, k);
      break;
    case Op::divide:
      into::convolve(c[k], a + k, true, b + 1, c + k - 1, k);
      into::divide(c[k], c[k], b[0]);
      break;
    case Op::root:
      if (k == 0) {
        into::root(c[0], a[0]);
        if constexpr (std::is_same_v<Number, Ball>)
          if (mode_ != Mode::series) arb_sqrtpos(c->get(), a->get(), bits);
        break;
      }
      into::convolve(c[k], a + k, true, c + 1, c + k - 1, k - 1);
      into::divide(c[k], c[k], c[0]);
      into::shift(c[k], c[k], -1);
      break;
    case Op::exponential:
      if (k == 0) {
        into::exponential(c[0], a[0]);
        break;
      }
      into::times(w[k], a[k], k);
      into::convolve(c[k], nullptr, false, w + 1, c + k - 1, k);
      into::over(c[k], c[k], k);
      break;
    case Op::logarithm:
      if (k == 0) {
        into::logarithm(c[0], a[0]);
        break;
      }
      into::convolve(c[k], nullptr, false, w + 1, a + k - 1, k - 1);
      into::over(c[k], c[k], k);
      into::subtract(c[k], a[k], c[k]);
      into::divide(c[k], c[k], a[0]);
      into::times(w[k], c[k], k);
      break;
    case Op::within:
      c[k] = a[k];
      within_bounds(c[k], node);
      break;
    default:
      break;
  }
}

template <class Number>
void SeriesOf<Number>::within_bounds(Number& c, const Node& node) const {
  if constexpr (std::is_same_v<Number, Ball>) {
    if (mode_ != Mode::series && node.has_low) arb_max(c.get(), c.get(), node.low.get(), bits);
    if (mode_ != Mode::series && node.has_high) arb_min(c.get(), c.get(), node.high.get(), bits);
  }
}

template <class Number>
void SeriesOf<Number>::partial_coefficient(int id, int j, slong k) {
  const Node& node = tape_.nodes()[static_cast<std::size_t>(id)];
  if (node.op == Op::state) return;
  const auto moves = [&](int operand) {
    return operand >= 0 && tape_.nodes()[static_cast<std::size_t>(operand)].moves;
  };
  const auto is_constant = [&](int operand) {
    return tape_.nodes()[static_cast<std::size_t>(operand)].op == Op::constant;
  };
  const Number *c = row(id, 0), *a = row(node.a, 0), *da = moves(node.a) ? row(node.a, j) : nullptr;
  const Number *b = node.b < 0 ? nullptr : row(node.b, 0), *db = moves(node.b) ? row(node.b, j) : nullptr;
  Number* const d = row(id, j);
  const Number none{}, &first = da ? da[k] : none;
  switch (node.op) {
    case Op::add:
      db ? into::add(d[k], first, db[k]) : void(d[k] = first);
      break;
    case Op::subtract:
      db ? into::subtract(d[k], first, db[k]) : void(d[k] = first);
      break;
    case Op::multiply:
      if (is_constant(node.a)) {
        into::multiply(d[k], a[0], db[k]);
      } else if (is_constant(node.b)) {
        into::multiply(d[k], da[k], b[0]);
      } else {
        if (da) into::convolve(d[k], nullptr, false, da, b + k, k + 1);
        if (db) into::convolve(d[k], da ? d + k : nullptr, false, a, db + k, k + 1);
      }
      break;
    case Op::divide:  // (da - c db)/b
      d[k] = first;
      if (db) into::convolve(d[k], d + k, true, c, db + k, k + 1);
      into::convolve(d[k], d + k, true, b + 1, d + k - 1, k);
      into::divide(d[k], d[k], b[0]);
      break;
    case Op::root:  // da/(2 c)
      into::shift(d[k], da[k], -1);
      into::convolve(d[k], d + k, true, c + 1, d + k - 1, k);
      into::divide(d[k], d[k], c[0]);
      break;
    case Op::exponential:  // c da
      into::convolve(d[k], nullptr, false, c, da + k, k + 1);
      break;
    case Op::logarithm:  // da/a
      into::convolve(d[k], da + k, true, a + 1, d + k - 1, k);
      into::divide(d[k], d[k], a[0]);
      break;
    case Op::within:
      d[k] = first;
      break;
    default:
      break;
  }
}

template class SeriesOf<Ball>;
template class SeriesOf<QuickBall>;

}  // namespace enclosure
