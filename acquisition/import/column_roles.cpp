#include "acquisition/import/column_roles.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/text/in_quotes.h"
#include "core/text/trimmed.h"

namespace artcal {
namespace {

constexpr std::array labels{"artefact", "placement", "feature", "orientation", "repeat", "probe"};
constexpr std::array lengths{"x", "y", "z", "length", "ref_x", "ref_y", "ref_z"};
constexpr std::array temperatures{"temperature", "arm_temperature"};

template <std::size_t N>
bool is_one_of(const std::array<const char*, N>& names, std::string_view name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string in_small_letters(std::string_view text) {
  std::string small(text);
  std::transform(small.begin(), small.end(), small.begin(),
                 [](char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); });
  return small;
}

bool is_role(const std::string& role) {
  return is_label(role) || is_length_role(role) || is_joint_role(role) || is_one_of(temperatures, role);
}

// "X [mm]", "x (mm)" and "x" are one name.
std::string without_unit(std::string_view name) {
  const std::size_t bracket = name.find_first_of("[(");
  return in_small_letters(trimmed(bracket == 0 ? name : name.substr(0, bracket)));
}

std::string role_of_name(std::string_view name) {
  std::string word = without_unit(name);
  if (word == "name" || word == "label" || word == "point") {
    return "feature";
  }
  for (const std::string_view prefix : {"joint_", "joint ", "joint", "angle_", "angle ", "angle", "j"}) {
    const std::string number = word.substr(std::min(prefix.size(), word.size()));
    if (word.starts_with(prefix) && is_joint_role("q" + number)) {
      return "q" + number;
    }
  }
  return is_role(word) ? word : "";
}

Expected<void> check_whole(const std::vector<ColumnRole>& roles, ErrorCode code, const std::string& where) {
  const auto has = [&](std::string_view role) {
    return std::any_of(roles.begin(), roles.end(), [&](const ColumnRole& each) { return each.role == role; });
  };
  for (std::size_t i = 0; i < roles.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      if (roles[i].role == roles[k].role) {
        return tl::unexpected(Error{code,
                                    fmt::format("columns {} and {} are both `{}`; say which with --columns",
                                                roles[k].column + 1, roles[i].column + 1, roles[i].role),
                                    where});
      }
    }
  }
  const int coordinates = has("x") + has("y") + has("z");
  if (coordinates == 3 || (coordinates == 0 && has("q1"))) {
    return {};
  }
  return tl::unexpected(
      Error{code,
            fmt::format(
                "of x, y, z {} are there, expected all three, or joint angles q1 … qn; say what the columns hold with "
                "--columns, such as --columns name,x,y,z",
                coordinates),
            where});
}

std::optional<std::size_t> column_named(std::string_view name, const std::vector<std::string>& first_row) {
  const bool is_number = !name.empty() && name.size() < 5 &&
                         std::all_of(name.begin(), name.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (is_number) {
    const std::size_t number = std::stoul(std::string(name));
    return number >= 1 && number <= first_row.size() ? std::optional(number - 1) : std::nullopt;
  }
  const auto found = std::find(first_row.begin(), first_row.end(), name);
  return found == first_row.end() ? std::nullopt : std::optional(static_cast<std::size_t>(found - first_row.begin()));
}

}  // namespace

bool is_label(const std::string& role) { return is_one_of(labels, role); }

bool is_length_role(const std::string& role) { return is_one_of(lengths, role); }

bool is_joint_role(const std::string& role) {
  return role.size() >= 2 && role.size() <= 3 && role[0] == 'q' && role[1] != '0' &&
         std::all_of(role.begin() + 1, role.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

Expected<std::vector<ColumnRole>> stated_roles(const std::string& columns, const std::vector<std::string>& first_row) {
  std::vector<ColumnRole> roles;
  std::size_t next = 0;
  for (std::size_t begin = 0; begin <= columns.size();) {
    const std::size_t end = std::min(columns.find(',', begin), columns.size());
    const std::string part(trimmed(std::string_view(columns).substr(begin, end - begin)));
    begin = end + 1;
    const std::size_t equal = part.find('=');
    const std::string word(trimmed(std::string_view(part).substr(0, equal)));
    const std::string role = word == "name" ? "feature" : word;
    if (role == "-" && equal == std::string::npos) {
      ++next;
      continue;
    }
    if (!is_role(role)) {
      return wrong_usage(
          fmt::format("--columns has {}, expected name, x, y, z, q1 … qn, {}, {}, length, ref_x, ref_y, "
                      "ref_z, or - for a column to be passed over",
                      in_quotes(word), fmt::join(labels, ", "), fmt::join(temperatures, ", ")));
    }
    const auto at = equal == std::string::npos
                        ? (next < first_row.size() ? std::optional(next) : std::nullopt)
                        : column_named(trimmed(std::string_view(part).substr(equal + 1)), first_row);
    if (!at) {
      return wrong_usage(fmt::format("--columns has {}, but the file has {} columns{}", in_quotes(part),
                                     first_row.size(),
                                     equal == std::string::npos ? "" : " and none of that name or number"));
    }
    next = *at + 1;
    roles.push_back({role, *at});
  }
  return check_whole(roles, ErrorCode::Usage, "").map([&] { return std::move(roles); });
}

Expected<std::vector<ColumnRole>> roles_of_header(const std::vector<std::string>& header, const std::string& where) {
  std::vector<ColumnRole> roles;
  for (std::size_t i = 0; i < header.size(); ++i) {
    if (std::string role = role_of_name(header[i]); !role.empty()) {
      roles.push_back({std::move(role), i});
    }
  }
  return check_whole(roles, ErrorCode::BadInput, where).map([&] { return std::move(roles); });
}

}  // namespace artcal
