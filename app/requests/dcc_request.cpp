#include "app/requests/dcc_request.h"

#include <fmt/format.h>

#include "artefacts/dcc/writing/dcc_data_file.h"

namespace artcal {

void DccRequest::add_to(CLI::App& parser) {
  parser.add_option("--dcc", out, "write the result as a digital certificate (DCC 3.3.0, unsigned)")->type_name("FILE");
  parser.add_option("--dcc-data", data, "dcc-data.toml: laboratory, customer and item for --dcc")->type_name("FILE");
}

Expected<std::optional<DccData>> read_certificate_data(const DccRequest& request, Recording& recording) {
  if (request.out.empty() != request.data.empty()) {
    return wrong_usage(
        "a digital certificate needs --dcc FILE, where to write it, and --dcc-data FILE, what the laboratory has to "
        "say in it (docs/files.md)");
  }
  if (request.data.empty()) {
    return std::nullopt;
  }
  auto file = read_dcc_data(request.data);
  if (!file) {
    return tl::unexpected(file.error());
  }
  if (!recording.date.empty() && (recording.date < file->data.begin || recording.date > file->data.end)) {
    return bad_input(fmt::format("the certificate is for measurements from {} to {}, but the recording is of {}",
                                 file->data.begin, file->data.end, recording.date),
                     request.data);
  }
  recording.inputs.push_back(file->input);
  return std::optional(std::move(file->data));
}

}  // namespace artcal
