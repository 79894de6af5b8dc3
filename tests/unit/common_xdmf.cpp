/// XDMF files: well-formed, and in step with the HDF5 files that hold their numbers.
#include "common/xdmf.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"
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

// A surface of 3 x 4 nodes at two times: rows of arrays, of which the cells' hold two more.
TEST(Xdmf, DescribesASurfaceThroughTime) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "a & b.h5");
  write_array(file, "/points", {2, 12, 3});
  write_array(file, "/cells/e", {2, 8});
  file.finish();
  std::vector<Grid> series;
  for (const hsize_t row : {0, 1}) {
    Block e = row_of({"a & b.h5", "/cells/e", {2, 8}, {}, {}}, row);
    e.count[1] = 6;
    const Block points = row_of({"a & b.h5", "/points", {2, 12, 3}, {}, {}}, row);
    series.push_back({0.1 * static_cast<double>(row),
                      {3, 4},
                      points,
                      {{"velocity", Center::node, points}, {"e < 1", Center::cell, e}}});
  }
  write(folder / "f.xdmf", "a \"flag\"", series);
  const auto summary = check_xdmf(folder / "f.xdmf");
  EXPECT_THAT(summary.times, ElementsAre(0, 0.1));
  EXPECT_THAT(summary.attributes, ElementsAre("velocity: Vector at Node", "e < 1: Scalar at Cell"));
  EXPECT_THAT(summary.faults, IsEmpty());
  EXPECT_THAT(test::read_text(folder / "f.xdmf"), HasSubstr(">1 0 0 1 1 1 1 12 3<"));
}

TEST(Xdmf, DescribesAPlaneAndAVolumeByWholeArrays) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "f.h5");
  write_array(file, "/plane", {5, 4, 2});
  write_array(file, "/pressure", {4, 3});
  write_array(file, "/volume", {3, 5, 4, 3});
  write_array(file, "/vorticity", {60, 3});
  write_array(file, "/q", {2, 4, 3});
  file.finish();
  write(folder / "plane.xdmf", "fluid",
        {{0,
          {5, 4},
          {"f.h5", "/plane", {5, 4, 2}, {}, {}},
          {{"pressure", Center::cell, {"f.h5", "/pressure", {4, 3}, {}, {}}}}}});
  write(folder / "volume.xdmf", "fluid",
        {{0,
          {3, 5, 4},
          {"f.h5", "/volume", {3, 5, 4, 3}, {}, {}},
          {{"vorticity", Center::node, {"f.h5", "/vorticity", {60, 3}, {}, {}}},
           {"q", Center::cell, {"f.h5", "/q", {2, 4, 3}, {}, {}}}}}});
  EXPECT_THAT(check_xdmf(folder / "plane.xdmf").faults, IsEmpty());
  EXPECT_THAT(check_xdmf(folder / "volume.xdmf").faults, IsEmpty());
}

TEST(Xdmf, IsCheckedByAReaderThatFindsFaults) {
  const TemporaryFolder folder;
  hdf5::Writer file(folder / "f.h5");
  write_array(file, "/points", {2, 12, 3});
  file.finish();
  const Block points = row_of({"f.h5", "/points", {2, 12, 3}, {}, {}}, 1);
  Block outside = points;
  outside.start[0] = 2;
  write(folder / "f.xdmf", "flag", {{0, {3, 4}, outside, {}}});
  EXPECT_THAT(check_xdmf(folder / "f.xdmf").faults, ElementsAre(HasSubstr("leaves its array")));
  Block other = points;
  other.shape = {3, 12, 3};
  write(folder / "f.xdmf", "flag", {{0, {3, 4}, other, {}}});
  EXPECT_THAT(check_xdmf(folder / "f.xdmf").faults, ElementsAre(HasSubstr("other dimensions")));
}

}  // namespace
}  // namespace pennon::xdmf
