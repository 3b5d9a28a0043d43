#include "app/store/where.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "core/in_quotes.h"

namespace artcal {
namespace {

// postgresql://user:password@host/db?password=… without what is secret in it.
std::string without_password(const std::string& url) {
  std::string shown = url;
  const std::size_t user = shown.find("//") + 2;
  const std::size_t at = shown.find('@', user);
  const std::size_t colon = shown.find(':', user);
  if (at != std::string::npos && colon < at) {
    shown.replace(colon, at - colon, ":***");
  }
  if (const std::size_t key = shown.find("password="); key != std::string::npos) {
    const std::size_t end = std::min(shown.find('&', key), shown.size());
    shown.replace(key, end - key, "password=***");
  }
  return shown;
}

}  // namespace

Expected<StorePlace> understand_store(const std::string& where) {
  if (where.starts_with("postgresql://") || where.starts_with("postgres://")) {
    return StorePlace{true, "", without_password(where)};
  }
  const std::string path = where.starts_with("sqlite:") ? where.substr(7) : where;
  if (path.empty() || path.find("://") != std::string::npos || path.find('"') != std::string::npos) {
    return wrong_usage(fmt::format(
        "{} is no store: expected the path of a file (SQLite) or postgresql://user@host/database", in_quotes(where)));
  }
  std::error_code ignored;
  return StorePlace{false, std::filesystem::absolute(path, ignored).string(), path};
}

std::string file_of_store(const std::string& where) {
  const auto place = understand_store(where);
  return place ? place->file : "";
}

}  // namespace artcal
