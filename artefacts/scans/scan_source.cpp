#include "artefacts/scans/scan_source.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "acquisition/point_cloud/cloud_limits.h"
#include "acquisition/recording/tip_centres.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

constexpr double tolerance_of_nominal_arm = 10.0;   // mm, of a distance
constexpr double distortion_by_nominal_arm = 0.04;  // of the radius
constexpr std::size_t max_named = 200;              // characters of a list in a message

Expected<int> artefact_of(const RecordedScan& scan, const std::vector<Artefact>& artefacts) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < artefacts.size(); ++i) {
    if (artefacts[i].name == scan.artefact || (scan.artefact.empty() && artefacts.size() == 1)) {
      return static_cast<int>(i);
    }
    names.push_back(artefacts[i].name);
  }
  const auto known = truncated(max_named, fmt::format("{}", fmt::join(names, ", ")));
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
  const auto known = truncated(max_named, fmt::format("{}", fmt::join(names, ", ")));
  return bad_input(scan.probe.empty()
                       ? fmt::format("the scan names no probe, and the arm has several: {}", known)
                       : fmt::format("the scan names the probe {}, expected one of: {}", in_quotes(scan.probe), known),
                   scan.where);
}

Expected<PointCloud> cloud_of(const RecordedScan& scan, const Arm& arm, const ScanSelection& selection) {
  auto cloud = read_cloud(scan.path, scan.units, {}, CloudLimits{selection.max_memory}).map([](ReadCloud&& read) {
    return std::move(read.cloud);
  });
  if (!cloud) {
    return cloud;
  }
  const auto joints = static_cast<Eigen::Index>(arm.joints.size());
  if (joints == 0 || cloud->joints.rows() == 0) {
    if (selection.use == ScanUse::WholeBalls) {
      cloud->joints.resize(0, 0);
      return cloud;
    }
    return joints == 0
               ? bad_input("a scan becomes readings by its joint angles, but the recording names no arm", scan.where)
               : bad_input(fmt::format("the scan has no joint angles; identification needs q1 … q{} beside x, y and z",
                                       joints),
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

// Of the tip, by the arm that is judged where there is one; it may have been identified.
double radius_of(const Recording& recording, int probe, const Arm* judged) {
  const Probe& named = recording.arm.probes[static_cast<std::size_t>(probe)];
  const int index = judged != nullptr ? probe_index(*judged, named.name) : -1;
  return index < 0 ? named.radius : judged->probes[static_cast<std::size_t>(index)].radius;
}

// By the arm that is given, or the recording's own; as reported where there are no joint angles.
Expected<Eigen::Matrix3Xd> tips_in_base(const Recording& recording, const RecordedScan& scan, const PointCloud& cloud,
                                        int probe, const Arm* arm) {
  if (cloud.joints.rows() == 0) {
    return cloud.points;
  }
  Recording posed;
  posed.arm = recording.arm;
  for (int i = 0; i < static_cast<int>(posed.arm.probes.size()); ++i) {
    posed.arm.probes[static_cast<std::size_t>(i)].radius = radius_of(recording, i, arm);
  }
  posed.files = {scan.path};
  posed.joints = cloud.joints;
  Reading reading;
  reading.probe = probe;
  reading.arm_temperature = scan.arm_temperature.value_or(Reading::not_read);
  posed.readings.assign(static_cast<std::size_t>(cloud.joints.cols()), reading);
  return tip_centres(posed, arm != nullptr ? *arm : recording.arm).map([](TipCentres&& tips) {
    return std::move(tips.in_base);
  });
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

}  // namespace

Expected<ScanSource> open_scan(const Recording& recording, const RecordedScan& scan,
                               const std::vector<Artefact>& artefacts, const ScanSelection& selection) {
  const auto index = artefact_of(scan, artefacts);
  if (!index) {
    return tl::unexpected(index.error());
  }
  ScanSource source;
  source.artefact = &artefacts[static_cast<std::size_t>(*index)];
  const auto probe = probe_of(scan, recording.arm);
  if (!probe) {
    return tl::unexpected(probe.error());
  }
  source.probe = *probe;
  auto wanted = wanted_of(scan, *source.artefact, radius_of(recording, *probe, selection.arm));
  if (!wanted) {
    return tl::unexpected(wanted.error());
  }
  source.wanted = std::move(*wanted);
  auto options = options_of(scan, *source.artefact, source.wanted);
  if (!options) {
    return tl::unexpected(options.error());
  }
  source.options = std::move(*options);
  auto cloud = cloud_of(scan, recording.arm, selection);
  if (!cloud) {
    return tl::unexpected(cloud.error());
  }
  source.cloud = std::move(*cloud);
  auto tips = tips_in_base(recording, scan, source.cloud, source.probe, selection.arm);
  if (!tips) {
    return tl::unexpected(tips.error());
  }
  source.tips_in_base = std::move(*tips);
  return source;
}

}  // namespace artcal
