/// What is reported of the local stability: for scripts, as tables and data of pictures, and for
/// the reader of the screen.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/io/output_folder.hpp"
#include "lsa/study.hpp"

namespace pennon::lsa {

/// The value of "lsa" in summary.json: k_x, k_y, c_m, P, omega [[re, im], [re, im]], growth,
/// frequency, mu_cr (null if none), unstable; and curve, map, most_unstable, verdicts where asked.
nlohmann::ordered_json to_json(const Result&);

/// Writes curve.csv, curve.h5, verdicts.csv and verdicts.h5, where there are such. Throws
/// FileError.
void write_tables(const Result&, const OutputFolder&);

std::string text_of(const Result&);

}  // namespace pennon::lsa
