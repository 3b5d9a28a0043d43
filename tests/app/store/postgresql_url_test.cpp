// URLs of PostgreSQL in every form of libpq's documentation (PostgreSQL 15, section 34.1.1.2), and passwords in forms
// that are none.
#include "app/store/postgresql_url.h"

#include <gmock/gmock.h>

#include "app/store/where.h"

namespace artcal {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

std::string connection(const std::string& url) {
  const auto place = parse_postgresql_url(url);
  std::string text = place ? place->connection : place.error().text();
  const std::string waiting = "connect_timeout=30";
  if (text.ends_with(waiting)) {
    text.resize(text.size() - waiting.size());
    text = text.substr(0, text.find_last_not_of('&') + 1);
  }
  return text;
}
std::string shown(const std::string& url) { return parse_postgresql_url(url).value().shown; }

TEST(PostgresqlUrl, TakesEveryFormOfTheDocumentation) {
  const std::string any = "postgresql:///?";
  for (const auto& [url, parameters] : {
           std::pair{"postgresql://", ""},
           {"postgresql://localhost", "host=localhost"},
           {"postgresql://localhost:5433", "host=localhost&port=5433"},
           {"postgresql://localhost/mydb", "host=localhost&dbname=mydb"},
           {"postgresql://user@localhost", "user=user&host=localhost"},
           {"postgresql://user:secret@localhost", "user=user&password=secret&host=localhost"},
           {"postgresql://other@localhost/otherdb?connect_timeout=10&application_name=myapp",
            "user=other&host=localhost&dbname=otherdb&connect_timeout=10&application_name=myapp"},
           {"postgresql://host1:123,host2:456/somedb?target_session_attrs=any&application_name=myapp",
            "host=host1%2Chost2&port=123%2C456&dbname=somedb&target_session_attrs=any&application_name=myapp"},
           {"postgresql:///mydb?host=localhost&port=5433", "dbname=mydb&host=localhost&port=5433"},
           {"postgresql://[2001:db8::1234]/database", "host=2001%3Adb8%3A%3A1234&dbname=database"},
           {"postgresql://[::1]:5433,h/d", "host=%3A%3A1%2Ch&port=5433%2C&dbname=d"},
           {"postgresql:///dbname?host=/var/lib/postgresql", "dbname=dbname&host=%2Fvar%2Flib%2Fpostgresql"},
           {"postgresql://%2Fvar%2Flib%2Fpostgresql/dbname", "host=%2Fvar%2Flib%2Fpostgresql&dbname=dbname"},
           {"postgresql://user@localhost:5433/mydb?options=-c%20synchronous_commit%3Doff",
            "user=user&host=localhost&port=5433&dbname=mydb&options=-c%20synchronous_commit%3Doff"},
           {"postgres://h/d", "host=h&dbname=d"},
           {"PostgreSQL://h/d", "host=h&dbname=d"},
           {"postgresql://u:p%40s%2Fs%3A%25@h/d", "user=u&password=p%40s%2Fs%3A%25&host=h&dbname=d"},
           {"postgresql://u:@h/d", "user=u&password=&host=h&dbname=d"},
           {"postgresql://u:a?b:c@h/d", "user=u&password=a%3Fb%3Ac&host=h&dbname=d"},
           {"postgresql://h/d?ssl=true", "host=h&dbname=d&sslmode=require"},
           {"postgresql://h/d?", "host=h&dbname=d"},
       }) {
    EXPECT_EQ(connection(url), any + parameters) << url;
  }
}

TEST(PostgresqlUrl, ShowsEverythingButTheSecret) {
  EXPECT_EQ(shown("postgresql://me:secret@h1:1,[::1]:2/db?user=x&pass%77ord=secret&sslpassword=secret&x=1"),
            "postgresql://me:***@h1:1,[::1]:2/db?user=x&pass%77ord=***&sslpassword=***&x=1");
  EXPECT_EQ(shown("postgres://host/db"), "postgres://host/db");
}

TEST(PostgresqlUrl, ShowsNothingOfAUrlWhosePasswordIsNotCertain) {
  for (const char* url :
       {"postgresql://u:p@secret@127.0.0.1:1/a?x", "postgresql://u:100%secret@127.0.0.1:1/a?connect_timeout=1",
        "postgresql://u:sec/secret@127.0.0.1:1/a", "postgresql://u:1/secret@127.0.0.1:1/a",
        "postgresql://u:1/secret?x=secret@h/a", "postgresql://u:secret@[::1/a?connect_timeout=1",
        "postgresql://u:secret@[::1]secret/a", "postgresql://u:secret@h:secret/a",
        "postgresql://u@h/a?password=secret&secret", "postgresql://u@h/a?secret", "postgresql://u:secret%00@h/a",
        "postgresql://u:secret@h/a%zz", "postgresql://u@h/a?user=u@secret"}) {
    for (const std::string& text : {parse_store(url).error().text(), without_passwords(std::string("x ") + url)}) {
      EXPECT_THAT(text, Not(HasSubstr("secret"))) << url;
    }
    EXPECT_EQ(parse_store(url).error().code, ErrorCode::Usage) << url;
  }
  EXPECT_THAT(parse_store("postgresql://u:p@ss@h/a").error().text(), HasSubstr("an @ or / in the user's name or the "
                                                                               "password is written %40 or %2F"));
  EXPECT_THAT(parse_store("postgresql://u:1%@h/a").error().text(), HasSubstr("is written %25"));
}

TEST(PostgresqlUrl, OtherNamesWithAPasswordAreNotShownEither) {
  for (const char* where : {"mysql://u:secret@h/a", "host=h password=secret"}) {
    ASSERT_FALSE(parse_store(where)) << where;
    EXPECT_THAT(parse_store(where).error().text(), Not(HasSubstr("secret"))) << where;
  }
}

TEST(PostgresqlUrl, PasswordsAreHiddenInArgumentsAndMessages) {
  EXPECT_EQ(without_passwords("a postgresql://u:secret@h/d: \"postgres://v:secret@h\" b"),
            "a postgresql://u:***@h/d: \"postgres://v:***@h\" b");
  std::string program = "artcal", whole = "--store=postgresql://u:secret@h/d", odd = "postgresql://u:se cret@[h/d",
              other = "archive";
  char* arguments[] = {program.data(), whole.data(), odd.data(), other.data()};
  hide_passwords(4, arguments);
  EXPECT_EQ(whole, "--store=postgresql://u:***@h/d   ");
  EXPECT_EQ(odd.substr(0, 16), "postgresql://***");
  EXPECT_EQ(odd.find("cret"), std::string::npos);
  EXPECT_EQ(other, "archive");
}

}  // namespace
}  // namespace artcal
