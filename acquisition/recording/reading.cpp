#include "acquisition/recording/reading.h"

namespace artcal {

int Labels::index_of(std::string_view name) {
  if (last_ < size() && names_[last_] == name) {
    return last_;
  }
  const auto [entry, is_new] = index_.try_emplace(std::string(name), size());
  if (is_new) {
    names_.emplace_back(name);
  }
  last_ = entry->second;
  return last_;
}

int Labels::find(std::string_view name) const {
  const auto entry = index_.find(std::string(name));
  return entry == index_.end() ? -1 : entry->second;
}

}  // namespace artcal
