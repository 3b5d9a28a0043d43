#include "app/templates/plan_template.h"

#include <fmt/format.h>

#include "app/requests/path_from_folder.h"
#include "app/templates/answers.h"
#include "artefacts/artefact/artefact_file.h"
#include "core/toml/toml_text.h"

namespace artcal {
namespace {

constexpr const char* plan_form =
    R"(# A plan to start from: what artcal simulate makes a recording of a virtual arm from, with the true values beside it.
#   artcal simulate PLAN -o simulated
#   artcal identify simulated/recording.toml
# Every key is described in docs/files.md, "plan.toml".
schema = "artcal-plan/1"
name = {name}

# The nominal arm, and what is measured; paths from this file's folder.
arm = {arm}
artefacts = [{artefact}]

# Another seed draws other errors, noise and placements.
seed = 1

# Of the bare numbers in this file.
units = {{ length = "mm", angle = "deg" }}

# The true arm differs from the nominal one by draws of these standard deviations. exact = ["a2"] keeps parameters.
[errors]
length = "0.3 mm"
angle = "0.1 deg"

# Standard deviations of each joint's reading and of each coordinate of the tip.
[noise]
encoder = {encoder}
probing = {probing}

# Where the artefact stands: drawn within the arm's reach. Or one [[placement]] each with a place of its own:
#   position = [600, 200, 0]
#   turn = [0, 0, 30]
#   temperature_C = 21.5
[[placement]]
name = "anywhere"
random = {placements}

# What is probed: all features, so many points on each, every one in a posture of its own.
[[probing]]
points = {points}
)";

// Of the faces of a gauge block a distance alone is certified, and a simulation needs their places.
std::string faces_text(const std::string& artefact) {
  const auto file = read_artefact_file(artefact);
  if (!file || file->artefact.type != ArtefactType::GaugeBlock || file->artefact.distances.size() != 1) {
    return "";
  }
  const CertifiedDistance& distance = file->artefact.distances.front();
  const auto face = [&](int feature, double x, int ahead) {
    return fmt::format("\n[[true_feature]]\nfeature = {}\nat = [{}, 0, 0]\nnormal = [{}, 0, 0]\n",
                       toml_text(file->artefact.features[static_cast<std::size_t>(feature)].name), toml_number(x),
                       ahead);
  };
  return "\n# Where the faces are, which the certificate does not state.\n" + face(distance.first, 0.0, -1) +
         face(distance.second, distance.value, 1);
}

}  // namespace

std::vector<Choice> PlanTemplate::choices() {
  const auto is_number = [](const std::string& n) { return is_count(n, 1, 1000); };
  return {{"--name", "NAME", "name of the plan", &name, {}, is_name, "a name"},
          {"--arm", "ARM", "file of the nominal arm", &arm, {}, is_path, "a path"},
          {"--artefact", "ARTEFACT", "file of the artefact", &artefact, {}, is_path, "a path"},
          {"--placements", "N", "number of placements", &placements, {}, is_number, "a number from 1 to 1000", 1, 1000},
          {"--points", "N", "points on each feature", &points, {}, is_number, "a number from 1 to 1000", 1, 1000},
          {"--encoder-noise",
           "TEXT",
           "standard deviation of a joint's reading, with its unit",
           &encoder_noise,
           {},
           is_angle,
           "an angle with its unit, such as \"2 arcsec\""},
          {"--probing-noise",
           "TEXT",
           "standard deviation of a coordinate of the tip, with its unit",
           &probing_noise,
           {},
           is_length,
           "a length with its unit, such as \"3 um\""}};
}

std::string PlanTemplate::text(const std::string& folder) const {
  return fmt::format(fmt::runtime(plan_form), fmt::arg("name", toml_text(name)),
                     fmt::arg("arm", toml_text(path_from_folder(arm, folder))),
                     fmt::arg("artefact", toml_text(path_from_folder(artefact, folder))),
                     fmt::arg("encoder", toml_text(encoder_noise)), fmt::arg("probing", toml_text(probing_noise)),
                     fmt::arg("placements", placements), fmt::arg("points", points)) +
         faces_text(artefact);
}

}  // namespace artcal
