#include "artefacts/artefact/artefact.h"

#include <algorithm>

namespace artcal {

int Artefact::feature_index(const std::string& feature_name) const {
  if (feature_name.empty() && features.size() == 1) {
    return 0;
  }
  const auto found = std::find_if(features.begin(), features.end(),
                                  [&](const CertifiedFeature& feature) { return feature.name == feature_name; });
  return found == features.end() ? -1 : static_cast<int>(found - features.begin());
}

}  // namespace artcal
