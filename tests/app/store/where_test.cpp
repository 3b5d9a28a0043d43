#include "app/store/where.h"

#include <gtest/gtest.h>

#include "app/store/stored_text.h"

namespace artcal {
namespace {

TEST(StorePlace, AUrlIsAServerAndAnythingElseAFile) {
  EXPECT_TRUE(parse_store("postgresql:///db")->is_postgresql);
  EXPECT_TRUE(parse_store("postgres://host/db")->is_postgresql);
  EXPECT_EQ(parse_store("/tmp/a b.sqlite")->file, "/tmp/a b.sqlite");
  EXPECT_EQ(parse_store("sqlite:/tmp/s")->file, "/tmp/s");
  for (const char* where : {"", "sqlite:", "mysql://host/db", "a\"b"}) {
    ASSERT_FALSE(parse_store(where)) << where;
    EXPECT_EQ(parse_store(where).error().code, ErrorCode::Usage) << where;
  }
}

TEST(StorePlace, TheFileOfAStoreIsKnownHoweverItIsNamed) {
  EXPECT_EQ(file_of_store("sqlite:/tmp/s"), "/tmp/s");
  EXPECT_EQ(file_of_store("/tmp/s"), "/tmp/s");
  EXPECT_EQ(file_of_store("postgresql:///db"), "");
  EXPECT_EQ(file_of_store(""), "");
}

TEST(StorePlace, APasswordIsNotRepeated) {
  EXPECT_EQ(parse_store("postgresql://me:secret@host/db")->name, "postgresql://me:***@host/db");
  EXPECT_EQ(parse_store("postgresql://host/db?user=me&password=secret&x=1")->name,
            "postgresql://host/db?user=me&password=***&x=1");
  EXPECT_EQ(parse_store("postgresql://host:5432/db")->name, "postgresql://host:5432/db");
}

TEST(StoredText, KeepsUtf8AndSpellsOutTheRest) {
  for (const char* text : {"", "bar", "Größe µ", "\xf0\x9f\x93\x8f", "\xed\x9f\xbf"}) {
    EXPECT_EQ(valid_utf8(text), text);
  }
  EXPECT_EQ(valid_utf8("a\xff z"), "a\\xff z");
  EXPECT_EQ(valid_utf8("\xc3"), "\\xc3") << "cut short";
  EXPECT_EQ(valid_utf8("\xc0\xaf"), "\\xc0\\xaf") << "too long a spelling of /";
  EXPECT_EQ(valid_utf8("\xed\xa0\x80"), "\\xed\\xa0\\x80") << "a surrogate";
  EXPECT_EQ(valid_utf8("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80") << "beyond Unicode";
}

}  // namespace
}  // namespace artcal
