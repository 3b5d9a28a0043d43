#include "app/results/recorded/recorded_head.h"

namespace artcal {
namespace {

RecordedArtefact recorded_artefact(const RecordedObject& artefact) {
  RecordedArtefact read;
  read.name = artefact.text_or("name");
  read.type = artefact.text_or("type");
  read.is_certified = artefact.has("certificate");
  if (read.is_certified) {
    const RecordedObject certificate = artefact.object("certificate");
    read.number = certificate.text_or("number");
    read.laboratory = certificate.text_or("laboratory");
    read.date = certificate.text_or("date");
    read.valid_until = certificate.text_or("valid_until");
  }
  return read;
}

}  // namespace

RecordedHead recorded_head(const RecordedObject& result) {
  const RecordedObject program = result.object("program");
  return {result.text("kind"),
          result.text("arm"),
          result.text_or("recording"),
          result.text_or("date"),
          program.text("name"),
          program.text("version"),
          result.list("inputs", [](const RecordedObject& input) {
            return InputFile{input.text("path"), input.text("sha256")};
          })};
}

RecordedCircumstances recorded_circumstances(const RecordedObject& result) {
  RecordedCircumstances read;
  if (result.has("temperature")) {
    const RecordedObject temperature = result.object("temperature");
    read.temperatures = {temperature.number("lowest_C"), temperature.number("highest_C")};
  }
  if (result.has("readings")) {
    read.readings = result.count("readings");
  } else {
    const RecordedObject counts = result.object("counts");
    read.readings = counts.count("readings");
    read.features = counts.count("features");
    read.placements = counts.count("placements");
  }
  read.artefacts = result.list("artefacts", recorded_artefact);
  read.warnings = result.texts("warnings");
  return read;
}

std::vector<Eigen::Vector3d> recorded_arm_path(const RecordedObject& result) {
  return result.has("arm_shape") ? result.object("arm_shape").points("path_mm") : std::vector<Eigen::Vector3d>();
}

}  // namespace artcal
