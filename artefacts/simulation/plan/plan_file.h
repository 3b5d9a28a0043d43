#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "artefacts/simulation/plan/plan.h"
#include "core/error.h"
#include "core/files/file_access.h"
#include "core/files/input_file.h"

namespace artcal {

/// A plan with the files it rests on.
struct PlanFile {
  SimulationPlan plan;
  std::filesystem::path arm;                     ///< of the nominal arm
  std::vector<std::filesystem::path> artefacts;  ///< as SimulationPlan::artefacts
  /// The digital certificate that an artefact names.
  struct CertificateFile {
    std::string name;            ///< as the artefact's file has it
    std::filesystem::path path;  ///< empty: it names none
  };
  std::vector<CertificateFile> certificates;  ///< as artefacts
  std::vector<InputFile> inputs;              ///< the plan first
};

/// Reads plan.toml, the arms and the artefacts it names; paths are taken from the plan's own folder. Format:
/// docs/files.md, "plan.toml". Refused beside what all files refuse: true and nominal arms that differ in more
/// than their numbers, a negative noise, stops without room between them, names that nothing has, a placement
/// that nothing probes, a plan without readings or with more than most_planned_readings.
/// Refused too: a reference to a file that `access` does not allow; without it, all are allowed.
Expected<PlanFile> read_plan_file(const std::filesystem::path& path);
Expected<PlanFile> read_plan_file(const std::filesystem::path& path, const FileAccess& access);

}  // namespace artcal
