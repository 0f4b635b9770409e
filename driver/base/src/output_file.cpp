// SPDX-License-Identifier: Apache-2.0
// Files that are complete at every moment.
#include "base/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace driver {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& file) {
  throw OutputError(fmt::format("{}: not writable ({})", file.string(), std::strerror(errno)));
}

[[noreturn]] void fail(const std::filesystem::path& file, const char* what, int code) {
  throw WriteError(fmt::format("{}: {} ({})", file.string(), what, std::strerror(code)));
}

struct Written {
  std::size_t count = 0;
  int error = 0;  // the error that stopped writing
};

Written write_all(int descriptor, std::string_view text) {
  Written written;
  while (written.count < text.size()) {
    const ssize_t more = ::write(descriptor, text.data() + written.count, text.size() - written.count);
    if (more < 0 && errno == EINTR) continue;
    if (more < 0) return {written.count, errno};
    written.count += static_cast<std::size_t>(more);
  }
  return written;
}

int open_new(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (descriptor < 0) refuse(file);
  return descriptor;
}

struct Part {
  std::filesystem::path path;
  int descriptor;
};

// Opens a part file of this writer alone: if two write one file at once, each renames a complete one.
Part open_part(const std::filesystem::path& target) {
  for (int n = 0;; ++n) {
    const std::filesystem::path path = target.string() + part_suffix + (n == 0 ? "" : std::to_string(n));
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor < 0 && errno == EEXIST) continue;
    if (descriptor < 0) refuse(target);
    return {path, descriptor};
  }
}

// The error of writing or closing, 0 if there was none.
int write_and_close(int descriptor, std::string_view text) {
  const int code = write_all(descriptor, text).error;
  return ::close(descriptor) != 0 && code == 0 ? errno : code;
}

}  // namespace

void replace_file(const std::filesystem::path& file, const std::string& text) {
  std::error_code ignored;
  const auto status = std::filesystem::status(file, ignored);
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    const int code = write_and_close(open_new(file), text);  // a device or a pipe
    if (code != 0) fail(file, "write failed", code);
    return;
  }
  const auto target = std::filesystem::exists(status) ? std::filesystem::canonical(file) : file;
  if (std::filesystem::exists(status) && ::access(target.c_str(), W_OK) != 0) refuse(file);
  const Part part = open_part(target);
  int code = write_and_close(part.descriptor, text);
  if (code == 0 && ::rename(part.path.c_str(), target.c_str()) != 0) code = errno;
  if (code == 0) return;
  ::unlink(part.path.c_str());
  fail(file, "write failed", code);
}

GrowingFile::GrowingFile(const std::filesystem::path& file, bool keep) : file_(file) {
  descriptor_ = ::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC | (keep ? 0 : O_TRUNC), 0666);
  if (descriptor_ < 0) refuse(file);
}

GrowingFile::~GrowingFile() {
  ::close(descriptor_);
}

void GrowingFile::append(std::string_view rows) {
  const off_t before = ::lseek(descriptor_, 0, SEEK_END);
  const Written written = write_all(descriptor_, rows);
  if (written.error == 0) return;
  const std::size_t whole = rows.substr(0, written.count).rfind('\n') + 1;  // 0 if there is none
  const bool cut = before >= 0 && ::ftruncate(descriptor_, before + static_cast<off_t>(whole)) == 0;
  fail(file_, cut ? "write failed" : "write failed, its last row is incomplete", written.error);
}

}  // namespace driver
