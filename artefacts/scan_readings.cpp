#include "artefacts/scan_readings.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/point_cloud.h"
#include "acquisition/sweep.h"
#include "artefacts/scan_contents.h"
#include "artefacts/scan_refusal.h"
#include "core/in_quotes.h"

namespace artcal {
namespace {

constexpr double tolerance_of_nominal_arm = 10.0;   // mm, of a distance
constexpr double distortion_by_nominal_arm = 0.04;  // of the radius
constexpr std::size_t most_named = 200;             // characters of a list in a message

Expected<int> artefact_of(const RecordedScan& scan, const std::vector<Artefact>& artefacts) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (artefacts[i].name == scan.artefact || (scan.artefact.empty() && artefacts.size() == 1)) {
      return static_cast<int>(i);
    }
    names.push_back(artefacts[i].name);
  }
  const auto known = at_most(most_named, fmt::format("{}", fmt::join(names, ", ")));
  return bad_input(scan.artefact.empty() ? fmt::format("the scan names no artefact, and there are several: {}", known)
                                         : fmt::format("the scan names the artefact {}, expected one of: {}",
                                                       in_quotes(scan.artefact), known),
                   scan.where);
}

Expected<int> probe_of(const RecordedScan& scan, const Arm& arm) {
  if (scan.probe.empty() && arm.probes.size() == 1) {
    return 0;
  }
  if (const int index = probe_index(arm, scan.probe); index >= 0) {
    return index;
  }
  std::vector<std::string> names;
  for (const Probe& probe : arm.probes) {
    names.push_back(probe.name);
  }
  const auto known = at_most(most_named, fmt::format("{}", fmt::join(names, ", ")));
  return bad_input(scan.probe.empty()
                       ? fmt::format("the scan names no probe, and the arm has several: {}", known)
                       : fmt::format("the scan names the probe {}, expected one of: {}", in_quotes(scan.probe), known),
                   scan.where);
}

Expected<PointCloud> read_cloud(const RecordedScan& scan, const Arm& arm) {
  auto cloud = read_point_cloud(scan.path, scan.units);
  if (!cloud) {
    return cloud;
  }
  const auto joints = static_cast<Eigen::Index>(arm.joints.size());
  if (cloud->joints.rows() == 0) {
    return bad_input(
        fmt::format("the scan has no joint angles; identification needs q1 … q{} beside x, y and z", joints),
        scan.path);
  }
  if (cloud->joints.rows() != joints) {
    return bad_input(
        fmt::format("the scan has joint angles q1 … q{}, but the arm {} has {} joints; is it the right arm?",
                    cloud->joints.rows(), in_quotes(arm.name), joints),
        scan.path);
  }
  return cloud;
}

Eigen::Matrix3Xd tips_in_base(const Arm& arm, int probe, const Eigen::MatrixXd& joints) {
  const Sweep sweep(arm, {}, probe);
  Eigen::Matrix3Xd tips(3, joints.cols());
  std::vector<double> sines(2 * arm.joints.size());
  for (Eigen::Index i = 0; i < joints.cols(); ++i) {
    joint_sines({joints.col(i).data(), arm.joints.size()}, sines);
    tips.col(i) = sweep.tip_in_base(sines);
  }
  return tips;
}

// Where the tip's centre is while it touches the artefact's spheres.
Expected<ArtefactInScan> wanted_of(const RecordedScan& scan, const Artefact& artefact, double tip_radius) {
  auto wanted = scan_contents(artefact, scan.temperature.value_or(artefact.reference_temperature));
  if (!wanted) {
    return bad_input(wanted.error().message, scan.where);
  }
  if (wanted->spheres.empty()) {
    return bad_input(
        fmt::format("the artefact {} has no sphere; scans become readings on spheres only", in_quotes(artefact.name)),
        scan.where);
  }
  for (double& radius : wanted->contents.radii) {
    radius += tip_radius;
  }
  wanted->contents.planes = 0;
  return wanted;
}

Expected<SegmentOptions> options_of(const RecordedScan& scan, const Artefact& artefact, const ArtefactInScan& wanted) {
  SegmentOptions options;
  options.tolerance = scan.tolerance.value_or(tolerance_of_nominal_arm);
  options.distortion =
      distortion_by_nominal_arm * *std::min_element(wanted.contents.radii.begin(), wanted.contents.radii.end());
  for (const SpherePlace& place : scan.places) {
    const auto at = std::find_if(wanted.spheres.begin(), wanted.spheres.end(), [&](int feature) {
      return artefact.features[static_cast<std::size_t>(feature)].name == place.sphere;
    });
    if (at == wanted.spheres.end()) {
      return bad_input(fmt::format("the scan says where the sphere {} is, which the artefact {} does not have",
                                   in_quotes(place.sphere), in_quotes(artefact.name)),
                       scan.where);
    }
    options.hints.push_back({static_cast<int>(at - wanted.spheres.begin()), place.at_in_base});
  }
  return options;
}

/// Adds readings on one sphere; `used` are columns of the cloud.
class ReadingsOfScan {
 public:
  ReadingsOfScan(Recording& recording, const RecordedScan& scan, const PointCloud& cloud, int probe)
      : recording_(recording), cloud_(cloud) {
    recording_.inputs.push_back(cloud.input);
    recording_.files.push_back(scan.path);
    reading_.artefact = recording_.artefacts.index_of(scan.artefact);
    reading_.placement = recording_.placements.index_of(scan.placement);
    reading_.orientation = recording_.orientations.index_of("");
    reading_.repeat = recording_.repeats.index_of("");
    reading_.probe = probe;
    reading_.temperature = scan.temperature.value_or(Reading::not_read);
    reading_.file = static_cast<int>(recording_.files.size()) - 1;
  }
  void add(const std::string& feature, const std::vector<int>& used) {
    reading_.feature = recording_.features.index_of(feature);
    const Eigen::Index before = recording_.joints.cols();
    recording_.joints.conservativeResize(cloud_.joints.rows(), before + static_cast<Eigen::Index>(used.size()));
    for (std::size_t i = 0; i < used.size(); ++i) {
      reading_.line = cloud_.rows[static_cast<std::size_t>(used[i])] + 1;
      recording_.readings.push_back(reading_);
      recording_.joints.col(before + static_cast<Eigen::Index>(i)) = cloud_.joints.col(used[i]);
    }
  }

 private:
  Recording& recording_;
  const PointCloud& cloud_;
  Reading reading_{};
};

std::vector<int> thinned(const std::vector<int>& points, int every) {
  std::vector<int> kept;
  for (std::size_t i = 0; i < points.size(); i += static_cast<std::size_t>(every)) {
    kept.push_back(points[i]);
  }
  return kept;
}

std::string told(const RecordedScan& scan, const PointCloud& cloud, std::size_t used,
                 const std::vector<std::string>& counts, const std::vector<std::string>& missing) {
  const std::string thinning = scan.use_every > 1 ? fmt::format(" (use_every = {})", scan.use_every) : "";
  std::string text =
      fmt::format("{}: {} of {} points became readings{}: {}; the others were not used", scan.path, used,
                  cloud.points.cols(), thinning, at_most(most_named, fmt::format("{}", fmt::join(counts, ", "))));
  if (!missing.empty()) {
    text += fmt::format(". Not found: {}", at_most(most_named, fmt::format("{}", fmt::join(missing, ", "))));
  }
  return text;
}

Expected<void> read_scan(Recording& recording, const RecordedScan& scan, const std::vector<Artefact>& artefacts) {
  const auto index = artefact_of(scan, artefacts);
  if (!index) {
    return tl::unexpected(index.error());
  }
  const Artefact& artefact = artefacts[static_cast<std::size_t>(*index)];
  const auto probe = probe_of(scan, recording.arm);
  if (!probe) {
    return tl::unexpected(probe.error());
  }
  const auto wanted = wanted_of(scan, artefact, recording.arm.probes[static_cast<std::size_t>(*probe)].radius);
  if (!wanted) {
    return tl::unexpected(wanted.error());
  }
  const auto options = options_of(scan, artefact, *wanted);
  if (!options) {
    return tl::unexpected(options.error());
  }
  const auto cloud = read_cloud(scan, recording.arm);
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  const auto found = segment(tips_in_base(recording.arm, *probe, cloud->joints), wanted->contents, *options);
  if (!found) {
    return tl::unexpected(Error{found.error().code, found.error().message, scan.path});
  }
  if (found->status != SegmentStatus::Complete && found->status != SegmentStatus::Partial) {
    return tl::unexpected(Error{ErrorCode::NoSolution, scan_refusal(*found, *wanted, artefact), scan.path});
  }
  for (const auto& warning : cloud->warnings) {
    recording.warnings.push_back(fmt::format("{}: {}", scan.path, warning));
  }
  ReadingsOfScan readings(recording, scan, *cloud, *probe);
  std::size_t used = 0;
  std::vector<std::string> counts, missing;
  for (std::size_t i = 0; i < found->spheres.size(); ++i) {
    const std::string& name = artefact.features[static_cast<std::size_t>(wanted->spheres[i])].name;
    if (!found->spheres[i]) {
      missing.push_back(name);
      continue;
    }
    const auto points = thinned(found->spheres[i]->points, scan.use_every);
    readings.add(name, points);
    used += points.size();
    counts.push_back(fmt::format("{} {}", name, points.size()));
  }
  recording.warnings.push_back(told(scan, *cloud, used, counts, missing));
  return {};
}

}  // namespace

Expected<void> read_scans(Recording& recording, const std::vector<Artefact>& artefacts) {
  std::set<std::string> paths;
  for (const RecordedScan& scan : recording.scans) {
    if (!paths.insert(scan.path).second) {
      return bad_input(fmt::format("the scan {} is named twice; its points would count twice", in_quotes(scan.path)),
                       scan.where);
    }
    if (auto read = read_scan(recording, scan, artefacts); !read) {
      return read;
    }
  }
  return {};
}

}  // namespace artcal
