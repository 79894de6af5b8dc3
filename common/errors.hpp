/// The faults pennon reports, one type for each exit code.
///
///   InputError   2  the user's input: every fault of it, each with its place
///   SolverError  3  a computation that did not converge or blew up
///   FileError    1  the machine: a file, a folder, a full disk
///
/// A bug is an assert. Nothing returns bool for success.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

namespace pennon {

/// One fault of the input. `where` is "file:line" or the name of an option; `what` is a sentence
/// that gives the value found and what would be right.
struct InputFault {
  std::string where;
  std::string what;
};

/// All faults found in an input, reported together.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::vector<InputFault> faults);
  InputError(std::string where, std::string what);
  const std::vector<InputFault>& faults() const { return faults_; }

 private:
  std::vector<InputFault> faults_;
};

/// A computation that did not converge, or met NaN: what, where, the last residual, what to try.
class SolverError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file or folder that could not be read or written: which, and what the system said.
class FileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A run that the user interrupted (Ctrl-C, SIGTERM), after it left its files whole.
class Interrupted : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace pennon
