#include <benchmark/benchmark.h>

#include <chrono>
#include <ctime>
#include <fstream>
#include <string>

#include "bench/json_out.hpp"

namespace graze::bench {
namespace {

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#else
  return "g++ " __VERSION__;
#endif
}

std::string now() {
  char text[32];
  const std::time_t time = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now());
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", std::gmtime(&time));
  return text;
}

}  // namespace

nlohmann::json provenance(const Plan& plan) {
  const benchmark::CPUInfo& cpu = benchmark::CPUInfo::Get();
  nlohmann::json caches = nlohmann::json::array();
  for (const auto& c : cpu.caches) caches.push_back({{"level", c.level}, {"type", c.type}, {"bytes", c.size}});
  return {{"machine", {{"processor", processor()}, {"cores", cpu.num_cpus}, {"caches", caches}, {"load", cpu.load_avg}}},
          {"compiler", compiler()},
          {"flags", GRAZE_BENCH_FLAGS},
          {"date", now()},
          {"plan", plan.name},
          {"seed", plan.seed},
          {"repetitions", plan.effort.repetitions}};
}

}  // namespace graze::bench
