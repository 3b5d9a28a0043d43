#include "artefacts/dcc/dcc_read.h"
#include "artefacts/dcc/dcc_select.h"

#include <cmath>

#include "artefacts/dcc/dcc_length.h"
#include "fuzz/check.h"

// A certificate that is read: each of its quantities is one of lengths or refused in a sentence.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const auto read = read_dcc_file(fuzzing::folder().write("certificate.xml", fuzzing::bytes_of(data, size)));
  if (!read) {
    fuzzing::require_sentence(read.error());
    return 0;
  }
  for (const DccQuantity& quantity : read->quantities) {
    fuzzing::require(!quantity.text().empty() && quantity.fault.has_value() == quantity.representations.empty());
    const auto lengths = lengths_of(quantity);
    if (!lengths) {
      fuzzing::require_sentence(lengths.error());
      continue;
    }
    const std::size_t count = lengths->values.size();
    fuzzing::require(count > 0 && (lengths->uncertainties.empty() || lengths->uncertainties.size() == count));
    for (const double value : lengths->values) {
      fuzzing::require(std::isfinite(value));
    }
  }
  if (const auto none = find_quantity(*read, "none"); !none) {
    fuzzing::require(none.error().text().size() < 4000);  // it lists a dozen of what there is
  }
  return 0;
}
