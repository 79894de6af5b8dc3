/// Spectral proper orthogonal decomposition (Towne, Schmidt & Colonius 2018, section 2.3 and
/// appendix A; Schmidt & Colonius 2020): at each frequency the orthonormal modes that hold the most
/// of the cross-spectral density, estimated by Welch's method,
///
///     q^_b(f) = (dt/N)^1/2 sum_m w_m q_{m + first_b} exp(-2 pi i f m dt),
///     S(f) = (1/B) sum_b q^_b q^_b^*,     S W phi_j = lambda_j phi_j,  <phi_i, phi_j> = delta_ij,
///
/// over B blocks of N snapshots. For real data the density is one-sided: doubled but at f = 0 and,
/// where N is even, at half the sampling rate. The sum of all lambda_j over all f, times 1/(N dt),
/// is the variance, but for windows and blocks.
///
/// With Q the matrix of the B vectors W^1/2 q^_b, lambda_j and the eigenvectors v_j are those of
/// Q^* Q/B, and phi_j = W^-1/2 Q v_j (B lambda_j)^-1/2. Products are summed band by band, so
/// lambda_j is right to roundoff times lambda_1.
///
/// A mode that is well apart from the others has an energy that is distributed about its true one
/// as chi^2 of 2 K degrees of freedom (K at f = 0 and half the sampling rate), K the independent
/// blocks (Brillinger 1981, theorem 9.4.3 for large K; Schmidt & Colonius 2020, section 4): that is
/// the interval given here. Where modes crowd, or blocks are few, the first energy is too large and
/// the last too small, which the interval does not say.
#pragma once

#include <array>

#include "analysis/decomposition/bands.hpp"
#include "analysis/decomposition/welch.hpp"

namespace pennon::decomposition {

struct Spod {
  Blocks blocks;
  /// Increasing: from 0 for real data, else from minus half the sampling rate.
  std::vector<double> f;
  std::vector<Eigen::VectorXd> energy;  ///< for each f: lambda_j in falling order, B or fewer
  std::vector<Eigen::MatrixXcd> v;      ///< for each f: the eigenvectors, B x modes
  double independent_blocks = 0;        ///< K
  bool is_real = true;
};

/// Of the 2.5 to 97.5 percent points of what the true energy is over the estimated one: at
/// frequency `index`. Wide, (0, infinity) for less than one independent block.
std::array<double, 2> energy_interval(const Spod&, Eigen::Index index);

/// Every rank calls and has the same. Throws as Bands::for_each().
template <class Scalar>
Spod spod(const Bands<Scalar>&, const Blocks&);

/// The indices of the frequencies at which the first energy has a maximum, the largest first, at
/// most `count`. f = 0 counts where the next one is lower.
std::vector<Eigen::Index> peaks(const Spod&, std::size_t count);

/// For each band of this rank: phi_j at a frequency for the first `modes`, values x modes, for each
/// of the frequencies chosen.
template <class Scalar>
using UseSpodModes =
    std::function<void(const BandOfData<Scalar>&, std::size_t chosen, const Eigen::MatrixXcd& phi)>;
template <class Scalar>
void for_each_band_of_spod_modes(const Bands<Scalar>&, const Spod&,
                                 const std::vector<Eigen::Index>& frequencies, Eigen::Index modes,
                                 const UseSpodModes<Scalar>&);

extern template Spod spod(const Bands<double>&, const Blocks&);
extern template Spod spod(const Bands<std::complex<double>>&, const Blocks&);
extern template void for_each_band_of_spod_modes(const Bands<double>&, const Spod&,
                                                 const std::vector<Eigen::Index>&, Eigen::Index,
                                                 const UseSpodModes<double>&);
extern template void for_each_band_of_spod_modes(const Bands<std::complex<double>>&, const Spod&,
                                                 const std::vector<Eigen::Index>&, Eigen::Index,
                                                 const UseSpodModes<std::complex<double>>&);

}  // namespace pennon::decomposition
