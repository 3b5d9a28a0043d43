#pragma once

#include <string>

namespace artcal {

/// A path as a file in `folder` names it from its own folder; both as seen from the working folder. An absolute path
/// stays one.
std::string path_from_folder(const std::string& path, const std::string& folder);

}  // namespace artcal
