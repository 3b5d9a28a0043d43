#include "app/store/postgresql_url.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace artcal {
namespace {

constexpr std::array<std::string_view, 2> schemes{"postgresql://", "postgres://"};
constexpr std::string_view connect_timeout_seconds = "30";  // libpq would wait for ever

std::string lower(std::string_view text) {
  std::string all(text);
  std::transform(all.begin(), all.end(), all.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return all;
}

tl::unexpected<Error> refused(std::string_view reason) {
  return wrong_usage(fmt::format(
      "the URL of the store is not of the form postgresql://user:***@host:port/database?name=value: {}", reason));
}

// %XX as the byte it stands for.
std::optional<std::string> decoded(std::string_view text) {
  std::string bytes;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '%') {
      bytes += text[i];
      continue;
    }
    unsigned value = 0;
    const std::string_view digits = text.substr(i + 1, 2);
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (digits.size() != 2 || error != std::errc{} || end != digits.data() + digits.size() || value == 0) {
      return std::nullopt;
    }
    bytes += static_cast<char>(value);
    i += 2;
  }
  return bytes;
}

std::string encoded(std::string_view text) {
  std::string url;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("-._~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

/// The parts of a URL as they are written, still percent-encoded.
struct Written {
  std::string_view user, password;
  bool has_password = false;
  std::vector<std::string_view> hosts, ports;  // as many of the one as of the other
  std::string_view database;
  std::vector<std::pair<std::string_view, std::string_view>> parameters;
};

// What comes before the first of the characters; the rest keeps that character.
std::string_view take_until(std::string_view& rest, std::string_view characters) {
  const std::size_t end = std::min(rest.find_first_of(characters), rest.size());
  const std::string_view taken = rest.substr(0, end);
  rest.remove_prefix(end);
  return taken;
}

bool takes(std::string_view& rest, char c) {
  const bool is_next = rest.starts_with(c);
  rest.remove_prefix(is_next ? 1 : 0);
  return is_next;
}

// One host and its port. A sentence where it is none, else nothing.
std::string_view take_host(std::string_view& rest, Written& url) {
  std::string_view host;
  if (takes(rest, '[')) {
    host = take_until(rest, "]/?,@");
    if (!takes(rest, ']')) {
      return "the [ of an IPv6 address is not closed by a ]";
    }
    if (host.empty() || (!rest.empty() && std::string_view(":/?,").find(rest.front()) == std::string_view::npos)) {
      return "an IPv6 address in [ ] is followed by a port, a /, or nothing";
    }
  } else {
    host = take_until(rest, ":/?,");
  }
  const std::string_view port = takes(rest, ':') ? take_until(rest, "/?,") : std::string_view{};
  if (port.find_first_not_of("0123456789") != std::string_view::npos || port.size() > 5) {
    return "the port behind the host is no number; a : or / in a password is written %3A or %2F";
  }
  url.hosts.push_back(host);
  url.ports.push_back(port);
  return {};
}

Expected<Written> taken_apart(std::string_view rest) {
  Written url;
  const std::size_t at = rest.find('@');
  if (at != std::string_view::npos && (at > rest.find('/') || rest.find('@', at + 1) != std::string_view::npos)) {
    return refused("an @ or / in the user's name or the password is written %40 or %2F");
  }
  if (at != std::string_view::npos) {
    std::string_view user = rest.substr(0, at);
    url.user = take_until(user, ":");
    url.has_password = takes(user, ':');
    url.password = user;
    rest.remove_prefix(at + 1);
  }
  do {
    if (const std::string_view wrong = take_host(rest, url); !wrong.empty()) {
      return refused(wrong);
    }
  } while (takes(rest, ','));
  url.database = takes(rest, '/') ? take_until(rest, "?") : std::string_view{};
  for (bool more = takes(rest, '?') && !rest.empty(); more; more = takes(rest, '&')) {
    std::string_view parameter = take_until(rest, "&");
    const std::string_view name = take_until(parameter, "=");
    if (name.empty() || !takes(parameter, '=')) {
      return refused("behind the ? stand parameters name=value, with & between them");
    }
    url.parameters.emplace_back(name, parameter);
  }
  if (!rest.empty()) {
    return refused("something stands between the host and the database");
  }
  return url;
}

bool is_secret(std::string_view name) {
  const std::string plain = lower(name);
  return plain.find("password") != std::string::npos || plain.find("secret") != std::string::npos ||
         plain.find("key") != std::string::npos || plain.find("token") != std::string::npos;
}

std::string joined(const std::vector<std::string_view>& parts) {
  std::string list;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    list += (i > 0 ? "," : "") + std::string(parts[i]);
  }
  return list;
}

// Names and values for libpq, decoded. Nothing where a % is wrong.
std::optional<std::vector<std::pair<std::string, std::string>>> for_libpq(const Written& url) {
  std::vector<std::pair<std::string, std::string>> all;
  const auto add = [&](std::string_view name, std::string_view value) {
    const auto plain_name = decoded(name), plain_value = decoded(value);
    if (plain_name && plain_value) {
      // What JDBC calls ssl=true, as libpq takes it.
      const bool is_ssl = *plain_name == "ssl" && *plain_value == "true";
      all.emplace_back(is_ssl ? "sslmode" : *plain_name, is_ssl ? "require" : *plain_value);
    }
    return plain_name && plain_value;
  };
  const auto is_filled = [](const std::vector<std::string_view>& parts) {
    return std::any_of(parts.begin(), parts.end(), [](std::string_view part) { return !part.empty(); });
  };
  bool sound = (url.user.empty() || add("user", url.user)) && (!url.has_password || add("password", url.password)) &&
               (!is_filled(url.hosts) || add("host", joined(url.hosts))) &&
               (!is_filled(url.ports) || add("port", joined(url.ports))) &&
               (url.database.empty() || add("dbname", url.database));
  for (const auto& [name, value] : url.parameters) {
    sound = sound && add(name, value);
  }
  return sound ? std::optional(std::move(all)) : std::nullopt;
}

std::string shown_hosts(const Written& url) {
  std::string text;
  for (std::size_t i = 0; i < url.hosts.size(); ++i) {
    const bool is_ipv6 = url.hosts[i].find(':') != std::string_view::npos;
    text += fmt::format("{}{}{}{}{}{}", i > 0 ? "," : "", is_ipv6 ? "[" : "", url.hosts[i], is_ipv6 ? "]" : "",
                        url.ports[i].empty() ? "" : ":", url.ports[i]);
  }
  return text;
}

std::string without_secrets(std::string_view scheme, const Written& url) {
  std::string text(scheme);
  if (!url.user.empty() || url.has_password) {
    text += fmt::format("{}{}@", url.user, url.has_password ? ":***" : "");
  }
  text += shown_hosts(url);
  text += url.database.empty() ? "" : fmt::format("/{}", url.database);
  for (std::size_t i = 0; i < url.parameters.size(); ++i) {
    const auto& [name, value] = url.parameters[i];
    text += fmt::format("{}{}={}", i == 0 ? "?" : "&", name, is_secret(decoded(name).value_or("")) ? "***" : value);
  }
  return text;
}

}  // namespace

bool is_postgresql_url(const std::string& where) {
  const std::string plain = lower(where);
  return std::any_of(schemes.begin(), schemes.end(),
                     [&](std::string_view scheme) { return plain.starts_with(scheme); });
}

Expected<PostgresqlPlace> parse_postgresql_url(const std::string& url) {
  const std::size_t scheme_size = url.find("//") + 2;
  const auto written = taken_apart(std::string_view(url).substr(scheme_size));
  if (!written) {
    return tl::unexpected(written.error());
  }
  auto parameters = for_libpq(*written);
  if (!parameters) {
    return refused("a % is followed by two hexadecimal digits; the character itself is written %25");
  }
  PostgresqlPlace place{"postgresql:///?", without_secrets(lower(url.substr(0, scheme_size)), *written)};
  if (std::none_of(parameters->begin(), parameters->end(),
                   [](const auto& parameter) { return parameter.first == "connect_timeout"; })) {
    parameters->emplace_back("connect_timeout", connect_timeout_seconds);
  }
  for (std::size_t i = 0; i < parameters->size(); ++i) {
    const auto& [name, value] = (*parameters)[i];
    place.connection += fmt::format("{}{}={}", i > 0 ? "&" : "", encoded(name), encoded(value));
  }
  return place;
}

}  // namespace artcal
