/// The members of the fluid's state, for visit().
#pragma once

#include <type_traits>

#include "dns/fluid/state.hpp"
#include "dns/numerics/state_members.hpp"

namespace pennon::dns {

/// The next step overwrites the last entry of `grid`: what is saved or perturbed leaves it out.
template <class State>
requires std::is_same_v<std::remove_const_t<State>, FluidState>
auto members_of(State& state) {
  auto& [t, previous_dt, u, u_last, u_change, p, p_last, grid, is_inflow] = state;
  return std::tuple{member("t", MemberKind::number, t),
                    member("previous_dt", MemberKind::number, previous_dt),
                    member("u", MemberKind::velocity, u),
                    member("u_last", MemberKind::velocity, u_last, 1),
                    member("u_change", MemberKind::guess, u_change),
                    member("p", MemberKind::pressure, p),
                    member("p_last", MemberKind::pressure, p_last, 1),
                    member("grid", MemberKind::position, grid),
                    member("is_inflow", MemberKind::side, is_inflow)};
}

}  // namespace pennon::dns
