#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"

namespace artcal {

/// Which files an input file may refer to. A recording may have been made by somebody else: it must not make the
/// program read any file of this computer that it likes.
class FileAccess {
 public:
  /// Every file: the user has said so.
  static FileAccess anywhere();
  /// What lies in the folder of `file`, in folders below it, or beside that folder; in the folder alone where it lies
  /// directly under the root of the file system. For a file that the user has named.
  static FileAccess beside(const std::filesystem::path& file);
  /// What lies in one of the folders or below it. Links are followed first.
  static FileAccess below(const std::vector<std::filesystem::path>& folders);

  /// Whether the file may be read. Does not look whether it is there.
  [[nodiscard]] bool allows(const std::filesystem::path& file) const;

  /// `name` as it is written in a file of `folder`, as a path; refused where it may not be read. `where` is the place
  /// of the name, for the message.
  [[nodiscard]] Expected<std::filesystem::path> resolve(const std::filesystem::path& folder, std::string_view name,
                                                        const std::string& where) const;

 private:
  bool anywhere_ = false;
  std::vector<std::filesystem::path> folders_;  // canonical
};

}  // namespace artcal
