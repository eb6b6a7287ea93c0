// The table of `graze certify` that is kept for every built-in kernel: golden_table KERNEL, or golden_table for their names.
// 1,000 cases a family and precision with the default seed, and a mesh; what it depends on besides graze is its first line.
#include <CGAL/version.h>

#include <cstdio>
#include <iostream>
#include <string>

#include "fuzz/certify/campaign.hpp"

#if GRAZE_HAVE_EMBREE
#include <embree3/rtcore.h>
#endif

namespace {

using namespace graze::fuzz;

/// What the answers may depend on besides graze: libraries and, where they choose their code by it, the processor.
std::string dependence(const std::string& kernel) {
  if (kernel.starts_with("cgal")) return "CGAL " CGAL_VERSION_STR;
#if GRAZE_HAVE_EMBREE
  if (kernel.starts_with("embree")) {
    RTCDevice device = rtcNewDevice(nullptr);
    int widest = 4;
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY8_SUPPORTED) != 0) widest = 8;
    if (rtcGetDeviceProperty(device, RTC_DEVICE_PROPERTY_NATIVE_RAY16_SUPPORTED) != 0) widest = 16;
    rtcReleaseDevice(device);
    return "Embree " RTC_VERSION_STRING ", packets of " + std::to_string(widest);
  }
#endif
  return "nothing else";
}

void print(const Row& row) {
  const Part part = row.total();
  const Tally& t = part.tally;
  std::uint64_t allowed = 0;
  for (const std::uint64_t n : t.by_deviation) allowed += n;
  std::printf("%-28s %-6s %6llu %6llu", row.name.c_str(), row.precision.c_str(), static_cast<unsigned long long>(t.answers),
              static_cast<unsigned long long>(t.skipped));
  for (std::size_t i = 1; i < disagreement_count; ++i)
    std::printf(" %5llu", static_cast<unsigned long long>(t.by_disagreement[i]));
  std::printf(" %6llu %7llu %12.6g %5llu %5llu %016llx\n", static_cast<unsigned long long>(t.misrounded),
              static_cast<unsigned long long>(allowed), t.worst_ulps, static_cast<unsigned long long>(part.rays),
              static_cast<unsigned long long>(part.lost_rays), static_cast<unsigned long long>(part.input_hash));
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    for (const Subject* subject : subjects()) std::cout << subject->name() << '\n';
    return 0;
  }
  const Subject* subject = find_subject(argv[1]);
  if (subject == nullptr) {
    std::cerr << "golden_table: no kernel is named '" << argv[1] << "'\n";
    return 2;
  }
  Campaign campaign;
  campaign.cases = 1000;
  campaign.meshes = {icosphere(2)};
  for (const Family& family : families()) campaign.families.push_back(&family);
  const Plan plan(campaign);
  Ledger ledger(plan.rows());
  Progress progress;
  run(plan, {{subject}, graze::oracle::gmp_oracle(), graze::oracle::cgal_oracle(), 16}, {}, ledger, progress);
  std::printf("%s depends on %s\n", argv[1], dependence(argv[1]).c_str());
  std::printf("Columns: answers, not offered; then by what is wrong: ");
  for (std::size_t i = 1; i < disagreement_count; ++i) {
    std::printf("%s%s", i == 1 ? "" : ", ", std::string(name_of(static_cast<Disagreement>(i))).c_str());
  }
  std::printf(
      ";\nanswers with a number not correctly rounded, deviations allowed, worst error in ulps, rays at a mesh, lost rays, "
      "hash of inputs\n");
  for (const Row& row : ledger.rows()) print(row);
  return 0;
}
