#pragma once

#include <string_view>

namespace artcal {

/// The line, from 1, of the first key with more than 32 parts (a.a.a.…) in a TOML text, or 0. toml++ limits
/// the nesting of values, but not that of keys, and takes its tables apart recursively: such a key would
/// overflow the stack. What is no valid TOML may be judged either way.
int line_of_endless_key(std::string_view text);

}  // namespace artcal
