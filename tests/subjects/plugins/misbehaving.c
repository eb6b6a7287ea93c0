/* The example kernel with a fault on some cases, chosen at compile time by FAULT: what the certifier has to live with. */
#define graze_subject honest_subject
#include "fuzz/plugin_example/my_kernel.c"
#undef graze_subject

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { crash = 1, hang, garbage, too_few, lie, leave, only_in_batches, wrong_abi, no_name, crash_at_load };

/* One case in 499, by its bits. */
static int is_at_fault(const struct graze_ray_triangle_double* in) {
  unsigned char bytes[sizeof *in];
  unsigned hash = 2166136261u;
  memcpy(bytes, in, sizeof bytes);
  for (size_t i = 0; i < sizeof bytes; ++i) hash = (hash ^ bytes[i]) * 16777619u;
  return hash % 499 == 0;
}

static size_t faulty(const struct graze_ray_triangle_double* cases, size_t count, struct graze_answer_double* answers) {
  ray_triangle(cases, count, answers);
  if (FAULT == only_in_batches && count > 20) abort();
  for (size_t i = 0; i < count; ++i) {
    if (!is_at_fault(&cases[i])) continue;
    if (FAULT == crash) abort();
    if (FAULT == hang) sleep(1000);
    if (FAULT == garbage) answers[i].kind = 77;
    if (FAULT == too_few) return i;
    if (FAULT == lie) answers[i].facing = answers[i].facing == GRAZE_FRONT ? GRAZE_BACK : GRAZE_FRONT;
    if (FAULT == leave) exit(3);
  }
  return count;
}

GRAZE_SUBJECT_EXPORT const struct graze_subject_description* graze_subject(void) {
  static struct graze_subject_description description;
  if (FAULT == crash_at_load) abort();
  description = *honest_subject();
  description.in_double.ray_triangle = faulty;
  if (FAULT == wrong_abi) description.abi = 7;
  if (FAULT == no_name) description.name = "";
  return &description;
}
