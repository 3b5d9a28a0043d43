#pragma once

#include <sys/types.h>

namespace artcal {

/// Of these permissions (0666 for a new file, 0777 for a new folder) those that the user's umask leaves. Temporary
/// files and folders are made for their owner alone, whatever the umask. Any number of threads may ask.
mode_t file_mode(mode_t mode);

}  // namespace artcal
