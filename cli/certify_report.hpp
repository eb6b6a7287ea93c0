// What `graze certify` found, for people and for programs.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <ostream>
#include <string>
#include <vector>

#include "fuzz/certify/campaign.hpp"

namespace graze::cli {

struct CertifyReport {
  std::string kernel, about;
  fuzz::Deviations deviations;  ///< that the kernel declares
  std::uint64_t seed = 0;
  std::uint64_t cases = 0;  ///< per family and precision, as asked
  std::uint64_t second_oracle_every = 0;
  bool is_interrupted = false;
  double seconds = 0;
  std::vector<fuzz::Row> rows;

  [[nodiscard]] fuzz::Tally total() const;
  [[nodiscard]] std::uint64_t lost_rays() const;
  /// Not interrupted, and rays could be aimed at every mesh.
  [[nodiscard]] bool is_complete() const;
  /// Everything agrees and the run is complete.
  [[nodiscard]] bool is_clean() const;
};

/// One verdict line, then the tables, then the worst offenders with the command that replays each.
void print(const CertifyReport& report, std::ostream& out);

[[nodiscard]] nlohmann::json to_json(const CertifyReport& report);

}  // namespace graze::cli
