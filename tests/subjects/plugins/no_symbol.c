/* A shared library that is no kernel. */
int graze_something_else(void) {
  return 1;
}
