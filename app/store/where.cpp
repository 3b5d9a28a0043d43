#include "app/store/where.h"

#include <algorithm>
#include <filesystem>
#include <string_view>

#include <fmt/format.h>

#include "app/store/postgresql_url.h"
#include "core/text/in_quotes.h"

namespace artcal {
namespace {

// What a message may show of a name that is no store: of a URL its scheme alone.
std::string harmless(const std::string& where) {
  const std::size_t slashes = where.find("://");
  if (slashes != std::string::npos) {
    return in_quotes(where.substr(0, slashes + 3)) + " with more behind it";
  }
  return where.find("password") != std::string::npos ? "what was given" : in_quotes(where);
}

std::string shown_url(const std::string& url) {
  const auto place = parse_postgresql_url(url);
  return place ? place->shown : "postgresql://***";
}

// Where a URL of PostgreSQL begins, from `from` on.
std::size_t find_scheme(const std::string& text, std::size_t from) {
  for (std::size_t at = text.find("://", from); at != std::string::npos; at = text.find("://", at + 1)) {
    for (const std::string_view scheme : {"postgresql", "postgres"}) {
      if (at >= from + scheme.size() && is_postgresql_url(text.substr(at - scheme.size(), scheme.size() + 3))) {
        return at - scheme.size();
      }
    }
  }
  return std::string::npos;
}

}  // namespace

Expected<StorePlace> parse_store(const std::string& where) {
  if (is_postgresql_url(where)) {
    return parse_postgresql_url(where).map([](const PostgresqlPlace& place) {
      return StorePlace{true, "", place.shown, place.connection};
    });
  }
  const std::string path = where.starts_with("sqlite:") ? where.substr(7) : where;
  if (path.empty() || path.find("://") != std::string::npos || path.find('"') != std::string::npos ||
      path.find("password=") != std::string::npos) {
    return wrong_usage(fmt::format(
        "{} is no store: expected the path of a file (SQLite) or postgresql://user@host/database", harmless(where)));
  }
  std::error_code ignored;
  return StorePlace{false, std::filesystem::absolute(path, ignored).string(), path, ""};
}

std::string file_of_store(const std::string& where) {
  const auto place = parse_store(where);
  return place ? place->file : "";
}

std::string without_passwords(const std::string& text) {
  std::string shown;
  std::size_t done = 0;
  for (std::size_t at = find_scheme(text, 0); at != std::string::npos; at = find_scheme(text, done)) {
    std::size_t end = std::min(text.find_first_of(" \t\r\n\"", at), text.size());
    end = std::min(end, text.find_last_not_of(".,:;", end - 1) + 1);  // of the sentence
    shown += text.substr(done, at - done) + shown_url(text.substr(at, end - at));
    done = end;
  }
  return shown + text.substr(done);
}

void hide_passwords(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string argument = argv[i];
    const std::size_t at = find_scheme(argument, 0);
    if (at == std::string::npos) {
      continue;
    }
    std::string shown = argument.substr(0, at) + shown_url(argument.substr(at));
    shown.resize(argument.size(), ' ');
    std::copy(shown.begin(), shown.end(), argv[i]);
  }
}

}  // namespace artcal
