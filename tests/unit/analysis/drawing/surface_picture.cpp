/// Coloured surfaces in space, drawn whole whatever they show.
#include "analysis/drawing/surface_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/errors.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::analysis {
namespace {

using test::failure_of;
using test::read_text;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

// A bent sheet of 3 x 4 nodes, whose values grow along the rows by `growth`.
SurfacePicture sheet(double growth) {
  Surface surface{3, 4, {}, {}, {}, {}};
  for (const double x : {0.0, 0.5, 1.0})
    for (const double y : {0.0, 0.3, 0.6, 0.9}) {
      surface.x.push_back(x);
      surface.y.push_back(y);
      surface.z.push_back(-y * y);
      surface.values.push_back(1 + growth * y);
    }
  return {"x", "y", "z", "strain", {surface}};
}

TEST(SurfacePicture, IsDrawnTheSameEachTime) {
  const TemporaryFolder folder;
  EXPECT_EQ(draw(sheet(1), folder / "a"), folder / "a.png");
  draw(sheet(1), folder / "b");
  EXPECT_THAT(folder.names(), ElementsAre("a.png", "b.png"));
  EXPECT_THAT(read_text(folder / "a.png"), StartsWith("\x89PNG\r\n"));
  EXPECT_EQ(read_text(folder / "a.png"), read_text(folder / "b.png"));
}

TEST(SurfacePicture, ShowsItsValuesAndItsShape) {
  const TemporaryFolder folder;
  draw(sheet(1), folder / "a");
  SurfacePicture other = sheet(1);
  std::swap(other.surfaces[0].values.front(), other.surfaces[0].values.back());
  draw(other, folder / "values");
  other = sheet(1);
  other.surfaces[0].z.back() = 0.5;
  draw(other, folder / "shape");
  EXPECT_NE(read_text(folder / "a.png"), read_text(folder / "values.png"));
  EXPECT_NE(read_text(folder / "a.png"), read_text(folder / "shape.png"));
}

TEST(SurfacePicture, IsDrawnWhereAllValuesAreOneAndAllPlacesInAPlane) {
  const TemporaryFolder folder;
  draw(sheet(0), folder / "flat");
  SurfacePicture at_rest = sheet(0);
  at_rest.surfaces[0].values.assign(12, 0);
  at_rest.surfaces[0].z.assign(12, 0);
  draw(at_rest, folder / "rest");
  EXPECT_THAT(folder.names(), ElementsAre("flat.png", "rest.png"));
}

TEST(SurfacePicture, IsRefusedWhereNodesLackAValue) {
  const TemporaryFolder folder;
  SurfacePicture picture = sheet(1);
  picture.surfaces[0].values.pop_back();
  EXPECT_THAT(failure_of<InputError>([&] { draw(picture, folder / "a"); }),
              HasSubstr("nodes has 11 numbers for them"));
}

TEST(SurfacePicture, FailsInWordsWhereTheFolderIsNotThere) {
  EXPECT_THAT(failure_of<FileError>([] { draw(sheet(1), "/absent/folder/a"); }),
              HasSubstr("No such file or directory"));
}

}  // namespace
}  // namespace pennon::analysis
