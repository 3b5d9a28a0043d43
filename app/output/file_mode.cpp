#include "app/output/file_mode.h"

#include <sys/stat.h>

namespace artcal {

mode_t file_mode(mode_t mode) {
  // It can only be read by being set, for all threads: once.
  static const mode_t mask = [] {
    const mode_t found = ::umask(0);
    ::umask(found);
    return found;
  }();
  return mode & ~mask;
}

}  // namespace artcal
