/// How many members an aggregate has: the most initialisers that its braces take.
#pragma once

#include <concepts>
#include <cstddef>
#include <utility>

namespace pennon::test {

struct Anything {
  template <class T>
  operator T() const;  // NOLINT(google-explicit-constructor): it stands for any member
};

template <class Struct, std::size_t... k>
concept TakesInitialisers = requires {
  Struct{((void)k, Anything())...};
};

template <class Struct, std::size_t... k>
constexpr bool takes(std::index_sequence<k...>) {
  return TakesInitialisers<Struct, k...>;
}

template <class Struct, std::size_t count = 0>
constexpr std::size_t member_count() {
  if constexpr (takes<Struct>(std::make_index_sequence<count + 1>()))
    return member_count<Struct, count + 1>();
  else
    return count;
}

}  // namespace pennon::test
