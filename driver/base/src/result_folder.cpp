// SPDX-License-Identifier: Apache-2.0
#include "base/result_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

namespace driver {
namespace {

[[noreturn]] void refuse(const std::filesystem::path& folder, const std::string& message) {
  throw OutputError(fmt::format("--out {}: {}", folder.string(), message));
}

bool holds_files(const std::filesystem::path& folder) {
  return std::ranges::any_of(std::filesystem::directory_iterator(folder), [](const auto& entry) {
    return !entry.is_directory() && entry.path().filename() != status_file;
  });
}

}  // namespace

void ResultFolder::require_free(const std::filesystem::path& folder, const std::string& command,
                                bool is_known) {
  std::error_code ignored;
  if (!std::filesystem::exists(folder, ignored)) return;
  const auto status = read_status(folder);
  const bool is_made = status && !status->run.empty();
  if (is_made && status->command != command)
    refuse(folder, fmt::format("contains the results of gasjet {}: name another folder", status->command));
  if (!is_made && !is_known && holds_files(folder))
    refuse(folder,
           fmt::format("contains files, but gasjet {} did not create it: name another folder", command));
}

ResultFolder::ResultFolder(std::filesystem::path folder, std::string command, bool is_known)
    : path_(std::move(folder)), command_(std::move(command)) {
  std::error_code error;
  std::filesystem::create_directories(path_, error);
  if (error) refuse(path_, error.message());
  if (::access(path_.c_str(), W_OK | X_OK) != 0) refuse(path_, "the folder is not writable");
  require_free(path_, command_, is_known);
  lock();
  try {
    require_free(path_, command_, is_known);  // what may have come before the lock
    if (const auto status = read_status(path_)) earlier_ = *status;
  } catch (...) {
    leave();
    throw;
  }
}

ResultFolder::~ResultFolder() {
  try {
    if (!run_.empty() && !ended_) mark("status: failed\n", false);
  } catch (const WriteError&) {  // a full disk: it stays as not ended
  }
  leave();
}

void ResultFolder::leave() {
  // Of a command that was refused nothing stays; lock() sees that the file has gone.
  if (run_.empty() && earlier_.run.empty()) ::unlink((path_ / status_file).c_str());
  ::close(descriptor_);
}

void ResultFolder::lock() {
  const auto file = path_ / status_file;
  for (;;) {
    descriptor_ = ::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0) refuse(path_, fmt::format("{}: {}", status_file, std::strerror(errno)));
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) break;
    struct stat here {
    }, named{};
    if (::fstat(descriptor_, &here) == 0 && ::stat(file.c_str(), &named) == 0 &&
        here.st_ino == named.st_ino && here.st_dev == named.st_dev)
      return;
    ::close(descriptor_);  // another command has removed it in between
  }
  const int code = errno;
  ::close(descriptor_);
  if (code == EWOULDBLOCK)
    refuse(path_, "another command is writing this folder: wait for its end, or name another folder");
  refuse(path_, fmt::format("{} cannot be locked: {}", status_file, std::strerror(code)));
}

void ResultFolder::mark(std::string_view text, bool anew) {
  if (anew && ::ftruncate(descriptor_, 0) != 0)
    throw WriteError(fmt::format("{}: {}", (path_ / status_file).string(), std::strerror(errno)));
  ::lseek(descriptor_, 0, SEEK_END);
  const ssize_t written = ::write(descriptor_, text.data(), text.size());
  if (written != static_cast<ssize_t>(text.size()))
    throw WriteError(fmt::format("{}: write failed (disk full?)", (path_ / status_file).string()));
}

void ResultFolder::begin(const Provenance& lines) {
  lines_ = lines;
  const auto given = std::ranges::find(lines_, "run", &Provenance::value_type::first);
  if (given == lines_.end()) {
    std::vector<std::string> facts;
    for (const auto& [key, value] : lines_)
      if (key != "date") facts.push_back(key + '=' + value);
    lines_.emplace_back("run", run_id(facts, {}));
  }
  run_ = std::ranges::find(lines_, "run", &Provenance::value_type::first)->second;
  const bool goes_on = earlier_.run == run_ && earlier_.files.contains(journal_file);
  // Should this be killed the files of the run before are still listed.
  if (!earlier_.files.empty()) mark(fmt::format("\nrun: {}\nstatus: running\n", run_), false);
  for (const auto& name : earlier_.files) {
    if (goes_on && name == journal_file) continue;
    std::error_code ignored;
    std::filesystem::remove(path_ / name, ignored);
    std::filesystem::remove(path_ / (name + part_suffix), ignored);
  }
  mark(fmt::format("{}\ncommand: {}\nrun: {}\nstatus: running\n{}", status_head, command_, run_,
                   goes_on ? fmt::format("file: {}\n", journal_file) : ""),
       true);
  listed_.clear();
  if (goes_on) listed_.insert(journal_file);
}

void ResultFolder::end(const std::string& status) {
  ended_ = true;
  mark(fmt::format("status: {}\n", status), false);
  if (status == "done") remove(journal_file);
}

std::filesystem::path ResultFolder::add(const std::string& name) {
  if (listed_.contains(name)) return path_ / name;
  if (std::error_code ignored;
      std::filesystem::exists(std::filesystem::symlink_status(path_ / name, ignored)))
    refuse(path_, fmt::format("{} exists, but gasjet did not write it: move it away", name));
  listed_.insert(name);
  mark(fmt::format("file: {}\n", name), false);
  return path_ / name;
}

void ResultFolder::write(const std::string& name, const std::string& text) {
  replace_file(add(name), text);
}

void ResultFolder::remove(const std::string& name) {
  std::error_code ignored;
  std::filesystem::remove(path_ / name, ignored);
}

}  // namespace driver
