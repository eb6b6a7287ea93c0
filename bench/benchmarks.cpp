// benchmarks [quick|full] [--only PART]... [--stages FILE] [-o FILE]: all measurements as one JSON document. Progress goes to
// standard error.
#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>

#include "bench/certainty.hpp"
#include "bench/floor.hpp"
#include "bench/stability.hpp"
#include "bench/time_error.hpp"

int main(int argc, char** argv) {
  using namespace graze::bench;
  std::string plan_name = "quick", file = "-", stages_file;
  std::vector<std::string> parts{"time", "stability", "certainty", "floor"};
  Plan plan = quick_plan;
  CLI::App app{"Time against error, stability sweeps, the cost of certainty, the floor: as JSON."};
  app.add_option("plan", plan_name, "quick or full")->check(CLI::IsMember({"quick", "full"}))->capture_default_str();
  app.add_option("--only", parts, "parts to measure")->check(CLI::IsMember(parts))->delimiter(',');
  const auto* seed = app.add_option("--seed", plan.seed, "of all inputs")->capture_default_str();
  app.add_option("-o,--output", file, "where the JSON goes; - is standard output")->capture_default_str();
  app.add_option("--stages", stages_file, "what stage_counts wrote, to be taken in")->check(CLI::ExistingFile);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (plan_name == "full") {
    const std::uint64_t chosen = plan.seed;
    plan = full_plan;
    if (seed->count() > 0) plan.seed = chosen;
  }
  nlohmann::json out = provenance(plan);
  for (const std::string& part : parts) {
    if (part == "time") out["time_error"] = time_against_error(plan);
    if (part == "stability") out["stability"] = stability(plan);
    if (part == "certainty") out["certainty"] = cost_of_certainty(plan);
    if (part == "floor") out["floor"] = floor_of_loops(plan);
  }
  if (!stages_file.empty()) {
    out["stages"] = nlohmann::json::parse(std::ifstream(stages_file), nullptr, false);
    if (out["stages"].is_discarded()) {
      std::cerr << "benchmarks: " << stages_file << " is no JSON: let stage_counts write it\n";
      return 2;
    }
  }
  const std::string text = out.dump(1) + "\n";
  if (file == "-") {
    std::cout << text;
    return std::cout.flush() ? 0 : 2;
  }
  std::ofstream stream(file);
  if (!(stream << text).flush()) {
    std::cerr << "benchmarks: " << file << " cannot be written: name a file in a folder that exists\n";
    return 2;
  }
  return 0;
}
