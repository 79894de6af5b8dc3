/// Work arrays of one shape, lent by name. Whoever needs one leases it and returns it by letting go
/// of the lease: two parts of a computation cannot write into one array, and those that never run
/// at the same time share their memory. An array is made when none is free, and kept.
///
/// A lent array holds whatever its last user left there; builds with assertions fill it with NaN.
#pragma once

#include <cassert>
#include <functional>
#include <limits>
#include <list>
#include <string_view>
#include <utility>

namespace pennon::dns {

template <class Array>
class Scratch {
  struct Slot {
    Array array;
    std::string_view name = {};  // of the lease; empty: free
  };

 public:
  /// Lends an array for as long as the lease lives. An empty lease lends none.
  class Lease {
   public:
    Lease() = default;
    Lease(Lease&& other) noexcept : slot_(std::exchange(other.slot_, nullptr)) {}
    Lease& operator=(Lease&& other) noexcept {
      std::swap(slot_, other.slot_);
      return *this;
    }
    Lease(const Lease&) = delete;
    Lease& operator=(const Lease&) = delete;
    ~Lease() { release(); }

    void release() {
      if (slot_) slot_->name = {};
      slot_ = nullptr;
    }
    explicit operator bool() const { return slot_ != nullptr; }
    Array& operator*() const { return slot_->array; }
    Array* operator->() const { return &slot_->array; }
    /// Null for an empty lease.
    Array* get() const { return slot_ ? &slot_->array : nullptr; }

   private:
    friend class Scratch;
    explicit Lease(Slot& slot) : slot_(&slot) {}
    Slot* slot_ = nullptr;
  };

  explicit Scratch(std::function<Array()> make) : make_(std::move(make)) {}

  /// Asserts that no array is lent under this name, which must be a literal.
  Lease lease(std::string_view name) {
    Slot* free = nullptr;
    for (Slot& slot : slots_) {
      assert(slot.name != name && "a work array is lent twice under one name");
      if (slot.name.empty() && !free) free = &slot;
    }
    if (!free) free = &slots_.emplace_back(Slot{make_()});
    free->name = name;
#if !defined(NDEBUG)
    for (auto& value : values_of(free->array)) value = std::numeric_limits<double>::quiet_NaN();
#endif
    return Lease(*free);
  }

  /// The arrays made so far: the most that were lent at once.
  std::size_t size() const {
    return slots_.size();
  }

 private:
  static auto& values_of(Array& array) {
    if constexpr (requires { array.values(); })
      return array.values();
    else
      return array;
  }

  std::function<Array()> make_;
  std::list<Slot> slots_;  // never moved: leases point to them
};

}  // namespace pennon::dns
