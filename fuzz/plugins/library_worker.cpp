#include "fuzz/plugins/library_worker.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <optional>
#include <tuple>
#include <utility>
#include <variant>
#include <vector>

#include "fuzz/answer_text.hpp"
#include "fuzz/case_numbers.hpp"
#include "fuzz/deviations.hpp"
#include "graze/subject.h"

namespace graze::fuzz {
namespace {

using Description = graze_subject_description;

constexpr bool same_bit(graze_deviation bit, Deviation deviation) {
  return static_cast<unsigned>(bit) == 1u << static_cast<unsigned>(deviation);
}
static_assert(same_bit(GRAZE_COPLANAR_IS_MISS, Deviation::coplanar_is_miss) &&
              same_bit(GRAZE_DEGENERATE_IS_MISS, Deviation::degenerate_is_miss) &&
              same_bit(GRAZE_EDGES_ARE_FACES, Deviation::edges_are_faces) &&
              same_bit(GRAZE_TANGENTS_ARE_SECANTS, Deviation::tangents_are_secants) &&
              same_bit(GRAZE_HIT_OR_MISS, Deviation::hit_or_miss) && same_bit(GRAZE_NEAREST_ROOT, Deviation::nearest_root) &&
              same_bit(GRAZE_NO_ROOT, Deviation::no_root) && same_bit(GRAZE_NO_ORIGIN, Deviation::no_origin) &&
              same_bit(GRAZE_NO_FACING, Deviation::no_facing) && same_bit(GRAZE_NO_COORDINATES, Deviation::no_coordinates) &&
              same_bit(GRAZE_INVALID_UNHANDLED, Deviation::invalid_unhandled));

/// The two pipes, moved out of the library's reach: its own standard input is empty, its output goes to standard error.
struct Pipes {
  int in = ::dup(STDIN_FILENO), out = ::dup(STDOUT_FILENO);
  Pipes() {
    ::dup2(STDERR_FILENO, STDOUT_FILENO);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::close(nothing);
  }

  void write(std::string_view text) const {
    while (!text.empty()) {
      const ssize_t n = ::write(out, text.data(), text.size());
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) ::_exit(1);  // nobody listens any more
      text.remove_prefix(static_cast<std::size_t>(n));
    }
  }
};

/// The library's description, or what is wrong with it.
std::variant<const Description*, std::string> load(const std::string& path) {
  void* library = ::dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return "cannot be loaded: " + std::string(::dlerror());
  void* symbol = ::dlsym(library, "graze_subject");
  if (symbol == nullptr) return std::string("does not define graze_subject, the function that graze/subject.h asks for");
  const Description* description = reinterpret_cast<decltype(&graze_subject)>(symbol)();
  if (description == nullptr) return std::string("its graze_subject returns a null pointer");
  if (description->abi != GRAZE_SUBJECT_ABI) {
    return "speaks version " + std::to_string(description->abi) + " of graze/subject.h, and this program version " +
           std::to_string(GRAZE_SUBJECT_ABI) + "; compile it again with the header of this program";
  }
  if (description->name == nullptr || *description->name == '\0') return std::string("has no name in its description");
  if ((description->deviations >> deviation_count) != 0 || description->deviations >= 2u * GRAZE_INVALID_UNHANDLED) {
    return "declares deviations that graze/subject.h does not have: " + std::to_string(description->deviations);
  }
  for (const double ulps : {description->t_ulps, description->uv_ulps}) {
    if (!(ulps == 0 || ulps >= 0.5)) return std::string("declares ulps that are neither 0 nor 1/2 or more");
  }
  return description;
}

/// The functions of a precision, and the C types of its cases in the order of Case.
template <Real T>
struct Calls;
template <>
struct Calls<double> {
  using Answer = graze_answer_double;
  using Queries = std::tuple<graze_ray_sphere_double, graze_ray_triangle_double, graze_point_line_double,
                             graze_point_plane_double, graze_point_sphere_double>;
  static const graze_subject_double& of(const Description& d) { return d.in_double; }
};
template <>
struct Calls<float> {
  using Answer = graze_answer_float;
  using Queries = std::tuple<graze_ray_sphere_float, graze_ray_triangle_float, graze_point_line_float, graze_point_plane_float,
                             graze_point_sphere_float>;
  static const graze_subject_float& of(const Description& d) { return d.in_float; }
};

/// The function for the query of index I.
template <std::size_t I, class Functions>
auto function_of(const Functions& f) {
  if constexpr (I == 0) return f.ray_sphere;
  if constexpr (I == 1) return f.ray_triangle;
  if constexpr (I == 2) return f.point_line;
  if constexpr (I == 3) return f.point_plane;
  if constexpr (I == 4) return f.point_sphere;
}

/// The case in the library's own type: its numbers one after the other, in the order of the case line.
template <class Query, Real T>
Query to_c(const Case<T>& input) {
  constexpr std::size_t count = sizeof(Query) / sizeof(T);
  std::array<T, count> numbers{};
  std::size_t n = 0;
  std::visit([&](const auto& query) { for_each_number(query, [&](T x) { numbers[n++] = x; }); }, input);
  Query query;
  static_assert(sizeof query == sizeof numbers);
  std::memcpy(&query, numbers.data(), sizeof query);
  return query;
}

/// `value` as an Enum from 0 to last; what is wrong goes to `wrong`.
template <class Enum>
Enum checked(std::int32_t value, Enum last, const char* what, std::string& wrong) {
  if (value >= 0 && value <= static_cast<std::int32_t>(last)) return static_cast<Enum>(value);
  if (wrong.empty()) wrong = "answered the " + std::string(what) + " " + std::to_string(value) + ", which is none";
  return Enum{};
}

template <Real T, class CAnswer>
SphereHit<T> sphere_hit(const CAnswer& a, Status status, std::string& wrong) {
  SphereHit<T> hit;
  hit.status = status;
  if (status != Status::ok) {
    hit.kind = SphereKind::invalid;
    return hit;
  }
  if (a.kind < GRAZE_MISS || a.kind > GRAZE_SECANT) {
    wrong = "answered the kind " + std::to_string(a.kind) + ", which is none of ray_sphere";
    return hit;
  }
  constexpr std::array kinds{SphereKind::miss, SphereKind::tangent, SphereKind::secant};
  hit.kind = kinds[static_cast<std::size_t>(a.kind)];
  hit.origin = checked(a.origin, OriginSide::outside, "origin", wrong);
  if (hit.kind == SphereKind::miss) return hit;
  hit.root = checked(a.root, Root::both, "root", wrong);
  if (hit.kind == SphereKind::tangent) hit.root = Root::both;
  if (hit.root == Root::none) hit.root = Root::first;
  for (int i = 0; i < hit.count(); ++i) hit.t[i] = a.t[i];
  return hit;
}

template <Real T, class CAnswer>
TriangleHit<T> triangle_hit(const CAnswer& a, Status status, std::string& wrong) {
  TriangleHit<T> hit;
  hit.status = status;
  if (status != Status::ok) {
    hit.kind = TriangleKind::invalid;
    return hit;
  }
  const bool is_kind = a.kind == GRAZE_MISS || (a.kind >= GRAZE_FACE && a.kind <= GRAZE_DEGENERATE);
  if (!is_kind) {
    wrong = "answered the kind " + std::to_string(a.kind) + ", which is none of ray_triangle";
    return hit;
  }
  hit.kind = a.kind == GRAZE_MISS ? TriangleKind::miss
                                  : static_cast<TriangleKind>(static_cast<int>(TriangleKind::face) + a.kind - GRAZE_FACE);
  hit.facing = checked(a.facing, Facing::back, "facing", wrong);
  if (hit.kind == TriangleKind::miss) return hit;
  hit.t = hit.t_end = a.t[0];
  if (hit.is_interval()) {
    hit.t_end = a.t[1];
  } else {
    hit.u = a.u;
    hit.v = a.v;
  }
  return hit;
}
static_assert(static_cast<int>(TriangleKind::degenerate) - static_cast<int>(TriangleKind::face) ==
              GRAZE_DEGENERATE - GRAZE_FACE);

template <class CAnswer>
Side side(const CAnswer& a, Status status, std::string& wrong) {
  if (status != Status::ok) return {status, Sign::zero};
  if (a.kind < GRAZE_NEGATIVE || a.kind > GRAZE_POSITIVE) {
    wrong = "answered the kind " + std::to_string(a.kind) + ", which is no sign";
    return {};
  }
  return {Status::ok, static_cast<Sign>(a.kind - GRAZE_ON)};
}

/// The answer line, or `error` and what is wrong with the answer.
template <Real T, class CAnswer>
std::string line_of(const Case<T>& input, const CAnswer& a) {
  std::string wrong;
  const Status status = checked(a.status, Status::empty_range, "status", wrong);
  const auto answer = [&]() -> Answer<T> {
    if (input.index() == 0) return sphere_hit<T>(a, status, wrong);
    if (input.index() == 1) return triangle_hit<T>(a, status, wrong);
    return side(a, status, wrong);
  }();
  return wrong.empty() ? format_answer(input, answer, Details::yes) : "error " + wrong;
}

/// Answers those of the cases that are of query I, at once; lines[i] for cases[i].
template <std::size_t I, Real T>
void answer_query(const Description& description, FloatMode mode, const std::vector<Case<T>>& cases,
                  std::vector<std::string>& lines) {
  using Query = std::tuple_element_t<I, typename Calls<T>::Queries>;
  std::vector<std::size_t> places;
  std::vector<Query> queries;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    if (cases[i].index() != I) continue;
    places.push_back(i);
    queries.push_back(to_c<Query>(cases[i]));
  }
  if (queries.empty()) return;
  const auto call = function_of<I>(Calls<T>::of(description));
  if (call == nullptr) {
    for (const std::size_t place : places) lines[place] = not_offered_line;
    return;
  }
  std::vector<typename Calls<T>::Answer> answers(queries.size());
  std::memset(answers.data(), 0, answers.size() * sizeof answers[0]);
  const std::size_t answered = [&] {
    const FloatModeScope scope(mode);
    return call(queries.data(), queries.size(), answers.data());
  }();
  for (std::size_t i = 0; i < places.size(); ++i) {
    lines[places[i]] = answered == places.size()
                           ? line_of(cases[places[i]], answers[i])
                           : "error answered " + std::to_string(answered) + " of " + std::to_string(places.size()) + " cases";
  }
}

/// Answers all whole lines that have come so far.
template <Real T>
void answer_lines(const Description& description, FloatMode mode, std::string_view text, const Pipes& pipes) {
  std::vector<Case<T>> cases;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const auto parsed = parse_case<T>(text.substr(0, end));
    text.remove_prefix(end + 1);
    // The certifier writes the lines: another writer's mistake is no case.
    if (const auto* input = std::get_if<Case<T>>(&parsed)) cases.push_back(*input);
  }
  std::vector<std::string> lines(cases.size());
  [&]<std::size_t... I>(std::index_sequence<I...>) {
    (answer_query<I>(description, mode, cases, lines), ...);
  }
  (std::make_index_sequence<std::variant_size_v<Case<T>>>());
  std::string all;
  for (const std::string& line : lines) all.append(line).append("\n");
  pipes.write(all);
}

std::string one_line(const char* text) {
  std::string line(text == nullptr ? "" : text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  }
  return line;
}

/// As parse_declaration reads it.
std::string declaration_of(const Description& d) {
  std::string words;
  const auto add = [&](std::string_view word) { words.append(words.empty() ? "" : ",").append(word); };
  for (std::size_t i = 0; i < deviation_count; ++i) {
    if ((d.deviations >> i & 1u) != 0) add(deviation_texts[i].name);
  }
  const auto add_ulps = [&](const std::string& key, double ulps) {
    if (ulps != 0) add(key + format_number(ulps, NumberForm::shortest));
  };
  add_ulps("t-ulps=", d.t_ulps);
  add_ulps("uv-ulps=", d.uv_ulps);
  return words;
}

}  // namespace

int describe_library(const std::string& path) {
  const Pipes pipes;
  const auto loaded = load(path);
  if (const auto* wrong = std::get_if<std::string>(&loaded)) {
    pipes.write("error " + *wrong + "\n");
    return 2;
  }
  const Description& d = *std::get<const Description*>(loaded);
  pipes.write("name " + one_line(d.name) + "\nabout " + one_line(d.about) + "\ndeclares " + declaration_of(d) + "\n");
  return 0;
}

template <class T>
int serve_library(const std::string& path, FloatMode mode) {
  const Pipes pipes;
  const auto loaded = load(path);
  if (std::holds_alternative<std::string>(loaded)) return 2;
  const Description& description = *std::get<const Description*>(loaded);
  std::string text;
  std::array<char, 65536> buffer;
  while (true) {
    const ssize_t n = ::read(pipes.in, buffer.data(), buffer.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return n == 0 ? 0 : 1;
    text.append(buffer.data(), static_cast<std::size_t>(n));
    const std::size_t whole = text.rfind('\n') + 1;
    if (whole == 0) continue;
    answer_lines<T>(description, mode, std::string_view(text).substr(0, whole), pipes);
    text.erase(0, whole);
  }
}

template int serve_library<float>(const std::string&, FloatMode);
template int serve_library<double>(const std::string&, FloatMode);

}  // namespace graze::fuzz
