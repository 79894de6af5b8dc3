/// XDMF files: well-formed, and in step with the HDF5 files that hold their numbers.
#include "common/io/xdmf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/errors.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/xdmf_check.hpp"

namespace pennon::xdmf {
namespace {

using test::check_xdmf;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

void write_array(hdf5::Writer& file, const std::string& name, const hdf5::Shape& shape) {
  hsize_t size = 1;
  for (const hsize_t extent : shape) size *= extent;
  file.write(name, shape, std::vector<double>(size, 0.5));
}

TEST(Xdmf, DescribesASurfaceThroughTime) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "a & b.h5");
  std::vector<Grid> series;
  for (const int k : {0, 1}) {
    const Source points{"a & b.h5", fmt::format("/points/{}", k), {3, 4, 3}};
    const Source strain{"a & b.h5", fmt::format("/strain/{}", k), {2, 3}};
    const Source speed{"a & b.h5", fmt::format("/speed/{}", k), {3, 4}};
    write_array(file, points.array, points.shape);
    write_array(file, speed.array, speed.shape);
    write_array(file, strain.array, strain.shape);
    series.push_back({0.1 * k,
                      {3, 4},
                      points,
                      {{"speed", Center::node, speed}, {"e < 1", Center::cell, strain}}});
  }
  file.finish();
  write(folder / "f.xdmf", "a \"flag\"", series);
  const auto summary = check_xdmf(folder / "f.xdmf");
  EXPECT_THAT(summary.times, ElementsAre(0, 0.1));
  EXPECT_THAT(summary.attributes, ElementsAre("speed: Scalar at Node", "e < 1: Scalar at Cell"));
  EXPECT_THAT(summary.faults, IsEmpty());
}

TEST(Xdmf, DescribesALineAPlaneAndAVolume) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "f.h5");
  const auto source = [&](const std::string& array, const hdf5::Shape& shape) {
    write_array(file, array, shape);
    return Source{"f.h5", array, shape};
  };
  write(folder / "line.xdmf", "flag",
        {{0, {1, 5}, source("/line", {1, 5, 3}), {{"v", Center::node, source("/v", {1, 5})}}}});
  write(folder / "plane.xdmf", "fluid",
        {{0,
          {5, 4},
          source("/plane", {5, 4, 3}),
          {{"pressure", Center::cell, source("/pressure", {4, 3})}}}});
  write(folder / "volume.xdmf", "fluid",
        {{0,
          {3, 5, 4},
          source("/volume", {3, 5, 4, 3}),
          {{"vorticity", Center::node, source("/vorticity", {3, 5, 4, 3})},
           {"q", Center::cell, source("/q", {2, 4, 3})}}}});
  file.finish();
  for (const char* name : {"line.xdmf", "plane.xdmf", "volume.xdmf"})
    EXPECT_THAT(check_xdmf(folder / name).faults, IsEmpty()) << name;
}

TEST(Xdmf, IsCheckedByAReaderThatFindsFaults) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "f.h5");
  write_array(file, "/points", {3, 5, 3});
  file.finish();
  write(folder / "f.xdmf", "flag", {{0, {3, 4}, {"f.h5", "/points", {3, 4, 3}}, {}}});
  EXPECT_THAT(check_xdmf(folder / "f.xdmf").faults,
              ElementsAre(HasSubstr("other dimensions than f.h5:/points")));
  write(folder / "f.xdmf", "flag", {{0, {3, 4}, {"f.h5", "/absent", {3, 4, 3}}, {}}});
  EXPECT_THROW(check_xdmf(folder / "f.xdmf"), InputError);
}

}  // namespace
}  // namespace pennon::xdmf
