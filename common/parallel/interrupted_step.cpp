#include "common/parallel/interrupted_step.hpp"

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/parallel/ranks.hpp"

namespace pennon::ranks {
namespace {

constexpr double patience = 0.5;  // s

[[noreturn]] void stop() {
  pennon::stop_if_interrupted("what it was computing is not kept; start it again");
  throw Interrupted("stopped by another rank");
}

}  // namespace

void stop_if_interrupted() {
  if (any(was_interrupted_before(patience))) stop();
}

void stop_if_interrupted_alone() {
  if (was_interrupted_before(patience) && count() == 1) stop();
}

}  // namespace pennon::ranks
