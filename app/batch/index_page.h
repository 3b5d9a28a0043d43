#pragma once

#include <map>
#include <string>
#include <vector>

#include "app/batch/report_pages.h"
#include "app/report/batch_index.h"
#include "app/store/store.h"

namespace artcal {

/// A row for each of these recording files (ascending), by what the store says of it now, with a link to its page
/// where there is one, and the reason where it could not be written (by path).
Expected<std::vector<IndexRow>> index_rows(Store& store, const std::vector<std::string>& files,
                                           const ReportPages* pages,
                                           const std::map<std::string, std::string>& page_errors);

}  // namespace artcal
