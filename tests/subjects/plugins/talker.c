/* A program that speaks the case protocol, badly: every ray misses, and one line in 499 meets the fault that is named.
 * talker FAULT: crash, hang, garbage, quiet, chatty, endless, leave, unflushed, honest */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static int is_at_fault(const char* line) {
  unsigned hash = 2166136261u;
  for (; *line != '\0' && *line != '\n'; ++line) hash = (hash ^ (unsigned char)*line) * 16777619u;
  return hash % 499 == 0;
}

static void answer_wrongly(const char* fault) {
  if (strcmp(fault, "crash") == 0) raise(SIGSEGV);
  if (strcmp(fault, "hang") == 0) sleep(1000);
  if (strcmp(fault, "leave") == 0) exit(3);
  if (strcmp(fault, "garbage") == 0) puts("miss 1 2 \xff");
  if (strcmp(fault, "chatty") == 0) puts("miss\nmiss");
  if (strcmp(fault, "endless") == 0) {
    for (int i = 0; i < 10000; ++i) fputs("miss", stdout);
    fflush(stdout);
    sleep(1000);
  }
}

int main(int argc, char** argv) {
  static char line[4096];
  const char* fault = argc > 1 ? argv[1] : "honest";
  puts("# comments and blank lines are no answers\n");
  while (fgets(line, sizeof line, stdin) != NULL) {
    if (strncmp(line, "ray_", 4) != 0) {
      puts("not_offered");
    } else if (strcmp(fault, "honest") == 0 || strcmp(fault, "unflushed") == 0 || !is_at_fault(line)) {
      puts("miss");
    } else {
      answer_wrongly(fault);
    }
    if (strcmp(fault, "unflushed") != 0) fflush(stdout);
  }
  return 0;
}
