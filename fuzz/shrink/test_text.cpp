#include "fuzz/shrink/test_text.hpp"

#include <cmath>

#include "fuzz/answer_names.hpp"
#include "fuzz/case_text.hpp"

namespace graze::fuzz {
namespace {

template <Real T>
constexpr const char* type_name = sizeof(T) == sizeof(float) ? "float" : "double";

/// As C++ spells it.
template <Real T>
std::string literal(T x) {
  if (!std::isfinite(x)) {
    const std::string limits = std::string("std::numeric_limits<") + type_name<T> + ">::";
    return std::isnan(x) ? limits + "quiet_NaN()" : (x < 0 ? "-" : "") + limits + "infinity()";
  }
  return format_number(x, NumberForm::hexadecimal) + (sizeof(T) == sizeof(float) ? "F" : "");
}

template <Real T, class... Numbers>
std::string listed(T first, Numbers... rest) {
  std::string text = literal(first);
  ((text += ", " + literal(rest)), ...);
  return text;
}
template <Real T>
std::string braced(const Vec3<T>& v) {
  return "{" + listed(v.x, v.y, v.z) + "}";
}

/// `  const graze::NAME<T> name{PARTS};`
template <Real T>
std::string variable(std::string_view type, std::string_view name, const std::string& parts) {
  return "  const graze::" + std::string(type) + "<" + type_name<T> + "> " + std::string(name) + "{" + parts + "};\n";
}
template <Real T>
std::string variable_of(const Ray<T>& ray) {
  return variable<T>("Ray", "ray",
                     braced(ray.origin) + ", " + braced(ray.direction) + ", " + literal(ray.t_min) + ", " + literal(ray.t_max));
}
template <Real T>
std::string variable_of(const Sphere<T>& sphere) {
  return variable<T>("Sphere", "sphere", braced(sphere.center) + ", " + literal(sphere.radius));
}

std::string check(const std::string& what, const std::string& wanted) {
  return "  CHECK(" + what + " == " + wanted + ");\n";
}
template <class Name>
std::string check_name(const std::string& field, const std::string& type, Name name) {
  return check("hit." + field, "graze::" + type + "::" + std::string(name_of(name)));
}

template <Real T>
std::string checks(const SphereHit<T>& hit) {
  if (hit.status != Status::ok) return check_name("status", "Status", hit.status);
  std::string text = check_name("kind", "SphereKind", hit.kind) + check_name("origin", "OriginSide", hit.origin);
  if (hit.count() != 0) text += check_name("root", "Root", hit.root);
  for (int i = 0; i < hit.count(); ++i) text += check("hit.t[" + std::to_string(i) + "]", literal(hit.t[i]));
  return text;
}
template <Real T>
std::string checks(const TriangleHit<T>& hit) {
  if (hit.status != Status::ok) return check_name("status", "Status", hit.status);
  std::string text = check_name("kind", "TriangleKind", hit.kind) + check_name("facing", "Facing", hit.facing);
  if (hit.kind == TriangleKind::miss) return text;
  text += check("hit.t", literal(hit.t));
  if (hit.is_interval()) return text + check("hit.t_end", literal(hit.t_end));
  return text + check("hit.u", literal(hit.u)) + check("hit.v", literal(hit.v));
}
std::string checks(const Side& side) {
  if (side.status != Status::ok) return check_name("status", "Status", side.status);
  const char* sign = side.sign == Sign::negative ? "negative" : side.sign == Sign::positive ? "positive" : "zero";
  return check("hit.sign", std::string("graze::Sign::") + sign);
}

}  // namespace

template <Real T>
std::string catch_test(std::string_view title, const Case<T>& input, const Answer<T>& truth) {
  std::string text = "TEST_CASE(\"" + std::string(title) + "\") {\n";
  std::visit(
      [&](const auto& query) {
        std::string call;
        if constexpr (requires { query.ray; }) {
          text += variable_of(query.ray);
        } else if constexpr (requires { query.point.z; }) {
          text += variable<T>("Vec3", "point", listed(query.point.x, query.point.y, query.point.z));
        } else {
          text += variable<T>("Vec2", "point", listed(query.point.x, query.point.y));
        }
        if constexpr (requires { query.sphere; }) {
          text += variable_of(query.sphere);
          call = requires {
            query.ray;
          }
          ? "intersect(ray, sphere)" : "side(point, sphere)";
        } else if constexpr (requires { query.triangle; }) {
          const auto& [a, b, c] = query.triangle;
          text += variable<T>("Triangle", "triangle", braced(a) + ", " + braced(b) + ", " + braced(c));
          call = "intersect(ray, triangle)";
        } else if constexpr (requires { query.plane; }) {
          const auto& [a, b, c, d] = query.plane;
          text += variable<T>("Plane", "plane", listed(a, b, c, d));
          call = "side(point, plane)";
        } else {
          const auto& [a, b, c] = query.line;
          text += variable<T>("Line", "line", listed(a, b, c));
          call = "side(point, line)";
        }
        text += "  const auto hit = " + call + ";\n";
      },
      input);
  return text + std::visit([](const auto& hit) { return checks(hit); }, truth) + "}\n";
}

template std::string catch_test(std::string_view, const Case<float>&, const Answer<float>&);
template std::string catch_test(std::string_view, const Case<double>&, const Answer<double>&);

}  // namespace graze::fuzz
