// SPDX-FileCopyrightText: 2026 The leastcost authors
// SPDX-License-Identifier: MIT
#include <leastcost/problems/readers/point_cloud_reader.hpp>

#include <bit>
#include <cstring>
#include <fstream>

#include <leastcost/framework/base/errors.hpp>
#include "tests/support/catch.hpp"
#include "tests/support/data.hpp"

namespace leastcost::test {
namespace {

PointSamples read_text(const std::string& content, const char* name = "cloud.xyz") {
  const ScratchDir folder;
  std::ofstream(folder / name, std::ios::binary) << content;
  return read_point_cloud(folder / name);
}

/// The message without the folder; "accepted" when there is none.
std::string message_of(const std::string& content, const char* name = "cloud.xyz") {
  try {
    read_text(content, name);
  } catch (const InputError& error) {
    const std::string text = error.what();
    return text.substr(text.find(name));
  }
  return "accepted";
}

/// A binary PLY of doubles and floats, in either byte order, with an int that is to be skipped.
std::string binary_ply(bool big) {
  std::string out = std::string("ply\nformat binary_") + (big ? "big" : "little") +
                    "_endian 1.0\nelement vertex 2\nproperty double x\nproperty double y\nproperty double z\n"
                    "property int id\nproperty float nx\nproperty float ny\nproperty float nz\nend_header\n";
  const auto append = [&](auto value) {
    std::array<char, sizeof(value)> raw;
    std::memcpy(raw.data(), &value, sizeof(value));
    if (big == (std::endian::native == std::endian::little)) std::reverse(raw.begin(), raw.end());
    out.append(raw.data(), raw.size());
  };
  for (const double shift : {0.0, 0.25}) {
    for (const double x : {512787.09375, 5403659.0625, 328.5}) append(x + shift);
    append(7);
    for (const float n : {0.0f, 3.0f, 4.0f}) append(n);
  }
  return out;
}

}  // namespace

TEST_CASE("clouds: text with blanks, commas, comments and blank lines") {
  const PointSamples plain = read_text("# three points\n1 2 3\n\n  4\t5 6 # one\n7,8, 9\r\n");
  REQUIRE(plain.positions.size() == 3);
  CHECK(plain.positions[1] == Eigen::Vector3d(4, 5, 6));
  CHECK(plain.positions[2] == Eigen::Vector3d(7, 8, 9));
  CHECK(plain.normals.empty());
  CHECK(plain.notes.empty());
  const PointSamples with_normals = read_text("1;2;3;0;0;-2\n4;5;6;3;4;0\n", "cloud.csv");
  REQUIRE(with_normals.normals.size() == 2);
  CHECK(with_normals.normals[0] == Eigen::Vector3d(0, 0, -1));
  CHECK((with_normals.normals[1] - Eigen::Vector3d(0.6, 0.8, 0)).norm() <= 1e-16);
}

TEST_CASE("clouds: points that repeat an earlier one go, and are counted") {
  const PointSamples cloud = read_text("1 2 3 0 0 1\n4 5 6 0 1 0\n1 2 3 1 0 0\n7 8 9 1 0 0\n4 5 6 0 0 1\n");
  REQUIRE(cloud.positions.size() == 3);
  CHECK(cloud.in_file == std::vector<std::int32_t>{0, 1, 3});
  CHECK(cloud.normals[1] == Eigen::Vector3d(0, 1, 0));
  REQUIRE(cloud.notes.size() == 1);
  CHECK(cloud.notes[0].find("2 of 5 points") != std::string::npos);
}

TEST_CASE("clouds: normals of length zero are not used, and that is said") {
  const PointSamples cloud = read_text("1 2 3 0 0 0\n4 5 6 0 0 1\n");
  CHECK(cloud.normals.empty());
  REQUIRE(cloud.notes.size() == 1);
  CHECK(cloud.notes[0].find("1 of them are zero") != std::string::npos);
}

TEST_CASE("clouds: what does not fit is refused with its line") {
  CHECK(message_of("") == "cloud.xyz: no points");
  CHECK(message_of("# nothing\n\n") == "cloud.xyz: no points");
  CHECK(message_of("1 2 3\n4 5\n").find("cloud.xyz:2: 2 values") == 0);
  CHECK(message_of("1 2 3\n4 5 6 7\n").find("cloud.xyz:2: 4 values") == 0);
  CHECK(message_of("1 2 3\n4 5 6 0 0 1\n").find("cloud.xyz:2: 6 values, but the first row has 3") == 0);
  CHECK(message_of("1 2 3 4 5 6 7\n").find("cloud.xyz:1: more than 6") == 0);
  CHECK(message_of("1 2 3\n1 x 3\n").find("cloud.xyz:2: expected a coordinate, found 'x'") == 0);
  CHECK(message_of("1 2 3\n1 nan 3\n").find("cloud.xyz:2: ") == 0);
  CHECK(message_of("1 2 3\n1 1e999 3\n").find("cloud.xyz:2: ") == 0);
  CHECK(message_of("1,2,3\n1,,3\n").find("cloud.xyz:2: a value is missing") == 0);
  CHECK(message_of("1 2 3\n", "cloud.las").find("cloud.las: unknown point cloud format '.las'") == 0);
  CHECK_THROWS_AS(read_point_cloud("no such file.xyz"), InputError);
}

TEST_CASE("clouds: PLY, text and binary, with and without faces, in full precision") {
  const PointSamples text = read_text(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n1 2 3\n4 5 6\n7 8 9\n3 0 1 2\n",
      "cloud.ply");
  REQUIRE(text.positions.size() == 3);
  CHECK(text.positions[2] == Eigen::Vector3d(7, 8, 9));
  CHECK(text.normals.empty());
  const PointSamples binary = read_text(binary_ply(GENERATE(false, true)), "cloud.ply");
  REQUIRE(binary.positions.size() == 2);
  CHECK(binary.positions[0] == Eigen::Vector3d(512787.09375, 5403659.0625, 328.5));
  CHECK(binary.positions[1] == Eigen::Vector3d(512787.34375, 5403659.3125, 328.75));
  CHECK((binary.normals[0] - Eigen::Vector3d(0, 0.6, 0.8)).norm() <= 1e-16);
}

TEST_CASE("clouds: broken PLY is refused with its place") {
  const std::string header = "ply\nformat ascii 1.0\nelement vertex ";
  const std::string xyz = "property float x\nproperty float y\nproperty float z\n";
  CHECK(message_of(header + "1\nproperty float x\nproperty float y\nend_header\n1 2\n", "a.ply")
            .find("a.ply:3: element 'vertex' has no number z") == 0);
  CHECK(message_of(header + "1\n" + xyz + "property float nx\nend_header\n1 2 3 4\n", "a.ply")
            .find("a.ply:3: a normal needs nx, ny and nz") == 0);
  CHECK(message_of(header + "900\n" + xyz + "end_header\n1 2 3\n", "a.ply").find("declares 900") != std::string::npos);
  CHECK(message_of(header + "1\n" + xyz + "end_header\n1 2 inf\n", "a.ply").find("a.ply:8: ") == 0);
  CHECK(message_of(header + "0\n" + xyz + "end_header\n", "a.ply") == "a.ply: no points");
  std::string cut = binary_ply(false);
  cut.pop_back();
  CHECK(message_of(cut, "a.ply").find("a.ply:byte ") == 0);
}

}  // namespace leastcost::test
