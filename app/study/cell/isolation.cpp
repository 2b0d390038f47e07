// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include "app/study/cell/isolation.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include <leastcost/catalogue/output/write_run.hpp>

namespace leastcost::app {
namespace {

using Clock = std::chrono::steady_clock;

// First byte of what a child sends.
constexpr char kDone = 'd', kMemory = 'm', kError = 'e';

/// The longest the parent sleeps: a stop request is answered within this time.
constexpr int kLongestSleep = 200;  // ms

std::string last_error() { return std::generic_category().message(errno); }

class Descriptor {
 public:
  explicit Descriptor(int fd = -1) : fd_(fd) {}
  ~Descriptor() { close(); }
  Descriptor(Descriptor&& other) noexcept : fd_(other.fd_) { other.fd_ = -1; }
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(fd_, other.fd_);
    return *this;
  }
  int get() const { return fd_; }
  void close() {
    if (fd_ >= 0) ::close(fd_);
    fd_ = -1;
  }

 private:
  int fd_;
};

struct Child {
  std::size_t job = 0;
  pid_t pid = -1;
  Descriptor pipe, said;  ///< what it sends; its stdout and stderr, a file
  std::optional<Clock::time_point> deadline;
  std::string received;
  bool killed_in_time = false;
};

/// A file without a name, for what a child prints.
Descriptor nameless_file() {
  std::FILE* file = std::tmpfile();
  if (file == nullptr) return Descriptor();
  const int fd = ::fcntl(::fileno(file), F_DUPFD_CLOEXEC, 0);
  std::fclose(file);
  return Descriptor(fd);
}

void send_all(int fd, std::string_view text) {
  while (!text.empty()) {
    const ssize_t sent = ::write(fd, text.data(), text.size());
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) ::_exit(1);
    text.remove_prefix(static_cast<std::size_t>(sent));
  }
}

void limit(int what, rlim_t value) {
  const rlimit both{value, value};
  ::setrlimit(static_cast<__rlimit_resource_t>(what), &both);
}

/// The life of a child. Never returns: its parent's stack, streams and files are not its own.
[[noreturn]] void live(const IsolatedJob& job, int pipe, int said, pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before the line above
  ::signal(SIGINT, SIG_IGN);
  ::signal(SIGTERM, SIG_IGN);
  ::signal(SIGPIPE, SIG_IGN);
  if (said >= 0) {
    ::dup2(said, STDOUT_FILENO);
    ::dup2(said, STDERR_FILENO);
  }
  limit(RLIMIT_CORE, 0);
  if (job.max_memory > 0 && can_limit_memory()) limit(RLIMIT_AS, static_cast<rlim_t>(job.max_memory) << 20);
  try {
    send_all(pipe, kDone + job.work() + "\n");
  } catch (const std::bad_alloc&) {
    constexpr std::array<char, 2> kSaid = {kMemory, '\n'};  // no allocation here
    send_all(pipe, {kSaid.data(), kSaid.size()});
  } catch (const std::exception& e) {
    send_all(pipe, fmt::format("{}{}\n", kError, e.what()));
  } catch (...) {
    send_all(pipe, fmt::format("{}an unknown exception\n", kError));
  }
  ::_exit(0);
}

Child start(std::size_t index, const IsolatedJob& job) {
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0) throw HostError("no process for a cell: " + last_error());
  Child child;
  child.job = index;
  child.pipe = Descriptor(ends[0]);
  Descriptor write_end(ends[1]);
  child.said = nameless_file();
  const pid_t parent = ::getpid();
  child.pid = ::fork();
  if (child.pid == 0) live(job, write_end.get(), child.said.get(), parent);
  if (child.pid < 0) throw HostError("no process for a cell: " + last_error());
  if (job.max_seconds > 0)
    child.deadline =
        Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(job.max_seconds));
  return child;
}

int reap(const Child& child) {
  int status = 0;
  while (::waitpid(child.pid, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

void kill_all(std::vector<Child>& children) {
  for (const Child& child : children) ::kill(child.pid, SIGKILL);
  for (const Child& child : children) reap(child);
  children.clear();
}

/// The last line that a child printed, for the message of its crash.
std::string last_words(const Child& child) {
  std::array<char, 2000> text{};
  const off_t size = child.said.get() < 0 ? 0 : ::lseek(child.said.get(), 0, SEEK_END);
  const off_t from = std::max<off_t>(0, size - static_cast<off_t>(text.size()));
  const ssize_t got = size > 0 ? ::pread(child.said.get(), text.data(), text.size(), from) : 0;
  std::string_view words(text.data(), static_cast<std::size_t>(std::max<ssize_t>(got, 0)));
  while (!words.empty() && words.back() == '\n') words.remove_suffix(1);
  const std::size_t line = words.rfind('\n');
  return std::string(line == std::string_view::npos ? words : words.substr(line + 1));
}

IsolatedEnd end_of(const Child& child, int status) {
  using How = IsolatedEnd::How;
  const std::string& said = child.received;
  if (said.size() > 1 && said.back() == '\n') {
    std::string text = said.substr(1, said.size() - 2);
    if (said[0] == kDone) return {How::done, std::move(text)};
    if (said[0] == kMemory) return {How::memory, "out of memory"};
    return {How::error, std::move(text)};
  }
  if (child.killed_in_time) return {How::timeout, "killed after its time"};
  std::string text = "ended without a result";
  if (WIFSIGNALED(status)) text = fmt::format("signal {} ({})", WTERMSIG(status), ::strsignal(WTERMSIG(status)));
  const std::string words = last_words(child);
  return {How::crash, words.empty() ? text : text + ": " + words};
}

/// Takes what the child has sent; true when it has closed its end.
bool receive(Child& child) {
  std::array<char, 1 << 16> buffer;
  const ssize_t got = ::read(child.pipe.get(), buffer.data(), buffer.size());
  if (got < 0) return errno != EINTR && errno != EAGAIN;
  child.received.append(buffer.data(), static_cast<std::size_t>(got));
  return got == 0;
}

int sleep_until_deadline(const std::vector<Child>& children) {
  long sleep = kLongestSleep;
  for (const Child& child : children)
    if (child.deadline && !child.killed_in_time)
      sleep = std::min<long>(
          sleep, std::chrono::duration_cast<std::chrono::milliseconds>(*child.deadline - Clock::now()).count() + 1);
  return static_cast<int>(std::max(0L, sleep));
}

void kill_overdue(std::vector<Child>& children) {
  for (Child& child : children) {
    if (!child.deadline || child.killed_in_time || Clock::now() < *child.deadline) continue;
    child.killed_in_time = true;
    ::kill(child.pid, SIGKILL);
  }
}

/// Waits for something to happen and handles it.
void attend(std::vector<Child>& children, const IsolatedJobs& jobs) {
  std::vector<pollfd> watched;
  watched.reserve(children.size());
  for (const Child& child : children) watched.push_back({child.pipe.get(), POLLIN, 0});
  const int events = ::poll(watched.data(), watched.size(), sleep_until_deadline(children));
  kill_overdue(children);
  if (events <= 0) return;
  for (std::size_t i = children.size(); i-- > 0;) {
    if (watched[i].revents == 0 || !receive(children[i])) continue;
    const Child child = std::move(children[i]);
    children.erase(children.begin() + static_cast<std::ptrdiff_t>(i));
    jobs.ended(child.job, end_of(child, reap(child)));
  }
}

}  // namespace

bool can_limit_memory() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  return false;
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
  return false;
#else
  return true;
#endif
#else
  return true;
#endif
}

bool run_isolated(const IsolatedJobs& jobs) {
  std::vector<Child> children;
  const std::size_t parallel = static_cast<std::size_t>(std::max(1, jobs.parallel));
  std::size_t next = 0;
  try {
    while (next < jobs.count || !children.empty()) {
      if (jobs.stop_requested && jobs.stop_requested()) {
        kill_all(children);
        return false;
      }
      for (; next < jobs.count && children.size() < parallel; ++next) children.push_back(start(next, jobs.job(next)));
      attend(children, jobs);
    }
  } catch (...) {
    kill_all(children);
    throw;
  }
  return true;
}

}  // namespace leastcost::app
