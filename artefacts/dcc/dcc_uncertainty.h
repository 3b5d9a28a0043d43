#pragma once

#include "artefacts/dcc/dcc.h"
#include "core/xml/xml.h"

namespace artcal {

/// Numbers of an element as they are written, separated by white space.
struct DccWrittenNumbers {
  std::vector<double> values;       ///< NaN where it says "NaN"
  std::vector<double> half_digits;  ///< half a unit of the last digit
};

/// Refused: what is no finite decimal number; elements among the numbers.
Expected<DccWrittenNumbers> read_written_numbers(const XmlSource& source, const pugi::xml_node& node);

/// What an element says of the uncertainty of its numbers.
struct DccStatedUncertainty {
  std::vector<DccUncertainty> each;  ///< one a number; none where none is stated, or none that is read
  std::string unread;                ///< the element of an uncertainty that is not read, with its line; else empty
};

/// Reads the uncertainty beside `count` numbers of `parent`, in both generations of D-SI: expandedUnc and
/// coverageInterval; measurementUncertaintyUnivariate and listMeasurementUncertaintyUnivariate with standardMU,
/// expandedMU or coverageIntervalMU; each also as a list, with "XMLList" behind its names. Any other element that
/// states an uncertainty is named in `unread`.
Expected<DccStatedUncertainty> read_stated_uncertainty(const XmlSource& source, const pugi::xml_node& parent,
                                                       std::size_t count);

}  // namespace artcal
