#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "acquisition/arm/arm.h"
#include "acquisition/arm/arm_identification.h"
#include "core/error.h"
#include "core/files/input_file.h"

namespace artcal {

/// An arm with what is known of it. Format: docs/files.md, "arm.toml".
struct ArmFile {
  Arm arm;
  std::optional<ArmIdentification> identification;
  InputFile input;
};

Expected<ArmFile> read_arm_file(const std::filesystem::path& path);

/// The file's text: in mm, rad and what goes with them, with every digit, so that reading it back gives the same bits.
std::string arm_file_text(const Arm& arm, const std::optional<ArmIdentification>& identification);

}  // namespace artcal
