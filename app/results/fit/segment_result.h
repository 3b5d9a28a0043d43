#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "acquisition/point_cloud/point_cloud.h"
#include "artefacts/artefact/artefact.h"
#include "artefacts/scans/scan_contents.h"
#include "core/files/input_file.h"

namespace artcal {

/// Everything that `artcal segment` knows when it is done.
struct SegmentResult {
  std::vector<InputFile> inputs;  ///< the scan, the artefact
  std::string unit;               ///< of the scan
  double unit_in_mm = 1.0;
  double temperature = 20.0;  ///< of the artefact, °C
  std::size_t points = 0;
  std::string columns;    ///< ReadCloud::columns
  std::vector<int> rows;  ///< which record of the scan each point is
  Artefact artefact;
  ArtefactInScan wanted;
  SegmentOptions options;
  Segmentation segmentation;
  std::vector<std::string> warnings;
};

/// A certified distance between two spheres that were found, mm.
struct SeenDistance {
  int first = 0, second = 0;    ///< into SegmentResult::wanted.spheres
  StatedValue certified;        ///< what the certificate says
  double at_temperature = 0.0;  ///< what that makes at the artefact's temperature
  double measured = 0.0;
};
std::vector<SeenDistance> seen_distances(const SegmentResult& result);

/// The name of a sphere or plane wanted.
const std::string& sphere_name(const SegmentResult& result, std::size_t sphere);
const std::string& plane_name(const SegmentResult& result, std::size_t plane);

/// Names of what was not found.
std::vector<std::string> missing_names(const SegmentResult& result);

/// What a technician reads.
std::string to_text(const SegmentResult& result);
/// Why there is no answer, in one sentence; what there is to choose from.
std::string refusal_text(const SegmentResult& result);
/// The schema is docs/result-schema.md.
nlohmann::ordered_json to_json(const SegmentResult& result);

}  // namespace artcal
