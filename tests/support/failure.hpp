/// What a failing call says.
#pragma once

#include <string>

namespace pennon::test {

/// The words of the error that `work` throws; empty if it throws none.
template <class Error, class Work>
std::string failure_of(Work work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace pennon::test
