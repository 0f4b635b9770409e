// SPDX-License-Identifier: Apache-2.0
// What libc++ 13 (Debian 12's emscripten) lacks of C++20, as far as Gasjet uses it: algorithms of
// std::ranges, conversions between text and floating-point numbers. Included before each source by
// cmake/alone/Alone.cmake; empty for other libraries.
#pragma once
#ifdef __cplusplus
#include <version>
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 14000
#include <strings.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <type_traits>
#include <utility>

_LIBCPP_BEGIN_NAMESPACE_STD
namespace ranges {

template <class I, class O>
struct in_out_result {
  I in;
  O out;
};
template <class T>
struct minmax_result {
  T min, max;
};

namespace old {
using std::begin;
using std::end;
template <class T>
concept Range = requires(T& t) {
  begin(t);
  end(t);
};
template <class R>
using Value = std::decay_t<decltype(*std::begin(std::declval<R&>()))>;
// A comparison, or a condition, of projected elements.
template <class C, class P>
constexpr auto by(C& c, P& p) {
  return [&](auto&& x, auto&& y) -> bool { return std::invoke(c, std::invoke(p, x), std::invoke(p, y)); };
}
template <class F, class P>
constexpr auto of(F& f, P& p) {
  return [&](auto&& x) -> bool { return static_cast<bool>(std::invoke(f, std::invoke(p, x))); };
}
template <class T, class P>
constexpr auto is(const T& v, P& p) {
  return [&](auto&& x) -> bool { return std::invoke(p, x) == v; };
}
}  // namespace old

// NAME(range, parameters), computed by `how` from its ends, first and last.
#define GASJET_RANGE(NAME, TEMPLATE, PARAMETERS, HOW)                   \
  struct NAME##_function {                                              \
    template <old::Range R GASJET_LIST TEMPLATE>                        \
    constexpr auto operator()(R&& range GASJET_LIST PARAMETERS) const { \
      using std::begin, std::end;                                       \
      const auto first = begin(range);                                  \
      const auto last = end(range);                                     \
      HOW;                                                              \
    }                                                                   \
  };                                                                    \
  inline constexpr NAME##_function NAME{};
#define GASJET_LIST(...) __VA_OPT__(, ) __VA_ARGS__
#define GASJET_VALUE(NAME, HOW) GASJET_RANGE(NAME, (class T, class P = identity), (const T& v, P p = {}), HOW)
#define GASJET_IF(NAME)                                              \
  GASJET_RANGE(NAME, (class F, class P = identity), (F f, P p = {}), \
               return std::NAME(first, last, old::of(f, p)))
#define GASJET_SORTED(NAME, HOW) \
  GASJET_RANGE(NAME, (class C = std::less<>, class P = identity), (C c = {}, P p = {}), HOW)
#define GASJET_BOUND(NAME, HOW)                                                                              \
  GASJET_RANGE(NAME, (class T, class C = std::less<>, class P = identity), (const T& v, C c = {}, P p = {}), \
               HOW)
#define GASJET_TWO(NAME)                                    \
  GASJET_RANGE(NAME, (class B, class O), (const B& b, O o), \
               return std::NAME(first, last, std::begin(b), std::end(b), o))

GASJET_IF(find_if)
GASJET_IF(find_if_not)
GASJET_IF(any_of)
GASJET_IF(all_of)
GASJET_IF(none_of)
GASJET_IF(count_if)
GASJET_IF(partition_point)
GASJET_VALUE(find, return std::find_if(first, last, old::is(v, p)))
GASJET_VALUE(count, return std::count_if(first, last, old::is(v, p)))
GASJET_SORTED(max_element, return std::max_element(first, last, old::by(c, p)))
GASJET_SORTED(min_element, return std::min_element(first, last, old::by(c, p)))
GASJET_SORTED(minmax_element, const auto two = std::minmax_element(first, last, old::by(c, p));
              return (minmax_result<decltype(std::begin(range))>{two.first, two.second}))
GASJET_SORTED(sort, std::sort(first, last, old::by(c, p)); return last)
GASJET_SORTED(stable_sort, std::stable_sort(first, last, old::by(c, p)); return last)
GASJET_BOUND(lower_bound, return std::lower_bound(first, last, v, [&](auto&& x, auto&& y) -> bool {
               return std::invoke(c, std::invoke(p, x), y);
             }))
GASJET_BOUND(upper_bound, return std::upper_bound(first, last, v, [&](auto&& x, auto&& y) -> bool {
               return std::invoke(c, x, std::invoke(p, y));
             }))
GASJET_BOUND(binary_search, const auto at = lower_bound(range, v, c, p);
             return at != last && !std::invoke(c, v, std::invoke(p, *at)))
GASJET_RANGE(nth_element, (class I, class C = std::less<>, class P = identity), (I n, C c = {}, P p = {}),
             std::nth_element(first, n, last, old::by(c, p));
             return last)
GASJET_RANGE(adjacent_find, (class F = std::equal_to<>, class P = identity), (F f = {}, P p = {}),
             return std::adjacent_find(first, last, old::by(f, p)))
GASJET_RANGE(fill, (class T), (const T& v), std::fill(first, last, v); return last)
GASJET_RANGE(replace, (class T), (const T& a, const T& b), std::replace(first, last, a, b); return last)
GASJET_RANGE(replace_if, (class F, class T), (F f, const T& v), std::replace_if(first, last, f, v);
             return last)
GASJET_RANGE(reverse, (), (), std::reverse(first, last); return last)
GASJET_RANGE(copy_if, (class O, class F), (O o, F f), std::copy_if(first, last, o, f); return last)
GASJET_RANGE(includes, (class B), (const B& b), return std::includes(first, last, std::begin(b), std::end(b)))
GASJET_RANGE(find_first_of, (class B, class F = std::equal_to<>), (const B& b, F f = {}),
             return std::find_first_of(first, last, std::begin(b), std::end(b), f))
GASJET_RANGE(copy, (class O), (O o),
             return (in_out_result<decltype(std::begin(range)), O>{last, std::copy(first, last, o)}))
GASJET_RANGE(move, (class O), (O o),
             return (in_out_result<decltype(std::begin(range)), O>{last, std::move(first, last, o)}))
GASJET_RANGE(transform, (class O, class F, class P = identity), (O o, F f, P p = {}),
             for (auto at = first; at != last; ++at) * o++ = std::invoke(f, std::invoke(p, *at));
             return (in_out_result<decltype(std::begin(range)), O>{last, o}))
GASJET_TWO(set_union)
GASJET_TWO(set_difference)
GASJET_TWO(set_intersection)

// Of a range or a list; minmax of two values too.
#define GASJET_EXTREME(NAME)                                                  \
  struct NAME##_function {                                                    \
    template <old::Range R, class C = std::less<>, class P = identity>        \
    constexpr old::Value<R> operator()(R&& r, C c = {}, P p = {}) const {     \
      return *std::NAME##_element(std::begin(r), std::end(r), old::by(c, p)); \
    }                                                                         \
    template <class T>                                                        \
    constexpr T operator()(std::initializer_list<T> r) const {                \
      return *std::NAME##_element(r.begin(), r.end());                        \
    }                                                                         \
  };                                                                          \
  inline constexpr NAME##_function NAME{};
GASJET_EXTREME(max)
GASJET_EXTREME(min)
struct minmax_function {
  template <old::Range R, class C = std::less<>, class P = identity>
  constexpr minmax_result<old::Value<R>> operator()(R&& r, C c = {}, P p = {}) const {
    const auto two = std::minmax_element(std::begin(r), std::end(r), old::by(c, p));
    return {*two.first, *two.second};
  }
  template <class T>
  constexpr minmax_result<T> operator()(std::initializer_list<T> r) const {
    const auto two = std::minmax_element(r.begin(), r.end());
    return {*two.first, *two.second};
  }
  template <class T>
  requires(!old::Range<T>) constexpr minmax_result<const T&> operator()(const T& a, const T& b) const {
    return b < a ? minmax_result<const T&>{b, a} : minmax_result<const T&>{a, b};
  }
};
inline constexpr minmax_function minmax{};

}  // namespace ranges

#ifndef __cpp_lib_bit_cast
template <class To, class From>
requires(sizeof(To) == sizeof(From)) constexpr To bit_cast(const From& from) noexcept {
  return __builtin_bit_cast(To, from);
}
#endif
#ifndef __cpp_lib_smart_ptr_for_overwrite
template <class T>
requires(is_unbounded_array_v<T>) unique_ptr<T> make_unique_for_overwrite(size_t n) {
  return unique_ptr<T>(new remove_extent_t<T>[n]);
}
#endif

// musl's strtod rounds correctly. The grammar of from_chars is a part of its own: no white space, no plus, no
// hexadecimal.
template <class T>
requires(is_floating_point_v<T>) from_chars_result from_chars(const char* first, const char* last, T& value) {
  const char* p = first != last && *first == '-' ? first + 1 : first;
  const auto is_digit = [&](const char* at) { return at < last && *at >= '0' && *at <= '9'; };
  const auto is_word = [&](const char* word) { return last - p >= 3 && strncasecmp(p, word, 3) == 0; };
  const bool is_number = is_digit(p) || (p != last && *p == '.' && is_digit(p + 1));
  if (!is_number && !is_word("inf") && !is_word("nan")) return {first, errc::invalid_argument};
  const bool is_hexadecimal = is_digit(p) && *p == '0' && p + 1 != last && (p[1] == 'x' || p[1] == 'X');
  const string copy(first, is_hexadecimal ? p + 1 : last);
  char* end = nullptr;
  const int before = errno;
  errno = 0;
  T read;
  if constexpr (is_same_v<T, double>)
    read = strtod(copy.c_str(), &end);
  else
    read = strtold(copy.c_str(), &end);
  const int code = errno;
  errno = before;
  const char* const at = first + (end - copy.c_str());
  if (code == ERANGE && (isinf(read) || read == T(0))) return {at, errc::result_out_of_range};
  value = read;
  return {at, errc{}};
}

inline to_chars_result to_chars(char* first, char* last, double value, chars_format, int precision) {
  char text[400];
  const int length = snprintf(text, sizeof text, "%.*g", precision, value);
  if (length > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(length));
  return {first + length, errc{}};
}

// The fewest digits that give the number again, as a decimal fraction or with an exponent, whichever is
// shorter.
inline to_chars_result to_chars(char* first, char* last, double value) {
  if (!isfinite(value)) return to_chars(first, last, value, chars_format::general, 6);
  char scientific[400], fixed[400];
  int digits = 1;
  int length = snprintf(scientific, sizeof scientific, "%.0e", value);
  while (strtod(scientific, nullptr) != value)
    length = snprintf(scientific, sizeof scientific, "%.*e", digits++, value);
  const int exponent = atoi(strchr(scientific, 'e') + 1);
  const int decimals = digits - 1 - exponent;
  const int plain = snprintf(fixed, sizeof fixed, "%.*f", decimals > 0 ? decimals : 0, value);
  const char* const text = plain <= length ? fixed : scientific;
  length = plain <= length ? plain : length;
  if (length > last - first) return {last, errc::value_too_large};
  memcpy(first, text, static_cast<size_t>(length));
  return {first + length, errc{}};
}
_LIBCPP_END_NAMESPACE_STD
#endif
#endif
