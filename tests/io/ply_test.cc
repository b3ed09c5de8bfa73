// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/ply.h"

#include <cmath>
#include <random>
#include <string>
#include <utility>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Ply : public testing::Test {
 protected:
  std::vector<MapPoint> read(const std::string& text) const {
    return read_ply(folder_.write("a.ply", text));
  }

  std::string error_of(const std::string& text) const {
    try {
      static_cast<void>(read(text));
    } catch (const InputError& error) {
      const std::string message = error.what();
      return message.substr(message.find("a.ply"));
    }
    return "no error";
  }

  TemporaryFolder folder_;
};

const std::string kAsciiXyz =
    "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
    "property float z\nend_header\n";

TEST_F(Ply, WhatIsWrittenReadsBackTheSame) {
  std::mt19937_64 rng(1);
  std::vector<MapPoint> points(1000);
  for (MapPoint& point : points) {
    for (float& value : point.position) value = static_cast<float>(rng() % 100000) * 1e-3F;
    for (float& value : point.normal) value = static_cast<float>(rng() % 1000) * 1e-3F;
    for (auto& level : point.color) level = static_cast<std::uint8_t>(rng() % 256);
  }
  const auto file = folder_.path() / "map.ply";
  write_ply(file, points);
  const auto again = read_ply(file);
  ASSERT_EQ(again.size(), points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_EQ(again[i].position, points[i].position);
    EXPECT_EQ(again[i].normal, points[i].normal);
    EXPECT_EQ(again[i].color, points[i].color);
  }
}

TEST_F(Ply, WritesTheBytesThatTheFormatAsksFor) {
  MapPoint point;
  point.position = {1, 2, -0.5F};
  point.normal = {0, 0, 1};
  point.color = {255, 128, 0};
  const auto file = folder_.path() / "one.ply";
  write_ply(file, std::vector{point});
  const std::string text = read_text(file);
  EXPECT_THAT(text, testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(text, HasSubstr("\nelement vertex 1\n"));
  // IEEE 754: 1 = 3f800000, 2 = 40000000, -0.5 = bf000000, the lowest byte first.
  const std::string body(
      "\x00\x00\x80\x3f\x00\x00\x00\x40\x00\x00\x00\xbf"
      "\x00\x00\x00\x00\x00\x00\x00\x00\x00\x00\x80\x3f"
      "\xff\x80\x00",
      27);
  EXPECT_THAT(text, testing::EndsWith("end_header\n" + body));
}

TEST_F(Ply, ReadsAsciiWithPropertiesInAnyOrder) {
  const auto points = read(
      "ply\r\nformat ascii 1.0\r\ncomment by hand\r\nelement vertex 1\r\n"
      "property uchar blue\r\nproperty double z\r\nproperty float confidence\r\n"
      "property uchar red\r\nproperty uchar green\r\nproperty float x\r\n"
      "property float y\r\nelement face 1\r\nproperty list uchar int vertex_indices\r\n"
      "end_header\r\n3 0.25 9 1 2 -1e1 4\r\n3 0 0 0\r\n");
  ASSERT_EQ(points.size(), 1U);
  EXPECT_EQ(points[0].position, Eigen::Vector3f(-10, 4, 0.25F));
  EXPECT_EQ(points[0].normal, Eigen::Vector3f::Zero());
  EXPECT_THAT(points[0].color, ElementsAre(1, 2, 3));
}

TEST_F(Ply, FloatColoursAreFromZeroToOneAndNoneAreGrey) {
  const auto points = read(
      "ply\nformat ascii 1.0\nelement camera 1\nproperty int id\nelement vertex 1\n"
      "property float x\nproperty float y\nproperty float z\n"
      "property float red\nproperty float green\nproperty float blue\nend_header\n"
      "7\n0 0 0 1 0.5 7\n");
  EXPECT_THAT(points.at(0).color, ElementsAre(255, 128, 255));
  EXPECT_THAT(read(kAsciiXyz + "0 0 0\nnan 0 0\n").at(0).color, ElementsAre(190, 190, 190));
}

TEST_F(Ply, ValuesThatAreNotFiniteStay) {
  EXPECT_TRUE(std::isnan(read(kAsciiXyz + "0 0 0\nnan 0 0\n").at(1).position.x()));
}

TEST_F(Ply, AnEmptyCloudIsNoError) {
  write_ply(folder_.path() / "empty.ply", {});
  EXPECT_TRUE(read_ply(folder_.path() / "empty.ply").empty());
}

TEST_F(Ply, BadInputIsNamedWithItsLineOrByte) {
  const std::string binary =
      "ply\nformat binary_little_endian 1.0\nelement vertex 2\nproperty float x\n"
      "property float y\nproperty float z\nend_header\n";
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"", "a.ply:1: does not begin with 'ply'; is it a PLY file?"},
      {"solid\n", "a.ply:1: does not begin with 'ply'; is it a PLY file?"},
      {"ply\nformat ascii 1.0\n",
       "a.ply:3: the header has no end_header; the file is cut off or no PLY file"},
      {"ply\nformat binary_big_endian 1.0\n",
       "a.ply:2: format 'binary_big_endian' is not read; write it as binary_little_endian or "
       "ascii"},
      {"ply\nwhat\n", "a.ply:2: unknown entry 'what' in the header of a PLY file"},
      {"ply\nelement vertex -1\n", "a.ply:2: '-1' is not a number of elements"},
      {"ply\nelement vertex\n", "a.ply:2: an element has a name and a count"},
      {"ply\nproperty float x\n", "a.ply:2: a property before any element"},
      {"ply\nelement vertex 1\nproperty real x\n", "a.ply:3: unknown type 'real'"},
      {"ply\nelement vertex 1\nproperty list uchar int x\n",
       "a.ply:3: lists are read only behind the vertices; write the vertices first"},
      {"ply\nformat ascii 1.0\nend_header\n", "a.ply:3: the header has no element 'vertex'"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n",
       "a.ply:5: the vertices have no x, y and z"},
      {kAsciiXyz + "0 0 0\n", "a.ply:8: ends after 1 of 2 vertices; the file is cut off"},
      {kAsciiXyz + "0 0 0\n0 0\n", "a.ply:9: a vertex of 2 values, the header promises 3"},
      {kAsciiXyz + "0 0 x\n0 0 0\n", "a.ply:8: 'x' is not a number"},
      // 115 bytes of header (lines of 4, 32, 17, three of 17, and 11), then 2 vertices of 12 bytes;
      // 13 are there.
      {binary + std::string(13, '\0'),
       "a.ply: ends at byte 128, but its header promises 2 vertices of 12 bytes from byte 115; "
       "the file is cut off"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of(text), message) << text;
}

TEST_F(Ply, ANumberOfVerticesThatOverflowsIsAnErrorNotAnAllocation) {
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\nelement vertex 9223372036854775807\n"
                       "property float x\nproperty float y\nproperty float z\nend_header\n"),
              HasSubstr("the file is cut off"));
}

TEST_F(Ply, MissingAndUnwritableFilesAreErrors) {
  EXPECT_THROW(static_cast<void>(read_ply(folder_.path() / "none.ply")), InputError);
  EXPECT_THROW(write_ply(folder_.path() / "no" / "folder.ply", {}), OutputError);
}

}  // namespace
}  // namespace cvo_slam
