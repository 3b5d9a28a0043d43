#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include <fmt/format.h>

namespace artcal::testing {

/// A PostgreSQL server of its own for a test, on a socket in a folder of its own, gone with it. PostgreSQL does not
/// run as root: then it runs as the user postgres, whom Debian's package makes.
class PostgresqlServer {
 public:
  PostgresqlServer() {
    namespace fs = std::filesystem;
    for (const char* version : {"15", "16", "17", "14", "13"}) {
      const std::string bin = fmt::format("/usr/lib/postgresql/{}/bin", version);
      if (fs::exists(bin + "/initdb")) {
        bin_ = bin;
        break;
      }
    }
    if (bin_.empty()) {
      return;
    }
    std::string name = (fs::temp_directory_path() / "artcal-pg-XXXXXX").string();
    folder_ = ::mkdtemp(name.data());
    as_ =
        ::geteuid() == 0 ? fmt::format("chown postgres {} && cd {} && runuser -u postgres -- ", folder_, folder_) : "";
    const std::string quiet = fmt::format(" >{}.log 2>&1", folder_);
    runs_ =
        call(fmt::format("{}{}/initdb -D {}/data -A trust -U artcal -N{}", as_, bin_, folder_, quiet)) &&
        call(fmt::format("{}{}/pg_ctl -D {}/data -w -t 60 -o \"-k {} -c listen_addresses='' -c fsync=off\" -l {}/log "
                         "start{}",
                         as_, bin_, folder_, folder_, folder_, quiet));
  }
  ~PostgresqlServer() {
    if (!folder_.empty()) {
      (void)call(fmt::format("{}{}/pg_ctl -D {}/data -w -m immediate stop >/dev/null 2>&1", as_, bin_, folder_));
      std::error_code ignored;
      std::filesystem::remove_all(folder_, ignored);
      std::filesystem::remove(folder_ + ".log", ignored);
    }
  }
  PostgresqlServer(const PostgresqlServer&) = delete;
  PostgresqlServer& operator=(const PostgresqlServer&) = delete;

  [[nodiscard]] bool is_installed() const { return !bin_.empty(); }
  [[nodiscard]] bool runs() const { return runs_; }
  [[nodiscard]] std::string url(const std::string& database = "postgres") const {
    return fmt::format("postgresql:///{}?host={}&user=artcal", database, folder_);
  }
  /// Where its socket is, for URLs of other forms; the role is "artcal", with any password.
  [[nodiscard]] const std::string& socket_folder() const { return folder_; }
  [[nodiscard]] bool make_database(const std::string& name) const {
    return call(fmt::format("{}/createdb -h {} -U artcal {}", bin_, folder_, name));
  }
  /// Rows that a query gives, by PostgreSQL's own program; -1 where it is refused.
  [[nodiscard]] int rows(const std::string& database, const std::string& sql_file) const {
    const std::string out = folder_ + ".log";
    if (!call(fmt::format("{}/psql -h {} -U artcal -d {} -At -v ON_ERROR_STOP=1 -f {} >{} 2>&1", bin_, folder_,
                          database, sql_file, out))) {
      return -1;
    }
    return std::system(fmt::format("exit $(head -n 200 {} | wc -l)", out).c_str()) / 256;
  }

 private:
  static bool call(const std::string& command) { return std::system(command.c_str()) == 0; }
  std::string bin_, folder_, as_;
  bool runs_ = false;
};

}  // namespace artcal::testing
