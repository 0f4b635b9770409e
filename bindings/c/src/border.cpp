// SPDX-License-Identifier: Apache-2.0
#include "border.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <new>
#include <unordered_map>

namespace border {
namespace {

thread_local std::array<char, 4096> error_text{};

struct Registry {
  std::mutex mutex;
  std::unordered_map<gasjet_handle, std::shared_ptr<Object>> objects;
  gasjet_handle last = kHandlesBegin;
};

Registry& registry() {
  static Registry* one = new Registry;  // never freed: other threads may still call while the program ends
  return *one;
}

}  // namespace

void refuse(std::string_view argument, const std::string& what) {
  throw Refusal(std::string(argument) + ": " + what);
}

const char* last_error() noexcept {
  return error_text.data();
}

int fail(int status, const char* what) noexcept {
  std::snprintf(error_text.data(), error_text.size(), "%s", what);
  return status;
}

int fail_by_exception() noexcept {
  try {
    throw;
  } catch (const Failure& failure) {
    return fail(failure.status, failure.what());
  } catch (const std::bad_alloc&) {
    return fail(GASJET_FAILED, "memory: is exhausted; use a smaller problem");
  } catch (const std::invalid_argument& error) {
    return fail(GASJET_BAD_INPUT, error.what());
  } catch (const std::runtime_error& error) {
    return fail(GASJET_DOMAIN, error.what());
  } catch (const std::exception& error) {
    return fail(GASJET_FAILED, error.what());
  } catch (...) {
    return fail(GASJET_FAILED, "an exception of unknown type");
  }
}

gasjet_handle keep(std::shared_ptr<Object> object) {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  all.objects.emplace(all.last + 1, std::move(object));
  return ++all.last;
}

std::shared_ptr<Object> find(gasjet_handle handle, std::string_view argument) {
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  const auto found = all.objects.find(handle);
  if (found != all.objects.end()) return found->second;
  const bool was = handle > kHandlesBegin && handle <= all.last;
  refuse(argument, was ? "was freed, allowed: a handle in use"
                       : "is not a handle, allowed: a handle from a create function");
}

void release(gasjet_handle handle) {
  const std::shared_ptr<Object> object = find(handle, "handle");
  if (object->busy.test_and_set(std::memory_order_acquire))
    throw Failure(GASJET_BUSY, "handle: is used by another thread, allowed: to free it later");
  Registry& all = registry();
  const std::lock_guard lock(all.mutex);
  all.objects.erase(handle);  // stays busy, so that a thread that found it just before gets an error
}

std::string text(const char* pointer, std::string_view argument) {
  needed(pointer, argument);
  return pointer;
}

std::string text_or(const char* pointer, const char* otherwise) {
  return pointer == nullptr ? otherwise : pointer;
}

std::string path(const char* pointer, std::string_view argument) {
  if (needed(pointer, argument) == '\0') refuse(argument, "is empty, allowed: a path");
  return pointer;
}

std::string path_or_none(const char* pointer, std::string_view argument) {
  return pointer == nullptr ? "" : path(pointer, argument);
}

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const auto first = text.find_first_not_of(blanks);
  return first == std::string_view::npos ? "" : text.substr(first, text.find_last_not_of(blanks) + 1 - first);
}

std::string shown(double value) {
  std::array<char, 40> digits{};
  return {digits.data(), std::to_chars(digits.begin(), digits.end(), value).ptr};
}

double number_in(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  return read.ec == std::errc() && read.ptr == end ? value : std::numeric_limits<double>::quiet_NaN();
}

double number(double value, std::string_view argument, double low, double high) {
  if (std::isfinite(value) && value >= low && value <= high) return value;
  std::string allowed = "a finite number";
  if (low > -std::numeric_limits<double>::max()) allowed += " of " + shown(low) + " or more";
  if (high < std::numeric_limits<double>::max()) allowed += ", at most " + shown(high);
  refuse(argument, "is " + shown(value) + ", allowed: " + allowed);
}

double positive(double value, std::string_view argument) {
  if (!std::isfinite(value) || !(value > 0.0))
    refuse(argument, "is " + shown(value) + ", allowed: a number above 0");
  return value;
}

void write_text(const std::string& value, char* to, int64_t size, std::string_view argument) {
  needed(to, argument);
  const auto room = static_cast<int64_t>(value.size()) + 1;
  if (size < room)
    refuse("size", "is " + std::to_string(size) + ", allowed: " + std::to_string(room) + " or more");
  std::memcpy(to, value.c_str(), value.size() + 1);
}

void write_sized(const std::string& value, char* to, int64_t size, int64_t* needed_size) {
  needed(needed_size, "needed") = static_cast<int64_t>(value.size()) + 1;
  if (to == nullptr && size == 0) return;  // the caller asks for the size
  write_text(value, to, size, "text");
}

}  // namespace border
