// SPDX-FileCopyrightText: 2026 The cvo_slam authors
// SPDX-License-Identifier: BSD-3-Clause
#include "cvo_slam/io/ply.h"

#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "cvo_slam/core/error.h"
#include "cvo_slam/tests/temporary_folder.h"

namespace cvo_slam {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class Ply : public testing::Test {
 protected:
  [[nodiscard]] PlyCloud read_cloud(const std::string& text) const {
    return read_ply(folder_.write("a.ply", text));
  }

  [[nodiscard]] std::vector<MapPoint> read(const std::string& text) const {
    return read_cloud(text).points;
  }

  [[nodiscard]] std::string error_of(const std::string& text) const {
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
  const auto again = read_ply(file).points;
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
      "7\n0 0 0 1 0.5 1.5\n");
  EXPECT_THAT(points.at(0).color, ElementsAre(255, 128, 255));
  EXPECT_THAT(read(kAsciiXyz + "0 0 0\nnan 0 0\n").at(0).color, ElementsAre(190, 190, 190));
}

/// Returns the text of a file with one colour property a channel, of a type, at a point each.
std::string ascii_with_colors(const std::string& type, const std::vector<std::string>& colors) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {0}\nproperty float x\nproperty float y\n"
      "property float z\nproperty {1} red\nproperty {1} green\nproperty {1} blue\nend_header\n",
      colors.size(), type);
  for (const std::string& color : colors) text += "0 0 0 " + color + "\n";
  return text;
}

// Colours of floats up to 255 and of 16 bits were drawn white.
TEST_F(Ply, TheRangeOfColoursIsThatOfTheirValuesWhateverTheirType) {
  for (const char* type : {"float", "double"}) {
    const auto cloud = read_cloud(ascii_with_colors(type, {"255 127.6 0", "1 0.2 0"}));
    EXPECT_THAT(cloud.points.at(0).color, ElementsAre(255, 128, 0)) << type;
    EXPECT_THAT(cloud.points.at(1).color, ElementsAre(1, 0, 0)) << type;
    EXPECT_THAT(cloud.notes, IsEmpty());
  }
  for (const char* type : {"ushort", "uint16", "int", "uint", "float", "double"}) {
    const auto cloud = read_cloud(ascii_with_colors(type, {"65535 32896 0", "257 0 0"}));
    EXPECT_THAT(cloud.points.at(0).color, ElementsAre(255, 128, 0)) << type;
    EXPECT_THAT(cloud.points.at(1).color, ElementsAre(1, 0, 0)) << type;
    EXPECT_THAT(cloud.notes, IsEmpty());
  }
  for (const char* type : {"char", "short", "int", "uint"}) {
    EXPECT_THAT(read(ascii_with_colors(type, {"255 128 1"})).at(0).color, ElementsAre(255, 128, 1));
  }
}

TEST_F(Ply, FractionsOfBrightnessAreNoWholeNumbersWhateverTheirTypeSays) {
  EXPECT_THAT(read(ascii_with_colors("uchar", {"1 0.5 0", "0 1 0"})).at(0).color,
              ElementsAre(255, 128, 0));
}

TEST_F(Ply, BytesOfTypeCharAreNotNegative) {
  const std::string header =
      "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\n"
      "property float y\nproperty float z\nproperty char red\nproperty char green\n"
      "property char blue\nend_header\n";
  const auto cloud = read_cloud(header + std::string(12, '\0') + "\xff\x80\x01");
  EXPECT_THAT(cloud.points.at(0).color, ElementsAre(255, 128, 1));
  EXPECT_THAT(cloud.notes, IsEmpty());
}

TEST_F(Ply, ColoursThatAreNotUnderstoodAreNoted) {
  const auto note_of = [&](const std::vector<std::string>& colors) {
    return read_cloud(ascii_with_colors("float", colors)).notes;
  };
  EXPECT_THAT(note_of({"1e6 0 0"}),
              ElementsAre("a.ply: colours up to 1e+06 are not understood: they should end at 1, "
                          "255 or 65535; the points are grey"));
  EXPECT_THAT(note_of({"-0.5 0 1"}), ElementsAre("a.ply: colours down to -0.5 are cut off at 0"));
  EXPECT_THAT(note_of({"256 0 0"}), ElementsAre("a.ply: colours up to 256 are cut off at 255"));
  EXPECT_THAT(note_of({"1023 0 0"}),
              ElementsAre(HasSubstr("colours up to 1023 are taken as 16-bit values and are dark")));
  EXPECT_THAT(note_of({"nan 0 0", "1 1 1"}),
              ElementsAre("a.ply: 1 point with colours that are not finite numbers; grey"));
  EXPECT_THAT(read(ascii_with_colors("float", {"inf 0 0", "1 1 1"})).at(0).color,
              ElementsAre(190, 190, 190));
}

TEST_F(Ply, PropertiesThatMayBeColoursAreNamedWhereThereAreNone) {
  const auto notes_with = [&](const std::vector<std::string>& names) {
    std::string text =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float X\nproperty float Y\n"
        "property float Z\n";
    std::string values = "0 0 0";
    for (const std::string& name : names) {
      text += "property float " + name + "\n";
      values += " 1";
    }
    return read_cloud(text + "end_header\n" + values + "\n").notes;
  };
  EXPECT_THAT(notes_with({}), IsEmpty());
  EXPECT_THAT(notes_with({"nx", "ny", "nz"}), IsEmpty());
  EXPECT_THAT(notes_with({"Red", "GREEN", "b", "alpha", "scalar_intensity"}), IsEmpty());
  EXPECT_THAT(notes_with({"intensity"}),
              ElementsAre("a.ply: no red, green and blue among the properties (intensity); the "
                          "points are grey"));
  // Gaussian splats.
  EXPECT_THAT(notes_with({"f_dc_0", "f_dc_1", "f_dc_2", "opacity", "scale_0", "scale_1"}),
              ElementsAre(HasSubstr("(f_dc_0, f_dc_1, f_dc_2, opacity and 2 more)")));
  EXPECT_THAT(notes_with({"red", "green"}),
              ElementsAre("a.ply: red, green and blue are not all there; the points are grey"));
}

TEST_F(Ply, ValuesThatAreNotFiniteStay) {
  const auto points = read(kAsciiXyz + "0 0 0\nnan 0 0\n");
  EXPECT_TRUE(std::isnan(points.at(1).position.x()));
  for (const char* word : {"-nan", "NaN", "nan(ind)", "1.#QNAN", "-1.#IND00"}) {
    const auto same = read(kAsciiXyz + "0 0 0\n" + word + " 0 0\n");
    EXPECT_TRUE(std::isnan(same.at(1).position.x())) << word;
  }
  for (const char* word : {"inf", "-inf", "+Inf", "Infinity", "1.#INF"}) {
    const auto same = read(kAsciiXyz + "0 0 0\n" + word + " 0 0\n");
    EXPECT_TRUE(std::isinf(same.at(1).position.x())) << word;
  }
}

TEST_F(Ply, ANormalThatIsNotFiniteIsNone) {
  const auto points = read(
      "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
      "property float z\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n"
      "0 0 0 inf 0 0\n0 0 0 0 0 1\n");
  EXPECT_EQ(points.at(0).normal, Eigen::Vector3f::Zero());
  EXPECT_EQ(points.at(1).normal, Eigen::Vector3f::UnitZ());
}

const std::string kAsciiDoubles =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\n"
    "property double z\nend_header\n";

// Floats half a metre apart, which they are at 5000 km, made one line of the two.
TEST_F(Ply, PointsInUtmCoordinatesStayApart) {
  const PlyCloud cloud = read_cloud(kAsciiDoubles +
                                    "400000.00 5000000 120\n400000.01 5000000 120\n"
                                    "400003 5000007.25 120\n");
  EXPECT_EQ(cloud.origin, Vector3(400000, 5000000, 0));
  const auto& points = cloud.points;
  EXPECT_NEAR(points.at(1).position.x() - points.at(0).position.x(), 0.01, 1e-6);
  EXPECT_EQ(points.at(2).position, Eigen::Vector3f(3, 7.25F, 120));
}

TEST_F(Ply, OnePointFarFromTheOthersDoesNotMoveTheOrigin) {
  const PlyCloud near = read_cloud(kAsciiDoubles + "0 1 2\n900 0 0\n400000 5000000 0\n");
  EXPECT_EQ(near.origin, Vector3::Zero());
  EXPECT_EQ(near.points.at(0).position, Eigen::Vector3f(0, 1, 2));
  const PlyCloud far = read_cloud(kAsciiDoubles + "0 0 0\n400001 -4999999 0\n400001 -4999999 0\n");
  EXPECT_EQ(far.origin, Vector3(400000, -5000000, 0));
  EXPECT_EQ(far.points.at(1).position, Eigen::Vector3f(1, 1, 0));
}

TEST_F(Ply, PointsWithAnOriginAreWrittenWhereTheyAre) {
  MapPoint point;
  point.position = {0.01F, 2, 3};
  const auto file = folder_.path() / "utm.ply";
  const Vector3 origin(400000, 5000000, 0);
  write_ply(file, std::vector{point}, origin);
  const PlyCloud again = read_ply(file);
  EXPECT_EQ(again.origin, origin);
  EXPECT_NEAR((again.points.at(0).position - point.position).norm(), 0, 1e-8);
}

TEST_F(Ply, AnEmptyCloudIsNoError) {
  write_ply(folder_.path() / "empty.ply", {});
  EXPECT_TRUE(read_ply(folder_.path() / "empty.ply").points.empty());
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
      {"ply\nwhat\n",
       "a.ply:2: unknown entry 'what' in the header of a PLY file; repair or remove the line"},
      {"ply\nelement vertex -1\n", "a.ply:2: '-1' is not a number of elements; repair the header"},
      {"ply\nelement vertex\n",
       "a.ply:2: an element has a name and a count, as in 'element vertex 100'; repair the header"},
      {"ply\nproperty float x\n", "a.ply:2: a property before any element; repair the header"},
      {"ply\nelement vertex 1\nproperty real x\n",
       "a.ply:3: unknown type 'real'; write float, double, uchar or another type of PLY"},
      {"ply\nelement vertex 1\nelement vertex 1\n",
       "a.ply:3: a second element 'vertex'; leave one in the file"},
      {"ply\nelement vertex 1\nproperty list uchar int x\n",
       "a.ply:3: lists are read only behind the vertices; write the vertices first, without lists"},
      {"ply\nformat ascii 1.0\nend_header\n",
       "a.ply:3: the header has no element 'vertex'; only vertices are read"},
      {"ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nend_header\n",
       "a.ply:5: the vertices have no x, y and z; write them"},
      {kAsciiXyz + "0 0 0\n",
       "a.ply:8: ends after 1 of 2 vertices; the file is cut off: copy or write it again"},
      {kAsciiXyz + "0 0 0\n0 0\n",
       "a.ply:9: a vertex of 2 values, the header promises 3; repair the line"},
      {kAsciiXyz + "0 0 x\n0 0 0\n",
       "a.ply:8: 'x' is not a number; repair the line, or write nan for a value that is missing"},
      // 115 bytes of header (lines of 4, 32, 17, three of 17, and 11), then 2 vertices of 12 bytes;
      // 13 are there.
      {binary + std::string(13, '\0'),
       "a.ply: ends at byte 128, but its header promises 2 vertices of 12 bytes behind 0 bytes of "
       "other elements, from byte 115; the file is cut off: copy or write it again"},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(error_of(text), message) << text;
}

TEST_F(Ply, ANumberOfVerticesThatOverflowsIsAnErrorNotAnAllocation) {
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\nelement vertex 9223372036854775807\n"
                       "property float x\nproperty float y\nproperty float z\nend_header\n"),
              HasSubstr("the file is cut off"));
}

// Sums of these numbers overflow: vertices were read from the wrong place.
TEST_F(Ply, NumbersOfElementsThatOverflowAreErrors) {
  const std::string most = "18446744073709551615";
  const std::string vertices =
      "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n";
  const std::string before =
      "element a " + most + "\nproperty int i\nelement b 1\n" + "property int i\n";
  EXPECT_THAT(error_of("ply\nformat ascii 1.0\n" + before + vertices + "1\n2\n0 0 0\n"),
              HasSubstr("ends after 0 of 1 vertices; the file is cut off"));
  EXPECT_THAT(error_of("ply\nformat binary_little_endian 1.0\n" + before + vertices +
                       std::string(64, '\0')),
              HasSubstr("the file is cut off"));
  EXPECT_THAT(error_of("ply\nformat ascii 1.0\nelement vertex " + most +
                       "\nproperty float x\nproperty float y\nproperty float z\nend_header\n"
                       "0 0 0\n"),
              HasSubstr("ends after 1 of 18446744073709551615 vertices"));
}

TEST_F(Ply, AByteOrderMarkIsSkipped) {
  EXPECT_EQ(read("\xEF\xBB\xBF" + kAsciiXyz + "0 0 0\n1 0 0\n").size(), 2U);
}

TEST_F(Ply, MissingAndUnwritableFilesAreErrors) {
  EXPECT_THROW(static_cast<void>(read_ply(folder_.path() / "none.ply")), InputError);
  EXPECT_THROW(write_ply(folder_.path() / "no" / "folder.ply", {}), OutputError);
}

}  // namespace
}  // namespace cvo_slam
