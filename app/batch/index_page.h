#pragma once

#include <string>
#include <vector>

#include "app/batch/batch.h"
#include "app/batch/report_pages.h"
#include "app/report/batch_index.h"
#include "app/store/store.h"

namespace artcal {

/// A row for each of these recording files, by what the store says of it now, with a link to its page where there is
/// one, and the reason where it could not be written; and a row for each failure of the batch that the store does not
/// have.
Expected<std::vector<IndexRow>> index_rows(Store& store, const std::vector<std::string>& files,
                                           const ReportPages* pages, const BatchSummary& summary);

}  // namespace artcal
