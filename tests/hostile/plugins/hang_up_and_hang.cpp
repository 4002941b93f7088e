// Closes every file of the process, the probe's pipe among them, and then never ends.
#include <unistd.h>

__attribute__((constructor)) static void hang() {
  for (int file = 0; file < 1024; ++file) ::close(file);
  for (;;) ::pause();
}
