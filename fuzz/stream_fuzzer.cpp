#include "app/stream/stream_event.h"
#include "fuzz/check.h"

// The bytes are a stream.toml, a line with nothing but %, and a line of that stream.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace artcal;
  const std::string_view bytes = fuzzing::bytes_of(data, size);
  const std::size_t border = std::min(bytes.find("\n%\n"), size);
  const auto format = read_stream_format(fuzzing::folder().write("stream.toml", bytes.substr(0, border)));
  if (!format) {
    fuzzing::require_sentence(format.error());
    return 0;
  }
  fuzzing::require(!format->joints.empty() && format->joint_scale.size() == format->joints.size());
  const auto event = parse_event(border < size ? bytes.substr(border + 3) : std::string_view{}, *format);
  if (!event) {
    fuzzing::require_sentence(event.error());
  } else if (*event) {
    fuzzing::require((*event)->joints.size() == static_cast<Eigen::Index>(format->joints.size()));
  }
  return 0;
}
