/// How files name the values of a parameter that a curve or map varies.
#pragma once

#include "common/case/sweep.hpp"
#include "common/io/hdf5.hpp"
#include "lsa/axes.hpp"

namespace pennon::lsa {

/// The attributes name, meaning, symbol and scale, which is "log" or "linear".
inline hdf5::Attributes attributes(Axis axis, Scale scale) {
  return {{"name", name(axis)},
          {"meaning", meaning(axis)},
          {"symbol", symbol(axis)},
          {"scale", scale == Scale::log ? "log" : "linear"}};
}

}  // namespace pennon::lsa
