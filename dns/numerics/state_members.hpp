/// The members that a state of a simulation has, listed in one place.
///
/// Beside each state stands members_of(state): a tuple of its members, each with its name and what
/// it is. Checkpoints, restarts, starts and perturbations go through visit(), so that a member
/// added to a state reaches all of them, or does not compile where one cannot serve it.
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

namespace pennon::dns {

enum class MemberKind {
  number,    ///< one for the whole state: its time, a step, an energy
  position,  ///< of the flag's nodes or the grid's corners
  velocity,
  pressure,  ///< or its jump across the flag
  side,      ///< whether fluid enters or leaves
  guess,     ///< where a solver begins: the next step depends on it up to the solver's tolerance
  state      ///< a state of its own, with members
};

struct MemberInfo {
  const char* name;
  MemberKind kind;
  int steps_before = 0;  ///< the time at which it is: 0 now, 1 one step before
};

template <class Value>
struct Member {
  MemberInfo info;
  Value& value;
};

template <class Value>
Member<Value> member(const char* name, MemberKind kind, Value& value, int steps_before = 0) {
  return {{name, kind, steps_before}, value};
}

/// Calls use(info, value) for each member of a state, in order.
template <class State, class Use>
void visit(State& state, Use&& use) {
  std::apply([&](const auto&... members) { (use(members.info, members.value), ...); },
             members_of(state));
}

/// The same of two states at once, use(info, value, other value): of one and the same struct, or of
/// the flag's in two and in three dimensions.
template <class State, class Other, class Use>
void visit_both(State& state, Other& other, Use&& use) {
  const auto members = members_of(state);
  const auto others = members_of(other);
  [&]<std::size_t... k>(std::index_sequence<k...>) {
    (use(std::get<k>(members).info, std::get<k>(members).value, std::get<k>(others).value), ...);
  }
  (std::make_index_sequence<std::tuple_size_v<decltype(members_of(state))>>());
}

}  // namespace pennon::dns
