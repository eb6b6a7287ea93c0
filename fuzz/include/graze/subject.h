/* A kernel of your own under graze's certifier, as a shared library: `graze certify --kernel ./mine.so`.
 *
 * Define one function, graze_subject, that returns a description of the kernel with a function for each query that it offers.
 * Plain C99; nothing of graze is linked. The library is loaded by a process of its own, one for each thread of the certifier,
 * and only one thread of it calls: nothing need be safe for threads, and a crash or an endless loop ends that process alone and
 * is told with the case that brought it about.
 *
 * What the queries mean and what an answer must say is graze's contract: every t, u and v correctly rounded, every kind exact.
 * What your kernel does otherwise by design it declares; the certifier then allows for that, counts it and lists it.
 */
#ifndef GRAZE_SUBJECT_H
#define GRAZE_SUBJECT_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

/* The version of this header. It changes when a structure or a meaning does. */
#define GRAZE_SUBJECT_ABI 1u

/* Why an input has no answer; tested in this order. */
enum graze_status {
  GRAZE_OK = 0,
  GRAZE_NON_FINITE = 1,      /* a NaN, or an infinity other than t_max = +infinity */
  GRAZE_ZERO_DIRECTION = 2,  /* the ray's direction is the zero vector */
  GRAZE_NEGATIVE_RADIUS = 3, /* radius < 0 */
  GRAZE_EMPTY_RANGE = 4      /* t_min > t_max */
};

/* What is answered. A miss is 0, so an answer that is left as it comes is a miss. */
enum graze_kind {
  GRAZE_MISS = 0,
  /* ray and sphere */
  GRAZE_TANGENT = 1, /* t[0] */
  GRAZE_SECANT = 2,  /* t[0], and t[1] where root is GRAZE_ROOT_BOTH; ascending */
  /* ray and triangle: t[0], u, v; the hit is a + u (b - a) + v (c - a) */
  GRAZE_FACE = 3,
  GRAZE_EDGE_AB = 4, /* v = 0 */
  GRAZE_EDGE_BC = 5, /* u + v = 1 */
  GRAZE_EDGE_CA = 6, /* u = 0 */
  GRAZE_VERTEX_A = 7,
  GRAZE_VERTEX_B = 8,
  GRAZE_VERTEX_C = 9,
  GRAZE_COPLANAR = 10,   /* t[0] to t[1]: the common part */
  GRAZE_DEGENERATE = 11, /* the same, of a triangle without area */
  /* points: the sign of f(p); for a sphere negative is inside */
  GRAZE_NEGATIVE = 12,
  GRAZE_ON = 13,
  GRAZE_POSITIVE = 14
};

/* Which of a sphere's roots lie in the ray's range: one that is alone is the first or the second. A tangent's is both. */
enum graze_root { GRAZE_ROOT_NONE = 0, GRAZE_ROOT_FIRST = 1, GRAZE_ROOT_SECOND = 2, GRAZE_ROOT_BOTH = 3 };

/* Where the ray's origin lies; told for a miss too. */
enum graze_origin { GRAZE_INSIDE = 0, GRAZE_ON_SURFACE = 1, GRAZE_OUTSIDE = 2 };

/* Which side the ray comes from: front where d . ((b - a) x (c - a)) < 0. Told for a miss too. */
enum graze_facing { GRAZE_FACING_NONE = 0, GRAZE_FRONT = 1, GRAZE_BACK = 2 };

/* What a kernel does otherwise than the contract. */
enum graze_deviation {
  GRAZE_COPLANAR_IS_MISS = 1 << 0,     /* a ray in the triangle's plane is answered miss */
  GRAZE_DEGENERATE_IS_MISS = 1 << 1,   /* a triangle without area is answered miss */
  GRAZE_EDGES_ARE_FACES = 1 << 2,      /* a hit at an edge or a corner is answered GRAZE_FACE */
  GRAZE_TANGENTS_ARE_SECANTS = 1 << 3, /* a tangent is answered GRAZE_SECANT */
  GRAZE_HIT_OR_MISS = 1 << 4,          /* every hit is answered GRAZE_FACE or GRAZE_SECANT */
  GRAZE_NEAREST_ROOT = 1 << 5,         /* of two roots in the range only the first is told */
  GRAZE_NO_ROOT = 1 << 6,              /* which root a lone value is, is not told; two are still GRAZE_ROOT_BOTH */
  GRAZE_NO_ORIGIN = 1 << 7,            /* where the origin lies is not told */
  GRAZE_NO_FACING = 1 << 8,            /* which side the ray comes from is not told */
  GRAZE_NO_COORDINATES = 1 << 9,       /* u and v are not told */
  GRAZE_INVALID_UNHANDLED = 1 << 10    /* invalid input gets any answer */
};

/* The cases, in double and in float. t_max may be +infinity; numbers may be anything, NaN included. */
struct graze_ray_sphere_double {
  double origin[3], direction[3], center[3], radius, t_min, t_max;
};
struct graze_ray_triangle_double {
  double origin[3], direction[3], a[3], b[3], c[3], t_min, t_max;
};
struct graze_point_line_double {
  double point[2], a, b, c; /* a x + b y + c */
};
struct graze_point_plane_double {
  double point[3], a, b, c, d; /* a x + b y + c z + d */
};
struct graze_point_sphere_double {
  double point[3], center[3], radius;
};
struct graze_ray_sphere_float {
  float origin[3], direction[3], center[3], radius, t_min, t_max;
};
struct graze_ray_triangle_float {
  float origin[3], direction[3], a[3], b[3], c[3], t_min, t_max;
};
struct graze_point_line_float {
  float point[2], a, b, c;
};
struct graze_point_plane_float {
  float point[3], a, b, c, d;
};
struct graze_point_sphere_float {
  float point[3], center[3], radius;
};

/* An answer; all zero when it is handed over. What its kind has no use for is not looked at. */
struct graze_answer_double {
  int32_t status; /* enum graze_status; where it is not GRAZE_OK nothing else counts */
  int32_t kind;   /* enum graze_kind */
  int32_t root;   /* enum graze_root */
  int32_t origin; /* enum graze_origin */
  int32_t facing; /* enum graze_facing */
  double t[2], u, v;
};
struct graze_answer_float {
  int32_t status, kind, root, origin, facing;
  float t[2], u, v;
};

/* Each function answers `count` cases, answers[i] for cases[i], and returns how many it answered. A null pointer is a query
 * that is not offered in that precision. */
struct graze_subject_double {
  size_t (*ray_sphere)(const struct graze_ray_sphere_double* cases, size_t count, struct graze_answer_double* answers);
  size_t (*ray_triangle)(const struct graze_ray_triangle_double* cases, size_t count, struct graze_answer_double* answers);
  size_t (*point_line)(const struct graze_point_line_double* cases, size_t count, struct graze_answer_double* answers);
  size_t (*point_plane)(const struct graze_point_plane_double* cases, size_t count, struct graze_answer_double* answers);
  size_t (*point_sphere)(const struct graze_point_sphere_double* cases, size_t count, struct graze_answer_double* answers);
};
struct graze_subject_float {
  size_t (*ray_sphere)(const struct graze_ray_sphere_float* cases, size_t count, struct graze_answer_float* answers);
  size_t (*ray_triangle)(const struct graze_ray_triangle_float* cases, size_t count, struct graze_answer_float* answers);
  size_t (*point_line)(const struct graze_point_line_float* cases, size_t count, struct graze_answer_float* answers);
  size_t (*point_plane)(const struct graze_point_plane_float* cases, size_t count, struct graze_answer_float* answers);
  size_t (*point_sphere)(const struct graze_point_sphere_float* cases, size_t count, struct graze_answer_float* answers);
};

struct graze_subject_description {
  uint32_t abi;        /* GRAZE_SUBJECT_ABI */
  uint32_t deviations; /* enum graze_deviation, or'ed */
  const char* name;    /* not empty, one line */
  const char* about;   /* one line: the formula and its source; may be null */
  /* Numbers within so many units in the last place are as declared; 0 demands correct rounding. A declared limit excuses -0
   * too. */
  double t_ulps;  /* t */
  double uv_ulps; /* u and v */
  struct graze_subject_double in_double;
  struct graze_subject_float in_float;
};

#if defined(_WIN32)
#define GRAZE_SUBJECT_EXPORT __declspec(dllexport)
#elif defined(__GNUC__)
#define GRAZE_SUBJECT_EXPORT __attribute__((visibility("default")))
#else
#define GRAZE_SUBJECT_EXPORT
#endif

/* Yours to define. What it returns must stay; it is called once, before any query. */
GRAZE_SUBJECT_EXPORT const struct graze_subject_description* graze_subject(void);

#ifdef __cplusplus
}
#endif

#endif
