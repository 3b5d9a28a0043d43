#include "app/templates/recording_template.h"

#include <fmt/format.h>

#include "app/requests/path_from_folder.h"
#include "app/templates/answers.h"
#include "core/toml/toml_text.h"
#include "core/unit_names.h"

namespace artcal {
namespace {

constexpr const char* recording_head =
    R"(# A recording to start from: which readings were taken with which arm on which artefact.
#   artcal inspect FILE, artcal identify FILE -o identified.toml, artcal verify FILE
# Every key is described in docs/files.md, "recording.toml".
schema = "artcal-recording/1"
name = {name}

# Of the measurement: certificates are held against it.
# date = 2026-03-10
)";

constexpr const char* form_with_arm = R"(
# The nominal arm, at which an identification starts, or the arm that is verified. Paths are from this file's folder.
arm = {arm}
artefacts = [{artefact}]

# Tables of readings: a first line names the columns, placement,feature,q1,q2, … and perhaps temperature; one line a reading.
# The same placement is the same place of the artefact.
readings = [{readings}]

# joint: of q1 … qn. length: of the columns length and ref_x, ref_y, ref_z.
units = {{ joint = {joint}, length = {length} }}
)";

constexpr const char* form_with_coordinates = R"(
# What was measured. Paths are from this file's folder.
artefacts = [{artefact}]

# Tables of readings: a first line names the columns, placement,feature,x,y,z and perhaps temperature; one line a reading.
# The coordinates are those of the tip's centre, as the arm's own software reported them.
readings = [{readings}]
units = {{ length = {length} }}
)";

// `[[probe]]` of a recording is behind its keys.
constexpr const char* tip_form = R"(
# The tip that took them, in the unit of lengths; 0 for points of the surface or centres of features.
[[probe]]
radius = {radius}
)";

constexpr const char* noise_example = R"(
# Standard deviations of the readings; without them they are estimated from the residuals.
# [noise]
# {}
)";

std::string noise_form_text(bool has_joints, const std::string& encoder, const std::string& probing) {
  if (probing == "none") {
    return fmt::format(fmt::runtime(noise_example),
                       has_joints ? "encoder = \"2 arcsec\"\n# probing = \"3 um\"" : "reading = \"3 um\"");
  }
  return "\n# Standard deviations of the readings.\n[noise]\n" +
         (has_joints ? fmt::format("encoder = {}\nprobing = {}\n", toml_text(encoder), toml_text(probing))
                     : fmt::format("reading = {}\n", toml_text(probing)));
}

}  // namespace

std::vector<Choice> RecordingTemplate::choices() {
  return {{"--name", "NAME", "name of the recording", &name, {}, is_name, "a name"},
          {"--readings-are", "", "what the readings are", &readings_are, {"joint-angles", "coordinates"}, nullptr, ""},
          {"--arm", "ARM", "file of the arm, for joint angles", &arm, {}, is_path, "a path"},
          {"--artefact", "ARTEFACT", "file of the artefact", &artefact, {}, is_path, "a path"},
          {"--readings", "CSV", "file of the readings", &readings, {}, is_path, "a path"},
          {"--joint-unit", "", "unit of joint angles", &joint_unit, angle_unit_names(), nullptr, ""},
          {"--length-unit", "", "unit of lengths", &length_unit, length_unit_names(), nullptr, ""},
          {"--tip-radius",
           "TEXT",
           "radius of the tip that took coordinates, with its unit",
           &tip_radius,
           {},
           is_length,
           "a length with its unit, such as \"3 mm\""},
          {"--encoder-noise",
           "TEXT",
           "standard deviation of a joint's reading, or none: estimated",
           &encoder_noise,
           {},
           is_angle_or_none,
           "an angle with its unit, such as \"2 arcsec\", or none"},
          {"--probing-noise",
           "TEXT",
           "standard deviation of a coordinate of the tip, or none: estimated",
           &probing_noise,
           {},
           is_length_or_none,
           "a length with its unit, such as \"3 um\", or none"},
          {"--standard",
           "",
           "standard that the arm is verified by",
           &standard,
           {"none", "iso10360-12", "b89.4.22", "sphere-plate"},
           nullptr,
           ""}};
}

Expected<std::string> RecordingTemplate::text(const std::string& folder) const {
  if (!has_joints() && encoder_noise != "none") {
    return wrong_usage("--encoder-noise is for joint angles, and the readings are coordinates");
  }
  if (has_joints() && (encoder_noise == "none") != (probing_noise == "none")) {
    return wrong_usage("one of --encoder-noise and --probing-noise is stated, expected both or neither");
  }
  const double mm = *artcal::length_unit(length_unit);
  const auto filled = [&](const char* recording_form) {
    return fmt::format(fmt::runtime(recording_form), fmt::arg("name", toml_text(name)),
                       fmt::arg("arm", toml_text(path_from_folder(arm, folder))),
                       fmt::arg("artefact", toml_text(path_from_folder(artefact, folder))),
                       fmt::arg("readings", toml_text(path_from_folder(readings, folder))),
                       fmt::arg("joint", toml_text(joint_unit)), fmt::arg("length", toml_text(length_unit)),
                       fmt::arg("radius", toml_number(*length_quantity(tip_radius) / mm)));
  };
  std::string text = filled(recording_head) + filled(has_joints() ? form_with_arm : form_with_coordinates);
  if (!has_joints()) {
    text += filled(tip_form);
  }
  text += noise_form_text(has_joints(), encoder_noise, probing_noise);
  if (has_joints()) {
    text += "\n# What this recording always wants of an identification.\n# [identify]\n# hold = [\"d2\"]\n";
  }
  return text + (standard == "none"
                     ? "\n# [verify]\n# standard = \"sphere-plate\"\n"
                     : fmt::format("\n# The arm is to be verified by these readings.\n[verify]\nstandard = {}\n",
                                   toml_text(standard)));
}

std::vector<std::string> RecordingTemplate::named_files() const {
  return has_joints() ? std::vector<std::string>{arm, artefact, readings}
                      : std::vector<std::string>{artefact, readings};
}

}  // namespace artcal
