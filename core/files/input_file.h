#pragma once

#include <string>

namespace artcal {

/// A file that a result rests on.
struct InputFile {
  std::string path;
  std::string sha256;
};

}  // namespace artcal
