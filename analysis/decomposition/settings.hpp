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

enum class Method { pod, dmd, spod, waves, normal_modes, global_modes };
/// As a case names them, in their order.
const std::vector<std::string>& method_names();
const std::string& name_of(Method);

enum class Of { flag, fluid };
enum class Mean { removed, kept };

struct Settings {
  bool is_given = false;
  Method method = Method::pod;
  Of of = Of::flag;
  std::optional<Mean> mean;             ///< none: removed for pod, spod and waves, else kept
  std::optional<std::int64_t> n_modes;  ///< none: ten, or as many as there are
  std::int64_t block = 128;
  double overlap = 0.5;
  Taper window = Taper::hamming;
  std::vector<double> frequencies;  ///< at which spod's modes are kept; empty: at its peaks
  std::optional<double> from, to;
  std::optional<std::int64_t> rank;
  DmdVariant variant = DmdVariant::exact;
  std::int64_t delays = 1;
  std::optional<std::int64_t> wave;  ///< along the span; none: all together
  double y = 1;                      ///< where waves are taken
  std::string global_modes;          ///< their file; empty: beside the run
  std::string memory;                ///< "2GB"; empty: half of what is free

  bool removes_mean() const {
    const bool is_removed_unasked =
        method == Method::pod || method == Method::spod || method == Method::waves;
    return mean ? *mean == Mean::removed : is_removed_unasked;
  }
  Window window_of_time() const { return {from, to}; }
  /// Of a flag, in the places where its nodes are.
  bool is_of_shapes() const { return method >= Method::waves; }
  /// Bytes.
  double memory_bytes() const;
};

void declare(Schema&, Settings&);

/// The faults between keys, and a memory that is none.
void check(const Settings&, Faults&);

}  // namespace pennon::decomposition
