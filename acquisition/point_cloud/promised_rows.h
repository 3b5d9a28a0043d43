#pragma once

#include "acquisition/point_cloud/cloud_builder.h"
#include "acquisition/point_cloud/text_rows.h"

namespace artcal {

/// Takes the `count` rows that a header promises, each of `width` numbers, into `builder`. Returns how many there were:
/// fewer where the text ends before. Refused: a row of another width, or without numbers in `columns`.
Expected<std::size_t> take_promised_rows(TextRows& rows, const CloudColumns& columns, std::size_t width,
                                         std::size_t count, CloudBuilder& builder);

}  // namespace artcal
