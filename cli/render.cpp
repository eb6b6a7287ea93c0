#include "cli/render.hpp"

#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <memory>

#include "cli/camera.hpp"
#include "cli/exit_status.hpp"
#include "cli/kernels.hpp"
#include "cli/picture.hpp"
#include "cli/primitives.hpp"
#include "cli/progress_line.hpp"
#include "cli/refuse.hpp"
#include "cli/report_file.hpp"
#include "cli/scene_files.hpp"
#include "cli/second_kernel.hpp"

namespace graze::cli {
namespace {

constexpr int largest_picture = 16384;

struct Options {
  std::string precision = "double";
  std::vector<std::string> files;
  std::string output;
  int size = 512, zoom = 1;
  std::vector<double> from{0.4, 0.3, 1};
  bool at_corners = false, kinds = false;
  KernelOptions kernel;
};

constexpr Color background{250, 250, 248};

/// What a pixel's color means, by the index that says how many there are of it.
struct Legend {
  const char* name;
  Color color;
  bool is_shaded;  ///< by the angle between ray and surface
};

constexpr Color clay{226, 221, 211};
enum KindColor { seen_miss, seen_face, seen_edge, seen_vertex, seen_coplanar, seen_degenerate, seen_secant, seen_tangent };
constexpr std::array<Legend, 8> kind_legend{{{"miss", background, false},
                                             {"face", clay, true},
                                             {"edge", {31, 100, 200}, false},
                                             {"vertex", {214, 40, 40}, false},
                                             {"coplanar", {150, 60, 180}, false},
                                             {"degenerate", {60, 60, 60}, false},
                                             {"secant", {190, 215, 195}, true},
                                             {"tangent", {20, 150, 80}, false}}};
/// In the order of Finding; what agrees is shaded.
constexpr std::array<Legend, finding_count> finding_legend{{{"agrees", clay, true},
                                                            {"lost", {220, 20, 30}, false},
                                                            {"false hit", {40, 70, 220}, false},
                                                            {"another taken for nearest", {244, 208, 150}, true},
                                                            {"wrong kind or side", {222, 190, 228}, true},
                                                            {"number off by more than declared", {196, 216, 222}, true},
                                                            {"no answer", {0, 0, 0}, false}}};

KindColor color_of(const auto& hit) {
  if (hit.shape == Shape::none) return seen_miss;
  if (hit.shape == Shape::sphere) return hit.sphere.kind == SphereKind::tangent ? seen_tangent : seen_secant;
  switch (hit.triangle.kind) {
    case TriangleKind::edge_ab:
    case TriangleKind::edge_bc:
    case TriangleKind::edge_ca:
      return seen_edge;
    case TriangleKind::vertex_a:
    case TriangleKind::vertex_b:
    case TriangleKind::vertex_c:
      return seen_vertex;
    case TriangleKind::coplanar:
      return seen_coplanar;
    case TriangleKind::degenerate:
      return seen_degenerate;
    default:
      return seen_face;
  }
}

template <Real T>
Vec3<double> widened(const Vec3<T>& v) {
  return {double(v.x), double(v.y), double(v.z)};
}

Vec3<double> difference(const Vec3<double>& a, const Vec3<double>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}

/// Of any length.
template <Real T>
Vec3<double> normal(const Triangle<T>& t, const Ray<T>&, const SceneHit<T>&) {
  const Vec3<double> a = widened(t.a);
  return cross(unit(difference(widened(t.b), a)), unit(difference(widened(t.c), a)));
}
template <Real T>
Vec3<double> normal(const Sphere<T>& s, const Ray<T>& ray, const SceneHit<T>& hit) {
  const double t = hit.sphere.t[0];
  const Vec3<double> e = widened(ray.origin), d = widened(ray.direction);
  return difference({e.x + t * d.x, e.y + t * d.y, e.z + t * d.z}, widened(s.center));
}

/// A light at the eye.
template <Real T>
double brightness(const Primitives<T>& primitives, const Ray<T>& ray, const SceneHit<T>& hit) {
  if (!hit.is_hit()) return 1;
  const Vec3<double> n = primitives.with(hit.index, [&](const auto& shape) { return unit(normal(shape, ray, hit)); });
  return 0.3 + 0.7 * std::fabs(dot(n, unit(widened(ray.direction))));
}

Color painted(const Legend& legend, double brightness) {
  if (!legend.is_shaded) return legend.color;
  Color color = legend.color;
  for (std::uint8_t& c : color) c = static_cast<std::uint8_t>(c * brightness);
  return color;
}

/// A ray a pixel: through its middle, or at the nearest corner of a mesh that is seen in it.
template <Real T>
std::vector<Ray<T>> rays_of(const Camera& camera, const std::vector<Part<T>>& parts, bool at_corners) {
  const Vec3<T> eye{T(camera.eye().x), T(camera.eye().y), T(camera.eye().z)};
  std::vector<Ray<T>> rays;
  for (int y = 0; y < camera.height(); ++y) {
    for (int x = 0; x < camera.width(); ++x) {
      const Vec3<double> way = camera.way_to(x + 0.5, y + 0.5);
      rays.push_back({eye, {T(way.x), T(way.y), T(way.z)}});
    }
  }
  if (!at_corners) return rays;
  std::vector<double> depths(rays.size(), std::numeric_limits<double>::infinity());
  for (const Part<T>& part : parts) {
    const auto* mesh = std::get_if<Mesh<T>>(&part);
    if (mesh == nullptr) continue;
    for (const Corners& triangle : mesh->triangles.get()) {
      for (const std::uint32_t c : triangle) {
        const Vec3<T>& p = mesh->points[c];
        const auto spot = camera.spot_of(widened(p));
        if (!spot || !(spot->x >= 0 && spot->x < camera.width() && spot->y >= 0 && spot->y < camera.height())) continue;
        const auto i = static_cast<std::size_t>(static_cast<int>(spot->y) * camera.width() + static_cast<int>(spot->x));
        if (!(spot->depth < depths[i])) continue;
        depths[i] = spot->depth;
        rays[i].direction = {p.x - eye.x, p.y - eye.y, p.z - eye.z};
      }
    }
  }
  return rays;
}

/// A line for each color that is there.
void print(std::span<const Legend> legend, const std::vector<std::uint64_t>& pixels) {
  for (std::size_t i = 0; i < legend.size(); ++i) {
    if (pixels[i] != 0) std::cout << legend[i].name << ": " << pixels[i] << '\n';
  }
}

template <Real T>
class Renderer {
 public:
  Renderer(const Options& options, const fuzz::Subject* kernel, const Scene<T>& scene, const std::vector<Part<T>>& parts,
           const Camera& camera)
      : options_(options),
        kernel_(kernel),
        scene_(scene),
        camera_(camera),
        primitives_(parts),
        rays_(rays_of(camera, parts, options.at_corners)),
        picture_(camera.width(), camera.height()),
        pixels_(std::max(kind_legend.size(), finding_legend.size())) {}

  int run() {
    fuzz::Progress progress;
    progress.cases_planned = rays_.size();
    {
      const ProgressLine line(progress, "pixels");
      if (kernel_ != nullptr) {
        if (const std::string wrong = compare(progress); !wrong.empty()) return refuse(wrong);
      } else {
        shade(progress);
      }
    }
    const std::string png = picture_.png(options_.zoom);
    if (png.empty()) return refuse_by_name("the picture cannot be made as a PNG; a smaller --size or --zoom may do");
    if (const std::string wrong = write_file(options_.output, png); !wrong.empty()) return refuse_by_name(wrong);
    std::cout << "pixels: " << picture_.width() << " x " << picture_.height() << '\n';
    if (kernel_ == nullptr) {
      print(kind_legend, pixels_);
      return exit_well;
    }
    print(finding_legend, pixels_);
    const bool is_right = pixels_[static_cast<std::size_t>(Finding::agrees)] == rays_.size();
    return is_right ? exit_well : exit_found_wrong;
  }

 private:
  [[nodiscard]] std::span<const Ray<T>> row(int y) const {
    const auto width = static_cast<std::size_t>(picture_.width());
    return std::span(rays_).subspan(static_cast<std::size_t>(y) * width, width);
  }

  void shade(fuzz::Progress& progress) {
    std::vector<SceneHit<T>> hits(static_cast<std::size_t>(picture_.width()));
    for (int y = 0; y < picture_.height(); ++y) {
      const std::span<const Ray<T>> rays = row(y);
      scene_.closest(rays, hits);
      for (std::size_t x = 0; x < hits.size(); ++x) {
        const KindColor kind = color_of(hits[x]);
        ++pixels_[kind];
        // Without kinds all hits are of one color.
        const Legend& legend = options_.kinds || kind == seen_miss ? kind_legend[kind] : kind_legend[seen_face];
        picture_.at(static_cast<int>(x), y) = painted(legend, brightness(primitives_, rays[x], hits[x]));
      }
      progress.cases_done += hits.size();
    }
  }

  /// What is wrong, or nothing.
  std::string compare(fuzz::Progress& progress) {
    SecondKernel<T> second(*kernel_, primitives_, camera_);
    std::vector<std::vector<SceneHit<T>>> ties(static_cast<std::size_t>(picture_.width()));
    std::vector<Finding> findings(ties.size());
    for (int y = 0; y < picture_.height(); ++y) {
      const std::span<const Ray<T>> rays = row(y);
      for (std::size_t x = 0; x < ties.size(); ++x) ties[x] = scene_.ties(rays[x]);
      second.judge_row(y, rays, ties, findings);
      if (!second.not_offered().empty()) {
        return "graze: the kernel '" + std::string(kernel_->name()) + "' does not answer " + second.not_offered() + " in " +
               options_.precision + "; --precision chooses the other, and `graze answer --help` names the kernels";
      }
      for (std::size_t x = 0; x < ties.size(); ++x) {
        const auto finding = static_cast<std::size_t>(findings[x]);
        ++pixels_[finding];
        progress.discrepancies += findings[x] == Finding::agrees ? 0 : 1;
        const Legend& legend = finding == 0 && ties[x].empty() ? kind_legend[seen_miss] : finding_legend[finding];
        const SceneHit<T> seen = ties[x].empty() ? SceneHit<T>{} : ties[x].front();
        picture_.at(static_cast<int>(x), y) = painted(legend, brightness(primitives_, rays[x], seen));
      }
      progress.cases_done += ties.size();
    }
    return {};
  }

  const Options& options_;
  const fuzz::Subject* kernel_;
  const Scene<T>& scene_;
  const Camera& camera_;
  Primitives<T> primitives_;
  std::vector<Ray<T>> rays_;
  Picture picture_;
  std::vector<std::uint64_t> pixels_;  ///< by the legend's index
};

template <Real T>
int render(const Options& options, const fuzz::Subject* kernel) {
  std::vector<Part<T>> parts;
  Scene<T> scene;
  if (const std::string wrong = load_parts(options.files, parts); !wrong.empty()) return refuse(wrong);
  if (const std::string wrong = view_scene(options.files, parts, scene); !wrong.empty()) return refuse(wrong);
  if (scene.size() == 0) return refuse(options.files.front() + ": has no triangle and no sphere to be seen");
  const auto camera = Camera::of<T>(scene.bounds(), {options.from[0], options.from[1], options.from[2]}, options.size);
  if (!camera) return refuse_by_name("the scene is too large for a camera beside it in " + options.precision);
  return Renderer<T>(options, kernel, scene, parts, *camera).run();
}

int run(const Options& options) {
  const Vec3<double> from{options.from[0], options.from[1], options.from[2]};
  if (!std::isfinite(dot(from, from)) || !(dot(from, from) > 0)) {
    return refuse_by_name("--from takes a direction: three finite numbers, not all zero");
  }
  if (options.size * options.zoom > largest_picture) {
    return refuse_by_name("--size times --zoom is more than " + std::to_string(largest_picture) + " pixels a side");
  }
  Kernel kernel;
  if (!options.kernel.name.empty()) {
    kernel = open_kernel(options.kernel);
    if (!kernel.wrong.empty()) return refuse_by_name(kernel.wrong);
  }
  return options.precision == "float" ? render<float>(options, kernel.subject) : render<double>(options, kernel.subject);
}

std::string told(std::span<const Legend> legend) {
  std::string text;
  for (const Legend& l : legend) {
    char color[16];
    std::snprintf(color, sizeof color, " #%02x%02x%02x", l.color[0], l.color[1], l.color[2]);
    text.append(text.empty() ? "" : ", ").append(l.name).append(color);
  }
  return text;
}

}  // namespace

void add_render(CLI::App& program, int& status) {
  CLI::App* command = program.add_subcommand("render", "Draw a scene by exact rays; or where another kernel sees it otherwise");
  const auto options = std::make_shared<Options>();
  command->add_option("mesh", options->files, "meshes (OFF, OBJ, PLY, STL) and sphere lists (.spheres: `cx cy cz r` a line)")
      ->type_name("MESH")
      ->required();
  command->add_option("-o,--output", options->output, "the picture, a PNG file")->type_name("FILE")->required();
  command->add_option("--precision", options->precision, "double (default) or float: of rays and coordinates")
      ->check(CLI::IsMember({"double", "float"}));
  command->add_option("--size", options->size, "pixels on the longer side (default 512)")
      ->check(CLI::Range(1, largest_picture));
  command->add_option("--zoom", options->zoom, "draw each pixel as a square of so many (default 1)")->check(CLI::Range(1, 64));
  command
      ->add_option("--from", options->from, "where the eye is, seen from the middle of the scene (default 0.4 0.3 1); y is up")
      ->expected(3)
      ->type_name("X Y Z");
  command->add_flag("--at-corners", options->at_corners,
                    "aim the ray of a pixel at the nearest corner of the mesh that is seen in it, where there is one");
  CLI::Option* kinds = command->add_flag("--kinds", options->kinds, "color by kind: face, edge, vertex, coplanar, miss");
  options->kernel.name.clear();
  add_kernel_options(*command, options->kernel)
      ->description(
          "show where this kernel, asked about each primitive near the ray, disagrees with the exact answer; the names "
          "are those of `graze certify`")
      ->excludes(kinds);
  command->footer("Colors by kind: " + told(kind_legend) + ".\nWith --kernel: " + told(finding_legend) +
                  ".\nThe counts of pixels are told on standard output. Exit status: 0 all is well, 1 the kernel disagrees "
                  "somewhere, 2 usage or input error.");
  command->callback([options, &status] { status = run(*options); });
}

}  // namespace graze::cli
