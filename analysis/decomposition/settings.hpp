/// What a case asks of a modal decomposition: the table [decompose].
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/decomposition/dmd.hpp"
#include "analysis/decomposition/times.hpp"
#include "analysis/decomposition/welch.hpp"
#include "common/case/case_reader.hpp"
#include "common/case/schema.hpp"

namespace pennon::decomposition {

enum class Method { pod, dmd, spod, waves };
enum class Of { flag, fluid };
enum class Mean { removed, kept };

struct Settings {
  bool is_given = false;
  Method method = Method::pod;
  Of of = Of::flag;
  std::optional<Mean> mean;             ///< none: kept for dmd, else removed
  std::optional<std::int64_t> n_modes;  ///< none: ten, or as many as there are
  std::int64_t block = 128;
  double overlap = 0.5;
  Taper window = Taper::hamming;
  std::vector<double> frequencies;  ///< at which spod's modes are kept; empty: at its peaks
  std::optional<double> from, to;
  std::optional<std::int64_t> rank;
  DmdVariant variant = DmdVariant::exact;
  std::optional<std::int64_t> wave;  ///< along the span; none: all together
  double y = 1;                      ///< where waves are taken
  std::string memory;                ///< "2GB"; empty: half of what is free

  bool removes_mean() const { return mean ? *mean == Mean::removed : method != Method::dmd; }
  Window window_of_time() const { return {from, to}; }
  /// Bytes.
  double memory_bytes() const;
};

void declare(Schema&, Settings&);

/// The faults between keys, and a memory that is none.
void check(const Settings&, Faults&);

}  // namespace pennon::decomposition
