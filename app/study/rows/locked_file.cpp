// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/rows/locked_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>
#include <utility>

#include <leastcost/catalogue/output/write_run.hpp>

namespace leastcost::app {
namespace {

std::string why_not() { return std::generic_category().message(errno); }

}  // namespace

LockedFile::LockedFile(std::filesystem::path file, const std::string& what) : file_(std::move(file)) {
  fd_ = ::open(file_.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0644);
  if (fd_ < 0) fail(why_not());
  // A killed predecessor's children may hold the lock for the moment it takes them to die.
  constexpr int kTries = 20;
  constexpr std::chrono::milliseconds kPause{50};
  for (int i = 0; ::flock(fd_, LOCK_EX | LOCK_NB) != 0; ++i) {
    if (i < kTries) {
      std::this_thread::sleep_for(kPause);
      continue;
    }
    forget();
    throw OutputRefused(file_.string() + ": another process is writing to " + what);
  }
}

LockedFile::~LockedFile() { forget(); }

LockedFile::LockedFile(LockedFile&& other) noexcept : file_(std::move(other.file_)), fd_(other.fd_) { other.fd_ = -1; }

void LockedFile::forget() {
  if (fd_ >= 0) ::close(fd_);
  fd_ = -1;
}

bool LockedFile::empty() const { return ::lseek(fd_, 0, SEEK_END) <= 0; }

void LockedFile::cut(std::size_t size) {
  if (::ftruncate(fd_, static_cast<off_t>(size)) != 0) fail(why_not());
}

void LockedFile::append(std::string_view text) {
  const off_t before = ::lseek(fd_, 0, SEEK_END);
  ssize_t written = -1;
  do {
    written = ::write(fd_, text.data(), text.size());
  } while (written < 0 && errno == EINTR);
  if (written == static_cast<ssize_t>(text.size())) return;
  const std::string reason = written < 0 ? why_not() : "the disk is full";
  if (written > 0 && ::ftruncate(fd_, before) != 0) {
    // Nothing more can be done: the torn line is cut off on resume.
  }
  fail(reason);
}

void LockedFile::sync() {
  if (::fdatasync(fd_) != 0) fail(why_not());
}

void LockedFile::fail(const std::string& reason) const {
  throw OutputError(fmt::format("{}: cannot be written: {}", file_.string(), reason));
}

}  // namespace leastcost::app
