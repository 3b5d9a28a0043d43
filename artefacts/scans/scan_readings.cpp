#include "artefacts/scans/scan_readings.h"

#include <filesystem>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "artefacts/scans/scan_refusal.h"
#include "artefacts/scans/scan_source.h"
#include "core/text/in_quotes.h"
#include "fitting/segmentation/spheres/ball_region.h"

namespace artcal {
namespace {

constexpr std::size_t max_listed = 200;  // characters of a list in a message

/// Adds readings on one sphere; `used` are columns of the cloud.
class ReadingsOfScan {
 public:
  ReadingsOfScan(Recording& recording, const RecordedScan& scan, const ScanSource& source)
      : recording_(recording), cloud_(source.cloud) {
    recording_.inputs.push_back(cloud_.input);
    recording_.files.push_back(scan.path);
    reading_.artefact = recording_.artefacts.index_of(scan.artefact);
    reading_.placement = recording_.placements.index_of(scan.placement);
    reading_.orientation = recording_.orientations.index_of(scan.orientation);
    reading_.repeat = recording_.repeats.index_of(scan.repeat);
    reading_.probe = source.probe;
    reading_.temperature = scan.temperature.value_or(Reading::not_read);
    reading_.arm_temperature = scan.arm_temperature.value_or(Reading::not_read);
    reading_.file = static_cast<int>(recording_.files.size()) - 1;
  }
  void add(const std::string& feature, const std::vector<int>& used) {
    reading_.feature = recording_.features.index_of(feature);
    const Eigen::Index before = recording_.joints.cols();
    recording_.joints.conservativeResize(static_cast<Eigen::Index>(recording_.arm.joints.size()),
                                         before + static_cast<Eigen::Index>(used.size()));
    const bool has_joints = cloud_.joints.rows() > 0;
    for (std::size_t i = 0; i < used.size(); ++i) {
      reading_.line = cloud_.rows[static_cast<std::size_t>(used[i])] + 1;
      auto joints = recording_.joints.col(before + static_cast<Eigen::Index>(i));
      if (has_joints) {
        joints = cloud_.joints.col(used[i]);
      } else {
        joints.setConstant(Reading::not_read);
        reading_.tip = cloud_.points.col(used[i]);
      }
      recording_.readings.push_back(reading_);
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

/// The points on one sphere, and what is told of them.
struct PointsOfBall {
  std::vector<int> points;
  std::string told;
};

std::string not_clear(const BallRegion& region, const std::string& name) {
  const auto in_band = region.points.size() + static_cast<std::size_t>(region.beside_foreign);
  return fmt::format(
      "where the ball {} ends is not determined, nor its size and form: of {} points within {:.3g} mm of it {} lie "
      "beside points that are no part of it, and of the others {} are more than {:.3g} mm off; was it scanned too "
      "roughly for its size, or with another arm or probe?",
      in_quotes(name), in_band, region.band, region.beside_foreign, region.far_off, 0.5 * region.band);
}

Expected<PointsOfBall> whole_ball(const RecordedScan& scan, const ScanSource& source, const std::string& name,
                                  const Sphere& sphere) {
  const BallRegion region = ball_region(source.tips_in_base, sphere);
  if (!region.is_clear()) {
    return tl::unexpected(Error{ErrorCode::NoSolution, not_clear(region, name), scan.path});
  }
  std::vector<int> points = thinned(region.points, scan.use_every);
  std::string told = fmt::format("{} {} over some {:.0f} % of it", name, points.size(), 100.0 * region.share);
  if (region.far_off > 0) {
    told += fmt::format(" ({} more than {:.3g} mm off)", region.far_off, 0.5 * region.band);
  }
  return PointsOfBall{std::move(points), std::move(told)};
}

Expected<PointsOfBall> points_of(const RecordedScan& scan, const ScanSource& source, const std::string& name,
                                 const FoundSphere& found, ScanUse use) {
  if (use == ScanUse::WholeBalls) {
    return whole_ball(scan, source, name, {found.fitted.feature.centre, found.radius_wanted});
  }
  std::vector<int> points = thinned(found.points, scan.use_every);
  std::string told = fmt::format("{} {}", name, points.size());
  return PointsOfBall{std::move(points), std::move(told)};
}

std::string told_of(const RecordedScan& scan, const PointCloud& cloud, std::size_t used,
                    const std::vector<std::string>& counts, const std::vector<std::string>& missing) {
  const std::string thinning = scan.use_every > 1 ? fmt::format(" (use_every = {})", scan.use_every) : "";
  std::string text =
      fmt::format("{}: {} of {} points became readings{}: {}; the others were not used", scan.path, used,
                  cloud.points.cols(), thinning, truncated(max_listed, fmt::format("{}", fmt::join(counts, ", "))));
  if (!missing.empty()) {
    text += fmt::format(". Not found: {}", truncated(max_listed, fmt::format("{}", fmt::join(missing, ", "))));
  }
  return text;
}

Expected<void> read_scan(Recording& recording, const RecordedScan& scan, const std::vector<Artefact>& artefacts,
                         const ScanSelection& selection) {
  const auto source = open_scan(recording, scan, artefacts, selection);
  if (!source) {
    return tl::unexpected(source.error());
  }
  const auto found = segment(source->tips_in_base, source->wanted.contents, source->options);
  if (!found) {
    return tl::unexpected(Error{found.error().code, found.error().message, scan.path});
  }
  if (found->status != SegmentStatus::Complete && found->status != SegmentStatus::Partial) {
    return tl::unexpected(Error{ErrorCode::NoSolution,
                                scan_refusal(*found, source->wanted, *source->artefact, source->options.hints),
                                scan.path});
  }
  for (const auto& warning : source->cloud.warnings) {
    recording.warnings.push_back(fmt::format("{}: {}", scan.path, warning));
  }
  ReadingsOfScan readings(recording, scan, *source);
  std::size_t used = 0;
  std::vector<std::string> counts, missing;
  for (std::size_t i = 0; i < found->spheres.size(); ++i) {
    const std::string& name = source->artefact->features[static_cast<std::size_t>(source->wanted.spheres[i])].name;
    if (!found->spheres[i]) {
      missing.push_back(name);
      continue;
    }
    const auto ball = points_of(scan, *source, name, *found->spheres[i], selection.use);
    if (!ball) {
      return tl::unexpected(ball.error());
    }
    readings.add(name, ball->points);
    used += ball->points.size();
    counts.push_back(ball->told);
  }
  recording.warnings.push_back(told_of(scan, source->cloud, used, counts, missing));
  return {};
}

}  // namespace

Expected<void> read_scans(Recording& recording, const std::vector<Artefact>& artefacts,
                          const ScanSelection& selection) {
  std::set<std::filesystem::path> paths;
  for (const RecordedScan& scan : recording.scans) {
    std::error_code error;
    const auto whole = std::filesystem::weakly_canonical(scan.path, error);
    if (!paths.insert(error ? std::filesystem::path(scan.path) : whole).second) {
      return bad_input(fmt::format("the scan {} is named twice; its points would count twice", in_quotes(scan.path)),
                       scan.where);
    }
    if (auto read = read_scan(recording, scan, artefacts, selection); !read) {
      return read;
    }
  }
  return {};
}

}  // namespace artcal
