// What scene_speed measured: lines on standard output, and a file in JSON.
#pragma once

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace graze::bench {

struct SceneRow {
  std::string section;  ///< peers, growth, lattice or far
  std::string scene;
  std::size_t triangles = 0;
  std::string what;  ///< camera, incoherent, occlusion, build, memory, ...
  std::string contender;
  double value = 0;
  std::string unit;  ///< ns a ray, s, bytes a triangle, MiB
  double ratio = 0;  ///< how many times as good as `to`; 0 where there is no such
  std::string to;
};

class SceneRows {
 public:
  void add(SceneRow row) {
    std::printf("%-8s %-22s %8zu  %-22s %-16s %10.4g %-16s", row.section.c_str(), row.scene.c_str(), row.triangles,
                row.what.c_str(), row.contender.c_str(), row.value, row.unit.c_str());
    if (!row.to.empty()) std::printf("  %.2f x %s", row.ratio, row.to.c_str());
    std::printf("\n");
    std::fflush(stdout);
    rows_.push_back(std::move(row));
  }

  /// False where the file cannot be written.
  [[nodiscard]] bool write(const std::string& file) const {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const SceneRow& r : rows_) {
      nlohmann::ordered_json row{{"section", r.section}, {"scene", r.scene},         {"triangles", r.triangles},
                                 {"what", r.what},       {"contender", r.contender}, {"value", r.value},
                                 {"unit", r.unit}};
      if (!r.to.empty()) {
        row["ratio"] = r.ratio;
        row["to"] = r.to;
      }
      all.push_back(std::move(row));
    }
    std::ofstream out(file);
    out << nlohmann::ordered_json{{"program", "scene_speed"}, {"rows", std::move(all)}}.dump(2) << '\n';
    return static_cast<bool>(out.flush());
  }

 private:
  std::vector<SceneRow> rows_;
};

}  // namespace graze::bench
