#include "fuzz/plugins/keeper.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

namespace graze::fuzz {
namespace {

/// What the keeper runs: reads numbers of groups, negative ones of those that have ended, until nobody can write any more.
/// Between fork and _exit only calls that are safe in a signal handler.
[[noreturn]] void keep(int numbers) {
  // Out of reach of interrupts from the terminal, and of whoever waits for the end of this program's output.
  ::setpgid(0, 0);
  for (const int standard : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::close(standard);
  constexpr std::size_t most = 4096;
  static std::array<pid_t, most> groups;
  std::size_t count = 0;
  while (true) {
    pid_t number = 0;
    const ssize_t n = ::read(numbers, &number, sizeof number);
    if (n < 0 && errno == EINTR) continue;
    if (n != sizeof number) break;
    if (number > 0 && count < most) groups[count++] = number;
    if (number < 0)
      count = static_cast<std::size_t>(std::remove(groups.begin(), groups.begin() + count, -number) - groups.begin());
  }
  for (std::size_t i = 0; i < count; ++i) ::kill(-groups[i], SIGKILL);
  ::_exit(0);
}

}  // namespace

const Keeper& Keeper::instance() {
  static const Keeper keeper;
  return keeper;
}

Keeper::Keeper() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0) return;
  ::fcntl(ends[1], F_SETFD, FD_CLOEXEC);
  const pid_t keeper = ::fork();
  if (keeper == 0) {
    ::close(ends[1]);
    keep(ends[0]);
  }
  ::close(ends[0]);
  if (keeper > 0) {
    pipe_ = ends[1];
  } else {
    ::close(ends[1]);
  }
}

void Keeper::tell(pid_t number) const {
  // A keeper that is gone keeps nothing; the programs run all the same.
  while (pipe_ >= 0 && ::write(pipe_, &number, sizeof number) < 0 && errno == EINTR) {
  }
}

void Keeper::add(pid_t group) const {
  tell(group);
}

void Keeper::remove(pid_t group) const {
  tell(-group);
}

}  // namespace graze::fuzz
