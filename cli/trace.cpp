#include "cli/trace.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>
#include <string>

#include "cli/exit_status.hpp"
#include "cli/line_source.hpp"
#include "cli/refuse.hpp"
#include "cli/scene_files.hpp"
#include "fuzz/answer_names.hpp"
#include "fuzz/case_text.hpp"

namespace graze::cli {
namespace {

struct Options {
  std::string precision = "double";
  std::string query = "closest";
  bool stats = false;
  std::vector<std::string> files;
};

/// Reads a line's numbers a Question, in blocks as large as what is there to be read; calls answer(questions) for each block.
/// Returns an ExitStatus.
template <Real T, class Question, class Numbers, class Answer>
int each_block(const fuzz::NumbersText& text, Numbers numbers_of, Answer answer) {
  constexpr std::size_t most = 8192;
  LineSource lines("-");
  std::vector<Question> block;
  std::string wrong;
  bool is_done = false;
  while (!is_done) {
    is_done = !std::cout || !lines.error().empty() || !lines.next();
    if (!is_done && !fuzz::is_skipped(lines.line())) {
      Question question;
      const auto numbers = numbers_of(question);
      if (const auto error = fuzz::parse_numbers<T>(text, lines.line(), numbers)) {
        wrong = lines.place() + ": " + error->what;
        is_done = true;
      } else {
        block.push_back(question);
      }
    }
    // Whoever writes through a pipe and waits for the answers gets them.
    const bool would_wait = is_done || lines.would_wait();
    if (!block.empty() && (would_wait || block.size() == most)) {
      answer(block);
      block.clear();
      if (would_wait) std::cout.flush();
    }
  }
  if (!wrong.empty()) return refuse(wrong);
  return lines.error().empty() ? exit_well : refuse(lines.error());
}

template <Real T>
std::string told(const SceneHit<T>& hit) {
  if (!hit.is_hit()) return "miss";
  const std::string index = std::to_string(hit.index) + " ";
  // The case only tells what kind of answer it is.
  return index + (hit.shape == Shape::triangle ? fuzz::format_answer<T>(fuzz::RayTriangle<T>{}, hit.triangle)
                                               : fuzz::format_answer<T>(fuzz::RaySphere<T>{}, hit.sphere));
}

template <Real T>
std::string told(const std::vector<SceneHit<T>>& hits) {
  std::string line;
  for (const SceneHit<T>& hit : hits) line.append(line.empty() ? "" : "; ").append(told(hit));
  return hits.empty() ? "miss" : line;
}

template <Real T>
void print_answers(const std::vector<Ray<T>>& rays, const auto& line_of) {
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const Status status = Scene<T>::status_of(rays[i]);
    std::cout << (status == Status::ok ? line_of(i) : "invalid " + std::string(fuzz::name_of(status))) << '\n';
  }
}

template <Real T>
void answer_block(const Scene<T>& scene, const std::string& query, const std::vector<Ray<T>>& rays) {
  const std::span<const Ray<T>> asked(rays);
  if (query == "closest") {
    std::vector<SceneHit<T>> hits(rays.size());
    scene.closest(asked, hits);
    print_answers(rays, [&](std::size_t i) { return told(hits[i]); });
  } else if (query == "all") {
    std::vector<std::vector<SceneHit<T>>> hits(rays.size());
    scene.all(asked, std::span(hits));
    print_answers(rays, [&](std::size_t i) { return told(hits[i]); });
  } else if (query == "any") {
    const auto hits = std::make_unique<bool[]>(rays.size());
    scene.any(asked, std::span(hits.get(), rays.size()));
    print_answers(rays, [&](std::size_t i) { return std::string(hits[i] ? "hit" : "miss"); });
  } else {
    std::vector<std::uint64_t> hits(rays.size());
    scene.count(asked, hits);
    print_answers(rays, [&](std::size_t i) { return std::to_string(hits[i]); });
  }
}

/// The same, one ray after the other, counting.
template <Real T>
void answer_block(const Scene<T>& scene, const std::string& query, const std::vector<Ray<T>>& rays, Statistics& statistics) {
  print_answers(rays, [&](std::size_t i) {
    if (query == "closest") return told(scene.closest(rays[i], {}, statistics));
    if (query == "all") return told(scene.all(rays[i], {}, statistics));
    if (query == "any") return std::string(scene.any(rays[i], {}, statistics) ? "hit" : "miss");
    return std::to_string(scene.count(rays[i], {}, statistics));
  });
}

template <Real T>
void print_statistics(const Scene<T>& scene, std::uint64_t rays, const Statistics& s) {
  std::cerr << "scene: " << scene.size() << " primitives, " << scene.memory() << " bytes"
            << (sizeof(T) == 4 ? ", coordinates read as double and rounded to float" : "") << "\nrays: " << rays
            << "\nnodes: " << s.nodes << "\nleaves: " << s.leaves << "\ntriangle tests: " << s.triangle_tests
            << "\nsphere tests: " << s.sphere_tests << "\nerror bounds: " << s.error_bounds
            << "\nfilter misses: " << s.filter_misses << "\nfilter hits: " << s.filter_hits
            << "\nexact decisions: " << s.exact_decisions << "\nexact orders: " << s.exact_orders
            << "\nroundings: " << s.roundings << '\n';
}

template <Real T>
int trace(const Options& options) {
  Scene<T> scene;
  if (const std::string wrong = load_scene(options.files, false, scene); !wrong.empty()) return refuse(wrong);
  Statistics statistics;
  std::uint64_t rays = 0;
  const auto numbers_of = [](Ray<T>& r) {
    return std::array<T*, 8>{&r.origin.x,    &r.origin.y,    &r.origin.z, &r.direction.x,
                             &r.direction.y, &r.direction.z, &r.t_min,    &r.t_max};
  };
  const int status =
      each_block<T, Ray<T>>({"a ray", "ex ey ez dx dy dz", true}, numbers_of, [&](const std::vector<Ray<T>>& block) {
        rays += block.size();
        if (options.stats) {
          answer_block(scene, options.query, block, statistics);
        } else {
          answer_block(scene, options.query, block);
        }
      });
  if (options.stats && status == exit_well) print_statistics(scene, rays, statistics);
  return status;
}

template <Real T>
int inside(const Options& options) {
  Scene<T> scene;
  if (const std::string wrong = load_scene(options.files, true, scene); !wrong.empty()) return refuse(wrong);
  const auto numbers_of = [](Vec3<T>& p) { return std::array<T*, 3>{&p.x, &p.y, &p.z}; };
  return each_block<T, Vec3<T>>({"a point", "px py pz", false}, numbers_of, [&](const std::vector<Vec3<T>>& points) {
    std::vector<Place> places(points.size());
    scene.inside(std::span<const Vec3<T>>(points), places);
    for (const Place place : places) {
      std::cout << (place == Place::inside     ? "inside\n"
                    : place == Place::outside  ? "outside\n"
                    : place == Place::boundary ? "boundary\n"
                                               : "invalid non_finite\n");
    }
  });
}

CLI::Option* add_options(CLI::App& command, Options& options) {
  command
      .add_option("--precision", options.precision,
                  "double (default) or float: of the rays or points; mesh coordinates are read as double and rounded")
      ->check(CLI::IsMember({"double", "float"}));
  return command
      .add_option("mesh", options.files, "meshes (OFF, OBJ, PLY, STL) and sphere lists (.spheres: `cx cy cz r` a line)")
      ->type_name("MESH")
      ->required();
}

}  // namespace

void add_trace(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("trace", "Read one ray a line, write what it hits in a scene");
  const auto options = std::make_shared<Options>();
  command->add_option("--query", options->query, "closest (default), any, all or count")
      ->check(CLI::IsMember({"closest", "any", "all", "count"}));
  command->add_flag("--stats", options->stats, "tell on standard error what was done; on one core");
  add_options(*command, *options);
  command->footer(
      "Rays on standard input: ex ey ez  dx dy dz  [t_min t_max]\n"
      "Answers: miss, or INDEX KIND VALUES; hit or miss for any; a number for count. Primitives are numbered from 0 through "
      "all files.");
  command->callback(
      [options, &status] { status = options->precision == "float" ? trace<float>(*options) : trace<double>(*options); });
}

void add_inside(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("inside", "Read one point a line, write where it lies against a closed mesh");
  const auto options = std::make_shared<Options>();
  add_options(*command, *options);
  command->footer("Points on standard input: px py pz. Answers: inside, outside or boundary, by the even-odd rule.");
  command->callback(
      [options, &status] { status = options->precision == "float" ? inside<float>(*options) : inside<double>(*options); });
}

}  // namespace graze::cli
