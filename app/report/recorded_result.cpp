#include "app/report/recorded_result.h"

#include <fmt/format.h>

namespace artcal {
namespace {

RecordedResult read_parts(const ReportedResult& result) {
  const RecordedObject json(result.json);
  RecordedResult read{recorded_head(json), {}, result.path};
  switch (result.kind) {
    case ResultKind::Identification: read.content = recorded_identification(json); break;
    case ResultKind::Verification: read.content = recorded_verification(json); break;
    case ResultKind::Uncertainty: read.content = recorded_uncertainty(json); break;
    case ResultKind::MonteCarlo: read.content = recorded_monte_carlo(json); break;
  }
  return read;
}

}  // namespace

Expected<RecordedResult> recorded_result(const ReportedResult& result) {
  try {
    return read_parts(result);
  } catch (const NotAsInSchema& reason) {
    return bad_input(fmt::format("this result is not as --json wrote it: {}", reason.what()), result.path);
  }
}

}  // namespace artcal
