#include "core/printable.h"

#include <gtest/gtest.h>

namespace wold::test {
namespace {

TEST(Printable, TextStays) {
  for (const char* text : {"", "plain", "two\nlines\tand a tab", "Grüße, 雪, \xF0\x9F\x8C\xBE"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, WhatTerminalsObeyDoesNot) {
  EXPECT_EQ(printable("\x1b[31mred\r\b\x7f"), "?[31mred???");
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "?31m");  // CSI of ISO 6429 in one byte
  EXPECT_EQ(printable("\xC2\x9B"
                      "31m"),
            "?31m");  // the same in UTF-8
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a?b");
  EXPECT_EQ(printable("\xE2\x80\xAE"
                      "desrever"),
            "?desrever");  // right-to-left override
}

/// The ill-formed sequences of Unicode's table 3-7.
TEST(Printable, BytesThatAreNoUtf8DoNot) {
  EXPECT_EQ(printable("\xC0\xAF"), "??");
  EXPECT_EQ(printable("\xE0\x9F\xBF"), "???");
  EXPECT_EQ(printable("\xED\xA0\x80"), "???");
  EXPECT_EQ(printable("\xF4\x90\x80\x80"), "????");
  EXPECT_EQ(printable("gr\xFC\xDF"), "gr??");
  EXPECT_EQ(printable("cut \xE9\x9B"), "cut ??");
}

}  // namespace
}  // namespace wold::test
