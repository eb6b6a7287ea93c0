#include "fuzz/plugins/process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <mutex>
#include <thread>

#include "fuzz/plugins/keeper.hpp"

extern char** environ;

namespace graze::fuzz {
namespace {

using Clock = std::chrono::steady_clock;

/// For poll: milliseconds until then, rounded up.
int until(Clock::time_point deadline) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now()).count();
  return static_cast<int>(std::clamp<long long>(left, 0, 1 << 30));
}

Clock::time_point after(Process::Seconds limit) {
  return Clock::now() + std::chrono::duration_cast<Clock::duration>(limit);
}

struct Pipe {
  int read = -1, write = -1;
};

/// Both ends are closed in every program that is started, but for what it is given by name.
bool open_pipe(Pipe& pipe) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return false;
  for (const int end : ends) ::fcntl(end, F_SETFD, FD_CLOEXEC);
  pipe = {ends[0], ends[1]};
  return true;
}

void close_pipe(const Pipe& pipe) {
  if (pipe.read >= 0) ::close(pipe.read);
  if (pipe.write >= 0) ::close(pipe.write);
}

/// posix_spawnp with input and output redirected, in a group of its own, with no signal blocked or ignored. 0 or an errno.
int spawn(const std::vector<std::string>& command, int input, int output, pid_t& pid) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawnattr_t attributes;
  posix_spawn_file_actions_init(&actions);
  posix_spawnattr_init(&attributes);
  posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, output, STDOUT_FILENO);
  sigset_t none, ours;
  sigemptyset(&none);
  sigemptyset(&ours);
  for (const int signal : {SIGPIPE, SIGINT, SIGTERM}) sigaddset(&ours, signal);
  posix_spawnattr_setsigmask(&attributes, &none);
  posix_spawnattr_setsigdefault(&attributes, &ours);
  posix_spawnattr_setpgroup(&attributes, 0);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGMASK | POSIX_SPAWN_SETSIGDEF | POSIX_SPAWN_SETPGROUP);
  const int error = posix_spawnp(&pid, words[0], &actions, &attributes, words.data(), environ);
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error;
}

}  // namespace

std::variant<std::unique_ptr<Process>, std::string> Process::start(const std::vector<std::string>& command) {
  // One at a time: between a pipe's making and its flag another thread's program would inherit it.
  static std::mutex starting;
  const std::scoped_lock lock(starting);
  const Keeper& keeper = Keeper::instance();
  Pipe in, out;
  pid_t pid = 0;
  int error = 0;
  if (!open_pipe(in) || !open_pipe(out)) {
    error = errno;
  } else {
    error = spawn(command, in.read, out.write, pid);
  }
  if (error != 0) {
    close_pipe(in);
    close_pipe(out);
    return std::string("cannot be started: ") + std::strerror(error);
  }
  keeper.add(pid);
  ::close(in.read);
  ::close(out.write);
  ::fcntl(in.write, F_SETFL, O_NONBLOCK);
  ::fcntl(out.read, F_SETFL, O_NONBLOCK);
  return std::unique_ptr<Process>(new Process(pid, in.write, out.read));
}

Process::~Process() {
  std::vector<std::string> ignored;
  if (!is_reaped_ && in_ >= 0) (void)run({}, 0, ignored, Seconds(1));
  close_input();
  ::close(out_);
  kill();
}

void Process::close_input() {
  if (in_ >= 0) ::close(in_);
  in_ = -1;
}

bool Process::take_line(std::vector<std::string>& lines) {
  while (!read_.empty()) {
    std::size_t end = read_.find('\n');
    if (end == std::string::npos && !is_at_end_) return false;
    end = std::min(end, read_.size());
    std::string line = read_.substr(0, end);
    read_.erase(0, end + 1);
    if (!line.empty() && line.back() == '\r') line.pop_back();
    const std::size_t first = line.find_first_not_of(" \t");
    if (first == std::string::npos || line[first] == '#') continue;
    lines.push_back(std::move(line));
    return true;
  }
  return false;
}

bool Process::is_line_too_long() const {
  return read_.size() > longest_line && read_.find('\n') == std::string::npos;
}

bool Process::exchange(std::string_view& text, Clock::time_point deadline) {
  std::array<pollfd, 2> ends{{{out_, POLLIN, 0}, {in_, POLLOUT, 0}}};
  const int ready = ::poll(ends.data(), text.empty() ? 1 : 2, until(deadline));
  if (ready <= 0) return Clock::now() < deadline;
  if (ends[0].revents != 0) {
    std::array<char, 65536> buffer;
    const ssize_t n = ::read(out_, buffer.data(), buffer.size());
    if (n > 0) read_.append(buffer.data(), static_cast<std::size_t>(n));
    if (n == 0 || (n < 0 && errno != EAGAIN && errno != EINTR)) is_at_end_ = true;
  }
  if (!text.empty() && ends[1].revents != 0) {
    const ssize_t n = ::write(in_, text.data(), text.size());
    if (n > 0) text.remove_prefix(static_cast<std::size_t>(n));
    // It does not read any more: what it has written decides.
    if (n < 0 && errno != EAGAIN && errno != EINTR) text = {};
  }
  return true;
}

Process::Outcome Process::ask(std::string_view text, std::size_t count, std::vector<std::string>& lines, Seconds limit) {
  const std::size_t wanted = lines.size() + count;
  Clock::time_point deadline = after(limit);
  while (true) {
    while (lines.size() < wanted && take_line(lines)) deadline = after(limit);
    if (lines.size() == wanted && text.empty()) return Outcome::answered;
    if (is_at_end_) return Outcome::ended;
    if (is_line_too_long()) return Outcome::too_long;
    if (!exchange(text, deadline)) return Outcome::hung;
  }
}

Process::Outcome Process::run(std::string_view text, std::size_t most, std::vector<std::string>& lines, Seconds limit) {
  Clock::time_point deadline = after(limit);
  while (true) {
    if (text.empty()) close_input();
    while (take_line(lines)) {
      if (lines.size() > most) return Outcome::answered;
      deadline = after(limit);
    }
    if (is_at_end_) return Outcome::ended;
    if (is_line_too_long()) return Outcome::too_long;
    if (!exchange(text, deadline)) return Outcome::hung;
  }
}

void Process::kill() {
  if (is_reaped_) return;
  // Until it is waited for, its number is the group's.
  ::kill(-pid_, SIGKILL);
  Keeper::instance().remove(pid_);
  int status = 0;
  while (::waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  exit_status_ = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  is_reaped_ = true;
}

std::string Process::end() {
  close_input();
  const Clock::time_point deadline = after(Seconds(1));
  while (!is_reaped_) {
    siginfo_t ended{};
    const int error = ::waitid(P_PID, static_cast<id_t>(pid_), &ended, WEXITED | WNOHANG | WNOWAIT);
    if ((error == 0 && ended.si_pid == pid_) || (error != 0 && errno != EINTR)) {
      kill();  // what it has left behind
    } else if (Clock::now() >= deadline) {
      kill();
      return "closed its output";
    } else {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  if (exit_status_ <= 128) return "ended with status " + std::to_string(exit_status_);
  const int signal = exit_status_ - 128;
  return "crashed (signal " + std::to_string(signal) + ", " + strsignal(signal) + ")";
}

}  // namespace graze::fuzz
