// What a campaign found and on what: a value that can be written, read, merged and shown. Nothing in it depends on the time,
// the number of threads or the order of work.
#pragma once

#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "fuzz/certify/campaign.hpp"

namespace graze::fuzz {

struct MeshIdentity {
  std::string name;
  std::uint64_t triangles = 0;
  std::uint64_t hash = 0;  ///< of points and triangles
};

/// What the results are true of. Reports of one campaign agree in all of it.
struct Scope {
  std::string version;        ///< of graze
  std::string kernel, about;  ///< the subject's own words
  std::string options;        ///< that open it again, beside its name
  Deviations declared;        ///< by the subject
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;  ///< per family and precision
  std::uint64_t second_oracle_every = 0;
  std::vector<FloatMode> modes;  ///< floating-point modes in which the subject was asked each case
  std::vector<MeshIdentity> meshes;
  std::string compiler, flags;  ///< of the certifier and the built-in subjects
};

enum class Verdict { pass, fail, incomplete };
[[nodiscard]] std::string_view name_of(Verdict verdict);

struct Report {
  Scope scope;
  std::set<std::string> cpus;  ///< that took part
  std::set<Shard> shards;      ///< that it is to hold; none for the whole campaign
  std::vector<Row> rows;

  /// Of all rows. The offenders are the worst of all.
  [[nodiscard]] Part total() const;
  /// How many cases the answers are to: each is asked in every mode.
  [[nodiscard]] std::uint64_t cases_of(const Tally& tally) const { return tally.answers / scope.modes.size(); }
  /// Every row of the campaign is judged to its end.
  [[nodiscard]] bool is_whole() const;
  /// What it is to hold is judged to its end.
  [[nodiscard]] bool is_finished() const;
  /// Fail where anything is wrong; else incomplete unless finished with rays aimed at every mesh.
  [[nodiscard]] Verdict verdict() const;
};

/// The report of a campaign of which nothing is judged yet, by this build on this machine.
[[nodiscard]] Report blank_report(const Campaign& campaign, const Plan& plan, const Judges& judges, const Shard& shard);

/// The modes in a few words, a clause; empty for the default one alone.
[[nodiscard]] std::string modes_told(const Scope& scope);

/// The command that asks the kernel this case again.
[[nodiscard]] std::string replay_command(const Report& report, const Offender& offender);

}  // namespace graze::fuzz
