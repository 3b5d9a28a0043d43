#pragma once

#include <string>

#include "app/history/arm_history.h"

namespace artcal {

/// The history of an arm as one page that needs nothing beside itself: what the last results say, how every parameter
/// and every value of a verification went over time with its uncertainty, what was done when with which certificate.
/// `store`: its name.
std::string history_html(const ArmHistory& history, const std::string& store);

}  // namespace artcal
