// SPDX-License-Identifier: Apache-2.0
// Common to all functions of the border: exceptions become a status and a text, handles become objects.
#pragma once

#include <gasjet/base.h>

#include <array>
#include <atomic>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>

#include "environment.hpp"

namespace border {

/// Bad input; what() is `argument: fault, allowed values`.
struct Refusal : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};
/// Any other status, with its text.
struct Failure : std::runtime_error {
  Failure(int which, const std::string& what) : std::runtime_error(what), status(which) {}
  int status;
};

[[noreturn]] void refuse(std::string_view argument, const std::string& what);

/// The text of this thread's last failure.
const char* last_error() noexcept;
/// Sets it and returns the status. A text that is too long is cut.
int fail(int status, const char* what) noexcept;
/// Status of the exception that is being handled.
int fail_by_exception() noexcept;

/// Runs a function of the interface in the default floating-point environment, and lets no exception out. The
/// function may take the environment as an argument, for callbacks.
template <class F>
int call(F&& f) noexcept {
  Environment environment;
  try {
    if constexpr (std::invocable<F, Environment&>)
      f(environment);
    else
      f();
    return fail(GASJET_OK, "");
  } catch (...) {
    return fail_by_exception();
  }
}

/// The object of a handle. An object that calls change is used by one thread at a time.
struct Object {
  virtual ~Object() = default;
  std::atomic_flag busy = ATOMIC_FLAG_INIT;
};

/// Handles of this library are larger. Each library has its own range, so that it refuses another library's
/// handle.
extern const gasjet_handle kHandlesBegin;

gasjet_handle keep(std::shared_ptr<Object> object);
/// Finds an object; refuses an invalid handle. `argument` is its name in messages.
std::shared_ptr<Object> find(gasjet_handle handle, std::string_view argument);
/// Releases an object; refuses a handle that is invalid or in use.
void release(gasjet_handle handle);

/// The object of a handle during a call, locked unless Type::shared.
template <class Type>
class Use {
 public:
  Use(gasjet_handle handle, std::string_view argument)
      : object_(std::dynamic_pointer_cast<Type>(find(handle, argument))) {
    if (!object_) refuse(argument, "is a handle of another kind, allowed: " + std::string(Type::name));
    if (Type::shared) return;
    if (object_->busy.test_and_set(std::memory_order_acquire))
      throw Failure(GASJET_BUSY,
                    std::string(argument) + ": is used by another thread, allowed: one at a time");
    locked_ = true;
  }
  ~Use() {
    if (locked_) object_->busy.clear(std::memory_order_release);
  }
  Use(const Use&) = delete;
  Use& operator=(const Use&) = delete;
  Type* operator->() const { return object_.get(); }
  Type& operator*() const { return *object_; }

 private:
  std::shared_ptr<Type> object_;
  bool locked_ = false;
};

/// Checks a pointer argument: not NULL, and aligned.
template <class T>
T& needed(T* pointer, std::string_view argument) {
  if (pointer == nullptr) refuse(argument, "is NULL, allowed: an address");
  if (reinterpret_cast<std::uintptr_t>(pointer) % alignof(T) != 0)
    refuse(argument, "is not aligned to the size of its elements, allowed: an aligned address");
  return *pointer;
}
std::string text(const char* pointer, std::string_view argument);
std::string text_or(const char* pointer, const char* otherwise);
/// The path of a file or folder, a text that is not empty.
std::string path(const char* pointer, std::string_view argument);
/// "" for NULL.
std::string path_or_none(const char* pointer, std::string_view argument);

/// Refuses a number that is not finite, or out of [low, high].
double number(double value, std::string_view argument, double low = -std::numeric_limits<double>::max(),
              double high = std::numeric_limits<double>::max());
/// Refuses a number that is not finite and above 0.
double positive(double value, std::string_view argument);

inline std::string not_finite(std::string_view name) {
  return std::string(name) + ": is not finite, allowed: inputs with a finite result";
}
/// Returns the result, a number or a structure of numbers; GASJET_DOMAIN if one is not finite.
template <class Result>
const Result& finite(const Result& result, std::string_view name) {
  static_assert(std::is_trivially_copyable_v<Result> && sizeof(Result) % sizeof(double) == 0);
  std::array<double, sizeof(Result) / sizeof(double)> numbers;
  std::memcpy(numbers.data(), &result, sizeof(Result));
  for (const double one : numbers)
    if (!std::isfinite(one)) throw Failure(GASJET_DOMAIN, not_finite(name));
  return result;
}

/// Writes `value` with a closing 0 into a caller's text; refuses a size that is too small.
void write_text(const std::string& value, char* to, int64_t size, std::string_view argument);
/// The same for a text whose size the caller may ask for.
void write_sized(const std::string& value, char* to, int64_t size, int64_t* needed_size);

/// A text without blanks, tabs and returns around it.
std::string_view trim(std::string_view text);
/// A number as a message shows it.
std::string shown(double value);
/// The number in a text, with a decimal point in every locale; NaN if it is not a number.
double number_in(std::string_view text);

}  // namespace border
