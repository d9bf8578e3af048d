#include "passes/cryptomatte.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

namespace wold::passes {
namespace {

using testing::ElementsAre;
using testing::FloatEq;

// Appleby's reference implementation.
TEST(Murmur, HashesAsItsAuthorsProgram) {
  EXPECT_EQ(murmur_hash(""), 0U);
  EXPECT_EQ(murmur_hash("test"), 0xba6bd213U);
  EXPECT_EQ(murmur_hash("Hello, world!"), 0xc0363e43U);
  EXPECT_EQ(murmur_hash("The quick brown fox jumps over the lazy dog"), 0x2e4ff723U);
}

// The example of the specification's text.
TEST(Cryptomatte, NamesHaveThePublishedNumbers) {
  EXPECT_EQ(murmur_hash("hello"), 0x248bfa47U);
  EXPECT_FLOAT_EQ(id_of("hello"), 6.0705627e-17F);
}

TEST(Cryptomatte, EveryNumberIsACommonOne) {
  for (int k = 0; k < 3000; ++k) {
    const std::string name = "name " + std::to_string(k);
    ASSERT_TRUE(std::isnormal(id_of(name))) << name;
    const std::uint32_t turned = std::bit_cast<std::uint32_t>(id_of(name)) ^ murmur_hash(name);
    ASSERT_TRUE(turned == 0 || turned == 1U << 23) << name;
  }
}

TEST(Cryptomatte, RanksNamesByWhatTheyCover) {
  Cryptomatte matte("kind", {"a", "b", "c"}, 2);
  matte.set(0, std::array{0.2, 0.7, 0.1});
  matte.set(1, std::array{0.0, 0.0, 0.5});
  LayeredImage image{2, 1, {}, {}};
  matte.add_to(image);
  ASSERT_EQ(image.channels.size(), 8U);
  const auto values = [&](const char* name) { return image.find(name)->values; };
  EXPECT_THAT(values("kind00.R"), ElementsAre(id_of("b"), id_of("c")));
  EXPECT_THAT(values("kind00.G"), ElementsAre(FloatEq(0.7F), FloatEq(0.5F)));
  EXPECT_THAT(values("kind00.B"), ElementsAre(id_of("a"), 0.0F));
  EXPECT_THAT(values("kind00.A"), ElementsAre(FloatEq(0.2F), 0.0F));
  EXPECT_THAT(values("kind01.R"), ElementsAre(id_of("c"), 0.0F));
  EXPECT_THAT(values("kind01.A"), ElementsAre(0.0F, 0.0F));
}

TEST(Cryptomatte, TheHeaderSaysWhoIsWho) {
  LayeredImage image{1, 1, {}, {}};
  Cryptomatte("kind", {"hello", "a \"b\""}, 1).add_to(image);
  const std::string key = "cryptomatte/" + [] {
    char text[9];
    std::snprintf(text, sizeof(text), "%08x", murmur_hash("kind"));
    return std::string(text, 7);
  }() + "/";
  EXPECT_EQ(image.attributes.at(key + "name"), "kind");
  EXPECT_EQ(image.attributes.at(key + "hash"), "MurmurHash3_32");
  EXPECT_EQ(image.attributes.at(key + "conversion"), "uint32_to_float32");
  EXPECT_THAT(image.attributes.at(key + "manifest"),
              testing::HasSubstr(R"("hello":"248bfa47","a \"b\"":")"));
}

}  // namespace
}  // namespace wold::passes
