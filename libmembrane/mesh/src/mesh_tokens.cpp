// SPDX-License-Identifier: Apache-2.0
#include "mesh_tokens.hpp"

#include <algorithm>
#include <charconv>

#include "mesh/mesh_file.hpp"
#include "mesh_text.hpp"

namespace mesh {

namespace {

bool is_space(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\v' || c == '\f';
}

}  // namespace

void TokenReader::fail(const MeshWord& at, const std::string& message) const {
  if (has_bytes_) throw MeshFileError(name_, 0, 0, "at byte " + std::to_string(at_) + ": " + message);
  throw MeshFileError(name_, at.line, at.column, message);
}

void TokenReader::skip_blanks() {
  for (; at_ < text_.size() && is_space(text_[at_]); ++at_)
    if (text_[at_] == '\n') {
      ++line_;
      line_begin_ = at_ + 1;
    }
}

bool TokenReader::at_end() {
  skip_blanks();
  return at_ == text_.size();
}

MeshWord TokenReader::peek(const char* what) {
  skip_blanks();
  const MeshWord here{{}, line_, at_ - line_begin_ + 1};
  if (at_ == text_.size()) fail(here, std::string("the file ends here: ") + what + " is missing");
  std::size_t end = at_;
  while (end < text_.size() && !is_space(text_[end])) ++end;
  return {text_.substr(at_, end - at_), here.line, here.column};
}

MeshWord TokenReader::word(const char* what) {
  const MeshWord found = peek(what);
  at_ += found.text.size();
  return found;
}

MeshWord TokenReader::expect(std::string_view text) {
  const MeshWord found = word(std::string(text).c_str());
  if (upper_case(found.text) != upper_case(text))
    fail(found, shown(found.text) + " stands where " + std::string(text) + " is needed");
  return found;
}

double TokenReader::number(const char* what) {
  const MeshWord found = word(what);
  double value = 0.0;
  if (const std::string fault = number_fault(found.text, value); !fault.empty())
    fail(found, std::string(what) + ": " + fault);
  return value;
}

long long TokenReader::integer(const char* what, long long low, long long high) {
  const MeshWord found = word(what);
  long long value = 0;
  const char* last = found.text.data() + found.text.size();
  const auto [end, error] = std::from_chars(found.text.data(), last, value);
  if (error != std::errc() || end != last || value < low || value > high)
    fail(found, std::string(what) + " is " + shown(found.text) + ", allowed: a whole number from " +
                    std::to_string(low) + " to " + std::to_string(high));
  return value;
}

std::size_t TokenReader::count(const char* what) {
  const auto most = static_cast<long long>((text_.size() - at_) / 2 + 1);
  return static_cast<std::size_t>(integer(what, 0, most));
}

void TokenReader::next_line() {
  rest_of_line();
  if (at_ == text_.size()) return;
  ++at_;
  ++line_;
  line_begin_ = at_;
}

std::string_view TokenReader::bytes(std::size_t count, const char* what) {
  has_bytes_ = true;
  if (count > text_.size() - at_) fail({}, std::string("the file ends here: ") + what + " is missing");
  const std::string_view found = text_.substr(at_, count);
  at_ += count;
  return found;
}

bool TokenReader::begins_with(std::string_view text) {
  if (has_bytes_) return text_.substr(at_).starts_with(text);
  return !at_end() && upper_case(peek("").text) == text;
}

void TokenReader::find_line(const std::string& text) {
  const std::size_t found = text_.find("\n" + text, at_);
  if (found == std::string_view::npos) fail({{}, line_, 1}, "the file ends before " + text);
  while (at_ <= found) next_line();
}

std::string_view TokenReader::rest_of_line() {
  const std::size_t end = std::min(text_.find('\n', at_), text_.size());
  std::string_view rest = text_.substr(at_, end - at_);
  at_ = end;
  while (!rest.empty() && is_space(rest.front())) rest.remove_prefix(1);
  while (!rest.empty() && is_space(rest.back())) rest.remove_suffix(1);
  return rest;
}

}  // namespace mesh
