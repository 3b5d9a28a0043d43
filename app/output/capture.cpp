#include "app/output/capture.h"

namespace artcal {
namespace {

thread_local Capture* captured = nullptr;

}  // namespace

Capture* current_capture() { return captured; }

CaptureScope::CaptureScope(Capture& capture) : before_(captured) { captured = &capture; }
CaptureScope::~CaptureScope() { captured = before_; }

}  // namespace artcal
