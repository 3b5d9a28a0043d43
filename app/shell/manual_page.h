#pragma once

#include <string>
#include <string_view>

#include "app/shell/command_description.h"

namespace artcal {

/// A manual page of section 1 (man(7) macros) from the description that `--help` shows. Sub-commands are sections of
/// their command's page.
std::string manual_page(const CommandDescription& command, std::string_view version);

/// The page's name without ".1", such as artcal-identify.
std::string manual_name(const CommandDescription& command);

}  // namespace artcal
