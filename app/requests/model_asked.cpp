#include "app/requests/model_asked.h"

namespace artcal {

Expected<ModelRequest> model_asked(const std::string& option, const Recording& recording) {
  if (!option.empty()) {
    return model_request(option);
  }
  return model_request(recording.identify.model).map_error([&](const Error& error) {
    return Error{ErrorCode::BadInput, error.message,
                 recording.inputs.empty() ? "" : recording.inputs.front().path + ", [identify]"};
  });
}

}  // namespace artcal
