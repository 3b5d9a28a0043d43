#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "acquisition/arm/exchange/joint_chain.h"

namespace artcal {

/// Which chain of a robot's tree is wanted; empty names: its only root, its only leaf.
struct ChainEnds {
  std::string base;  ///< name of a link
  std::string tip;
};

/// Reads the chain of a URDF (wiki.ros.org/urdf/XML): joints of the types revolute, continuous, prismatic and fixed,
/// with their origins (m and rad there, mm and rad here), axes and limits.
///
/// Bad input: no URDF, or one that is to be expanded by xacro first; a link that is not there; more than one root or
/// leaf where none is named; joints that form no tree; a joint on the way that is floating or planar, follows another
/// one (mimic) or has no axis, by its name.
Expected<JointChain> read_urdf(const std::filesystem::path& path, const ChainEnds& ends);

}  // namespace artcal
