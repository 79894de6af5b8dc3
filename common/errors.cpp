#include "common/errors.hpp"

#include <utility>

namespace pennon {
namespace {

std::string joined(const std::vector<InputFault>& faults) {
  std::string text;
  for (const InputFault& fault : faults) {
    if (!text.empty()) text += '\n';
    if (!fault.where.empty()) text += fault.where + ": ";
    text += fault.what;
  }
  return text;
}

}  // namespace

InputError::InputError(std::vector<InputFault> faults)
    : std::runtime_error(joined(faults)), faults_(std::move(faults)) {}

InputError::InputError(std::string where, std::string what)
    : InputError(std::vector<InputFault>{{std::move(where), std::move(what)}}) {}

}  // namespace pennon
