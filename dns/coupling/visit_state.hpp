/// The members of the state of flag and fluid together, for visit().
#pragma once

#include <type_traits>

#include "dns/coupling/coupling.hpp"
#include "dns/flag/state.hpp"
#include "dns/fluid/visit_state.hpp"
#include "dns/numerics/state_members.hpp"

namespace pennon::dns {

template <class T>
concept IsCoupledState = std::is_same_v<std::remove_const_t<T>, CoupledState<2>> ||
    std::is_same_v<std::remove_const_t<T>, CoupledState<3>>;

/// The members of a coupled state under the names that they have in a checkpoint. `fluid` and
/// `flag` are themselves states with members; the reduced jump is called "jump" there.
template <IsCoupledState State>
auto members_of(State& state) {
  auto& [fluid, flag, reduced_jump, previous_reduced_jump, power] = state;
  return std::tuple{member("fluid", MemberKind::state, fluid),
                    member("flag", MemberKind::state, flag),
                    member("jump", MemberKind::pressure, reduced_jump),
                    member("previous_jump", MemberKind::pressure, previous_reduced_jump, 1),
                    member("power", MemberKind::number, power)};
}

}  // namespace pennon::dns
