/// Snapshots in files, waves along the span, and the times of both.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <hdf5.h>

#include <cmath>
#include <numbers>

#include "analysis/decomposition/foreign_file.hpp"
#include "analysis/decomposition/spanwise_wave.hpp"
#include "analysis/decomposition/waves.hpp"
#include "common/errors.hpp"
#include "common/io/hdf5.hpp"
#include "tests/support/failure.hpp"
#include "tests/support/held_snapshots.hpp"
#include "tests/support/temporary_folder.hpp"
#include "tests/support/text_file.hpp"

namespace pennon::decomposition {
namespace {

using namespace pennon::test;
using Complex = std::complex<double>;
using Eigen::Index;
using Eigen::MatrixXd;
using std::numbers::pi;
using testing::HasSubstr;

// What h5py writes of NumPy arrays.
class NumpyFile {
 public:
  explicit NumpyFile(const std::filesystem::path& path)
      : file_(H5Fcreate(path.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT)) {}
  ~NumpyFile() { H5Fclose(file_); }
  NumpyFile(const NumpyFile&) = delete;
  NumpyFile& operator=(const NumpyFile&) = delete;

  void write(const char* name, const std::vector<hsize_t>& shape, hid_t type, const void* values) {
    const hid_t space = H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr);
    const hid_t set = H5Dcreate2(file_, name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    H5Dwrite(set, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, values);
    H5Dclose(set);
    H5Sclose(space);
  }
  void write(const char* name, const std::vector<hsize_t>& shape,
             const std::vector<double>& values) {
    write(name, shape, H5T_NATIVE_DOUBLE, values.data());
  }
  void attribute(const char* name, const char* key, double value) {
    const hid_t space = H5Screate(H5S_SCALAR);
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT);
    const hid_t at = H5Acreate2(set, key, H5T_NATIVE_DOUBLE, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(at, H5T_NATIVE_DOUBLE, &value);
    H5Aclose(at);
    H5Dclose(set);
    H5Sclose(space);
  }
  void texts(const char* name, const char* key, const std::vector<const char*>& values) {
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, H5T_VARIABLE);
    const hsize_t count = values.size();
    const hid_t space = H5Screate_simple(1, &count, nullptr);
    const hid_t set = H5Dopen2(file_, name, H5P_DEFAULT);
    const hid_t at = H5Acreate2(set, key, type, space, H5P_DEFAULT, H5P_DEFAULT);
    H5Awrite(at, type, values.data());
    H5Aclose(at);
    H5Dclose(set);
    H5Sclose(space);
    H5Tclose(type);
  }

 private:
  hid_t file_;
};

MatrixXd all_of(const Snapshots& snapshots) {
  MatrixXd values;
  snapshots.read({0, snapshots.layout().values()}, values);
  return values;
}

class Sources : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "data.h5"; }
  std::string fault(Foreign which = Foreign::flag) const {
    return failure_of<InputError>([&] { open_foreign_file(file(), which, {}); });
  }
  // q(m, c, p) = 100 m + 10 c + p, so that each value says what it is.
  void write_counted(std::size_t times, std::size_t components, std::size_t points) {
    NumpyFile numpy(file());
    std::vector<double> q;
    for (std::size_t m = 0; m < times; ++m)
      for (std::size_t c = 0; c < components; ++c)
        for (std::size_t p = 0; p < points; ++p)
          q.push_back(static_cast<double>(100 * m + 10 * c + p));
    numpy.write("t", {times}, steps(static_cast<Index>(times), 0.5));
    numpy.write("q", {times, components, points}, q);
    if (components == 2) numpy.texts("q", "names", {"u", "v"});
  }

  TemporaryFolder folder_;
};

TEST_F(Sources, ReadBandsOfSeveralComponents) {
  write_counted(4, 2, 3);
  const auto snapshots = open_foreign_file(file(), Foreign::field, {.from = 0.4, .to = 1.2});
  EXPECT_THAT(snapshots->layout().components, testing::ElementsAre("u", "v"));
  EXPECT_THAT(snapshots->layout().t, testing::ElementsAre(0.5, 1));
  MatrixXd band;
  snapshots->read({2, 3}, band);  // the last point of u, the first two of v
  EXPECT_EQ(band, (MatrixXd{{102, 202}, {110, 210}, {111, 211}}));
  EXPECT_EQ(snapshots->weights({2, 3}), MatrixXd::Ones(3, 1));
}

TEST_F(Sources, ReadSinglePrecisionAndComplexNumbers) {
  const std::vector<float> single = {1, 2, 3, 4};
  const std::vector<Complex> complex = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  {
    NumpyFile numpy(file());
    numpy.write("t", {2}, {0, 1});
    numpy.write("q", {2, 2}, H5T_NATIVE_FLOAT, single.data());
  }
  EXPECT_EQ(all_of(*open_foreign_file(file(), Foreign::field, {})), (MatrixXd{{1, 3}, {2, 4}}));
  {
    NumpyFile numpy(file());
    numpy.write("t", {2}, {0, 1});
    const hid_t type = H5Tcreate(H5T_COMPOUND, sizeof(Complex));
    H5Tinsert(type, "r", 0, H5T_NATIVE_DOUBLE);
    H5Tinsert(type, "i", sizeof(double), H5T_NATIVE_DOUBLE);
    numpy.write("q", {2, 2}, type, complex.data());
    H5Tclose(type);
  }
  const auto snapshots = open_foreign_file(file(), Foreign::field, {});
  ASSERT_TRUE(snapshots->layout().is_complex);
  Eigen::MatrixXcd values;
  snapshots->read_complex({0, 2}, values);
  EXPECT_EQ(values, (Eigen::MatrixXcd{{{1, 2}, {5, 6}}, {{3, 4}, {7, 8}}}));
}

TEST_F(Sources, TakeTheWeightsOfTheFile) {
  write_counted(3, 2, 2);
  {
    hdf5::Writer file(folder_ / "weighted.h5");
    file.write("/t", {3}, std::vector<double>{0, 1, 2});
    file.write("/q", {3, 2}, std::vector<double>(6, 1));
    file.write("/weight", {3, 2}, std::vector<double>{1, 2, 3, 4, 5, 6});
    file.finish();
  }
  const auto snapshots =
      open_foreign_file(folder_ / "weighted.h5", Foreign::field, {.from = 1, .to = {}});
  EXPECT_TRUE(snapshots->layout().has_changing_weights);
  EXPECT_EQ(snapshots->weights({0, 2}), (MatrixXd{{3, 5}, {4, 6}}));
}

TEST_F(Sources, WeighAFlagByItsPieces) {
  {
    NumpyFile numpy(file());
    numpy.write("t", {2}, {0, 1});
    numpy.write("z", {2, 2, 3}, std::vector<double>(12, 1.0));
    numpy.write("y", {3}, {0, 0.2, 1});
    numpy.write("x", {2}, {0, 1});
    numpy.attribute("x", "span", 2);
  }
  const auto snapshots = open_foreign_file(file(), Foreign::flag, {});
  EXPECT_LT(
      (snapshots->weights({0, 6}).col(0) - Eigen::VectorXd{{0.1, 0.5, 0.4, 0.1, 0.5, 0.4}}).norm(),
      1e-15);
  EXPECT_THAT(snapshots->layout().y, testing::ElementsAre(0, 0.2, 1, 0, 0.2, 1));
}

TEST_F(Sources, RefuseWhatIsNotOfTheLayout) {
  const std::vector<double> four(4, 1.0);
  const auto with = [&](const std::function<void(NumpyFile&)>& write) {
    NumpyFile numpy(file());
    write(numpy);
  };
  with([](NumpyFile& f) { f.write("t", {2}, {0, 1}); });
  EXPECT_THAT(fault(), HasSubstr("has neither z, the shape of a flag, nor q"));
  with([&](NumpyFile& f) { f.write("q", {2, 2}, four); });
  EXPECT_THAT(fault(), HasSubstr("has no array /t"));
  with([&](NumpyFile& f) {
    f.write("t", {3}, {0, 1, 2});
    f.write("q", {2, 2}, four);
  });
  EXPECT_THAT(fault(), HasSubstr("has 3 times in /t and 2 snapshots in /q"));
  with([&](NumpyFile& f) {
    f.write("t", {2}, {1, 0.5});
    f.write("q", {2, 2}, four);
  });
  EXPECT_THAT(fault(), HasSubstr("has t = 0.5 for snapshot 1, not above 1 before it"));
  with([&](NumpyFile& f) {
    f.write("t", {1}, {1});
    f.write("q", {1, 4}, four);
  });
  EXPECT_THAT(fault(), HasSubstr("has 1 snapshot; a decomposition needs two"));
  with([&](NumpyFile& f) {
    f.write("t", {2}, {0, 1});
    f.write("q", {2, 2}, four);
    f.write("weight", {3}, {1, 1, 1});
  });
  EXPECT_THAT(fault(), HasSubstr("has an array /weight of 3, where 2 is needed"));
  with([&](NumpyFile& f) {
    f.write("t", {2}, {0, 1});
    f.write("q", {2, 2}, four);
    f.write("weight", {2}, {1, -1});
  });
  EXPECT_THAT(fault(), HasSubstr("has -1 at index 1 of /weight"));
  with([&](NumpyFile& f) {
    f.write("t", {2}, {0, 1});
    f.write("z", {2, 2, 1}, four);
    f.write("y", {1}, {1});
    f.write("x", {2}, {0, 1.5});
    f.attribute("x", "span", 2);
  });
  EXPECT_THAT(fault(), HasSubstr("has x[1] = 1.5 for 2 stations along a span of 2"));
}

TEST_F(Sources, ReadSignals) {
  const auto path = write_text(folder_ / "signals.csv", "t,lift,drag\n0,1,4\n1,2,5\n2,3,6\n");
  const auto snapshots = open_signals(path, {});
  EXPECT_THAT(snapshots->layout().components, testing::ElementsAre("lift", "drag"));
  EXPECT_EQ(all_of(*snapshots), (MatrixXd{{1, 2, 3}, {4, 5, 6}}));
  EXPECT_THAT(failure_of<InputError>([&] {
                open_signals(write_text(folder_ / "late.csv", "lift,t\n1,0\n2,1\n"), {});
              }),
              HasSubstr("has the first column lift; it must be t"));
}

TEST(TimesOfSnapshots, AreRefusedWithAGap) {
  std::vector<double> t = steps(20, 0.1);
  for (std::size_t m = 12; m < t.size(); ++m) t[m] += 0.5;
  EXPECT_THAT(failure_of<InputError>([&] { time_grid(t, "data"); }),
              HasSubstr("has a gap from t = 1.1 to 1.7, 6 times the median step of 0.1"));
}

TEST(TimesOfSnapshots, AreResampledToFourthOrder) {
  double previous = 0;
  for (const Index count : {201, 401}) {
    std::vector<double> t = steps(count, 10.0 / static_cast<double>(count - 1));
    // Both ends and their neighbours stay, where a natural spline is of second order only.
    for (std::size_t m = 0; m < t.size(); ++m) t[m] += 0.03 * std::pow(std::sin(pi * t[m] / 10), 4);
    MatrixXd q(1, count);
    for (Index m = 0; m < count; ++m) q(0, m) = std::sin(3 * t[static_cast<std::size_t>(m)]);
    const HeldSnapshots<double> snapshots(t, q);
    const Bands<double> bands(snapshots, {.removes_mean = false});
    EXPECT_TRUE(bands.times().is_resampled);
    double error = 0;
    bands.for_each(0, 0, [&](const BandOfData<double>& data) {
      for (Index m = count / 4; m < 3 * count / 4; ++m)
        error = std::max(
            error,
            std::abs(data.A(0, m) - std::sin(3 * bands.times().t[static_cast<std::size_t>(m)])));
    });
    if (previous > 0) {
      EXPECT_NEAR(std::log2(previous / error), 4, 0.4);
    }
    previous = error;
  }
}

// A standing wave of one period and a travelling one of two, at the trailing edge.
class WavesOfAFlag : public testing::Test {
 protected:
  WavesOfAFlag() {
    hdf5::Writer file(folder_ / "z.h5");
    const std::vector<double> t = steps(400, 0.05);
    std::vector<double> z;
    for (const double time : t)
      for (int i = 0; i < stations; ++i)
        for (const double y : {0.0, 0.5, 1.0}) {
          const double x = span * i / stations;
          z.push_back(y *
                      (0.1 * std::cos(2 * pi * x / span) * std::cos(6 * time) +
                       0.04 * std::cos(4 * pi * x / span + 9 * time) + 0.02 * std::cos(3 * time)));
        }
    file.write("/t", {t.size()}, t);
    file.write("/z", {t.size(), stations, 3}, z);
    file.write("/y", {3}, std::vector<double>{0, 0.5, 1});
    std::vector<double> x;
    x.reserve(stations);
    for (int i = 0; i < stations; ++i) x.push_back(span * i / stations);
    file.write("/x", {stations}, x, {{"span", span}});
    file.finish();
  }
  std::unique_ptr<Snapshots> open() const {
    return open_foreign_file(folder_ / "z.h5", Foreign::flag, {});
  }

  static constexpr int stations = 8;
  static constexpr double span = 2;
  TemporaryFolder folder_;
};

TEST_F(WavesOfAFlag, AreToldStandingAndTravelling) {
  const auto snapshots = open();
  const auto found = waves(Bands<double>(*snapshots, {.is_weighted = false}), 1);
  ASSERT_EQ(found.size(), 5U);
  constexpr double leakage = 1e-3;  // of the window over some ten periods
  EXPECT_NEAR(found[0].amplitude(), 0.02, leakage * 0.1);
  EXPECT_NEAR(found[1].standing(), 0.1, leakage * 0.1);
  EXPECT_NEAR(found[1].travelling(), 0, leakage * 0.1);
  EXPECT_NEAR(found[2].travelling(), -0.04, leakage * 0.1) << "along -x";
  EXPECT_LT(found[2].standing(), leakage * 0.1);
  EXPECT_LT(found[3].amplitude(), 1e-15);
  EXPECT_NEAR(waves(Bands<double>(*snapshots, {.is_weighted = false}), 0.4)[1].standing(), 0.05,
              leakage * 0.1);
}

TEST_F(WavesOfAFlag, AddUpToTheVarianceOfAll) {
  const auto variance = [](const Snapshots& snapshots) {
    double sum = 0;
    if (snapshots.layout().is_complex)
      Bands<Complex>(snapshots, {}).for_each(0, 0, [&](const auto& data) {
        sum += data.A.squaredNorm();
      });
    else
      Bands<double>(snapshots, {}).for_each(0, 0, [&](const auto& data) {
        sum += data.A.squaredNorm();
      });
    return sum;
  };
  double sum = 0;
  for (std::int64_t n = 0; n <= stations / 2; ++n) sum += variance(*spanwise_wave(open(), n));
  EXPECT_NEAR(sum / variance(*open()), 1, 1e-12);
}

TEST_F(WavesOfAFlag, AreRefusedWhereTheStationsDoNotResolveThem) {
  EXPECT_THAT(failure_of<InputError>([&] { spanwise_wave(open(), 5); }),
              HasSubstr("decompose.wave = 5 cannot be told from a longer wave by 8 stations"));
}

}  // namespace
}  // namespace pennon::decomposition
