/// The state of a flag.
#pragma once

#include <type_traits>

#include "dns/flag/step.hpp"
#include "dns/numerics/state_members.hpp"

namespace pennon::dns {

/// All that is advanced, saved and restarted.
template <int dim>
struct FlagState {
  double t = 0;
  NodeVectors<dim> x, v;
  /// The step before, for backward differences; previous_dt = 0: none yet.
  NodeVectors<dim> previous_x, previous_v;
  double previous_dt = 0;
  double dissipated = 0;  ///< by the damping since the start
  double work = 0;        ///< of the loads (gravity is an energy of its own) since the start
};

template <class T>
concept IsFlagState = std::is_same_v<std::remove_const_t<T>, FlagState<2>> ||
    std::is_same_v<std::remove_const_t<T>, FlagState<3>>;

/// For visit().
template <IsFlagState State>
auto members_of(State& state) {
  auto& [t, x, v, previous_x, previous_v, previous_dt, dissipated, work] = state;
  return std::tuple{member("t", MemberKind::number, t),
                    member("x", MemberKind::position, x),
                    member("v", MemberKind::velocity, v),
                    member("previous_x", MemberKind::position, previous_x, 1),
                    member("previous_v", MemberKind::velocity, previous_v, 1),
                    member("previous_dt", MemberKind::number, previous_dt),
                    member("dissipated", MemberKind::number, dissipated),
                    member("work", MemberKind::number, work)};
}

}  // namespace pennon::dns
