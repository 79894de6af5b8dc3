/// Pictures of a flag from the files of a run.
#include "analysis/figures/of_flag.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/temporary_folder.hpp"

namespace pennon::analysis {
namespace {

using test::TemporaryFolder;
using ::testing::ElementsAre;

// Shapes of 3 x 2 nodes at ten times, each with z = its time, and the strains 1 and 3 of its cells.
hdf5::Reader shapes_file(const TemporaryFolder& folder, const std::vector<double>& contour_times) {
  hdf5::Writer file(folder / "shapes.h5");
  std::vector<double> times;
  for (int s = 0; s < 10; ++s) {
    const double t = 0.1 * s;
    std::vector<double> positions;
    for (const double x : {0.0, 1.0, 2.0})
      for (const double y : {0.0, 1.0}) positions.insert(positions.end(), {x, y, t});
    file.write(fmt::format("/position/{:06}", s), {3, 2, 3}, positions);
    file.write(fmt::format("/e_1/{:06}", s), {2, 1}, std::vector<double>{1, 3});
    times.push_back(t);
  }
  file.write("/shape_times", {times.size()}, times);
  file.write("/contour_times", {contour_times.size()}, contour_times);
  file.finish();
  return hdf5::Reader(folder / "shapes.h5");
}

std::vector<double> times_drawn(const SurfacePicture& picture) {
  std::vector<double> times;
  for (const Surface& surface : picture.surfaces) times.push_back(surface.z.front());
  return times;
}

TEST(PictureOfStrain, ShowsTheShapesNearestToTheTimesAskedFor) {
  const TemporaryFolder folder;
  const SurfacePicture picture = picture_of_strain(shapes_file(folder, {0.62, 0.08, 7}));
  EXPECT_THAT(times_drawn(picture), ElementsAre(0.1 * 6, 0.1, 0.1 * 9));
}

TEST(PictureOfStrain, ShowsSixShapesUnasked) {
  const TemporaryFolder folder;
  const SurfacePicture picture = picture_of_strain(shapes_file(folder, {}));
  EXPECT_THAT(times_drawn(picture), ElementsAre(0, 0.1, 0.1 * 3, 0.1 * 5, 0.1 * 7, 0.1 * 9));
}

TEST(PictureOfStrain, HasTheMeanOfTheCellsAtEachNode) {
  const TemporaryFolder folder;
  const Surface surface = picture_of_strain(shapes_file(folder, {0})).surfaces.at(0);
  EXPECT_EQ(surface.rows, 3U);
  EXPECT_EQ(surface.columns, 2U);
  EXPECT_THAT(surface.values, ElementsAre(1, 1, 2, 2, 3, 3));
  EXPECT_THAT(surface.x, ElementsAre(0, 0, 1, 1, 2, 2));
  EXPECT_THAT(surface.y, ElementsAre(0, 1, 0, 1, 0, 1));
}

// The history's columns are t, the place of the trailing edge, and from the fifth on the energies;
// here each holds its own number, but nothing is dissipated.
TEST(FigureOfFlagHistory, DrawsEachEnergyUnderItsNameAndNoneThatIsZero) {
  const TemporaryFolder folder;
  constexpr std::size_t rows = 2, columns = 15, dissipated = 9;
  std::vector<double> history;
  for (std::size_t row = 0; row < rows; ++row)
    for (std::size_t k = 0; k < columns; ++k)
      history.push_back(k == dissipated ? 0.0 : static_cast<double>(k + 100 * row));
  {
    hdf5::Writer file(folder / "history.h5");
    file.write("/history", {rows, columns}, history);
    file.finish();
  }
  const Figure figure = figure_of_flag_history(hdf5::Reader(folder / "history.h5"));
  std::vector<std::string> labels;
  std::vector<double> first;
  for (const Line& line : figure.lines) {
    labels.push_back(line.label);
    first.push_back(line.y.front());
    EXPECT_THAT(line.x, ElementsAre(0, 100));
  }
  EXPECT_THAT(labels,
              ElementsAre("kinetic", "bending", "stretch of the chord", "stretch of the span",
                          "gravitational", "work of the loads", "total"));
  EXPECT_THAT(first, ElementsAre(4, 5, 6, 7, 8, 10, 11));
}

}  // namespace
}  // namespace pennon::analysis
