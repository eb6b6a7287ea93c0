/* A kernel under graze's certifier: ray and triangle by Moeller and Trumbore, in double. See docs/certify_your_kernel.md. */
#include "graze/subject.h"

typedef struct {
  double x, y, z;
} vec;

static vec minus(const double* a, const double* b) {
  vec v = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  return v;
}
static vec cross(vec a, vec b) {
  vec v = {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  return v;
}
static double dot(vec a, vec b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* The answer comes as zeros: a miss. */
static void intersect(const struct graze_ray_triangle_double* in, struct graze_answer_double* out) {
  const vec d = {in->direction[0], in->direction[1], in->direction[2]};
  const vec ab = minus(in->b, in->a), ac = minus(in->c, in->a), ae = minus(in->origin, in->a);
  const vec p = cross(d, ac), q = cross(ae, ab);
  const double determinant = dot(ab, p); /* -d . n */
  out->facing = determinant > 0 ? GRAZE_FRONT : determinant < 0 ? GRAZE_BACK : GRAZE_FACING_NONE;
  if (determinant == 0) return;
  const double u = dot(ae, p) / determinant, v = dot(d, q) / determinant, t = dot(ac, q) / determinant;
  if (!(u >= 0 && v >= 0 && u + v <= 1 && in->t_min <= t && t <= in->t_max)) return;
  out->kind = GRAZE_FACE;
  out->t[0] = t;
  out->u = u;
  out->v = v;
}

static size_t ray_triangle(const struct graze_ray_triangle_double* cases, size_t count, struct graze_answer_double* answers) {
  for (size_t i = 0; i < count; ++i) intersect(&cases[i], &answers[i]);
  return count;
}

const struct graze_subject_description* graze_subject(void) {
  static const struct graze_subject_description description = {
      .abi = GRAZE_SUBJECT_ABI,
      .name = "my kernel",
      .about = "Moeller and Trumbore, double",
      .deviations = GRAZE_COPLANAR_IS_MISS | GRAZE_DEGENERATE_IS_MISS | GRAZE_EDGES_ARE_FACES | GRAZE_INVALID_UNHANDLED,
      .t_ulps = 4096,
      .uv_ulps = 4096,
      .in_double = {.ray_triangle = ray_triangle},
  };
  return &description;
}
