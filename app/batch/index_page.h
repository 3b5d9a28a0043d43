#pragma once

#include <string>
#include <vector>

#include "app/report/batch_index.h"
#include "app/store/store.h"

namespace artcal {

/// A row for each of these recording files (ascending), by what the store says of it now.
Expected<std::vector<IndexRow>> index_rows(Store& store, const std::vector<std::string>& files);

}  // namespace artcal
