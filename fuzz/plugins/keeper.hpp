// Sees to it that no process group outlives this program, however it ends.
#pragma once

#include <sys/types.h>

namespace graze::fuzz {

/// A process of its own that is told which process groups run, and ends those that are left when this program has ended: by a
/// second interrupt, by a crash, or by SIGKILL, which leave it no moment to do so itself.
class Keeper {
 public:
  /// The only one; started by the first call, which has to come before this program has pipes to others.
  [[nodiscard]] static const Keeper& instance();
  Keeper(const Keeper&) = delete;
  Keeper& operator=(const Keeper&) = delete;

  /// The group runs from now on.
  void add(pid_t group) const;
  /// It has been ended, or is about to be. To be told before its number may be given to another.
  void remove(pid_t group) const;

 private:
  Keeper();
  void tell(pid_t number) const;

  int pipe_ = -1;  ///< -1 where it could not be started: then nothing is kept
};

}  // namespace graze::fuzz
