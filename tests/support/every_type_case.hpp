/// A case with the flag, the stream, and a table that has a key of each type a case file may hold.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "common/case/schema.hpp"

namespace pennon::test {

enum class Shade { dark, light };

struct EveryTypeCase {
  FlagParameters flag;
  FlowParameters flow;
  bool has_flow = false;
  bool has_types = false;
  bool has_inner = false;

  double number = 0.5;
  std::optional<double> maybe_number;
  std::int64_t integer = 3;
  bool is_on = false;
  std::string text = "plain";
  std::string known_text = "wu";
  std::array<double, 3> triple = {1, 2, 3};
  std::vector<double> numbers = {1, 2};
  std::vector<std::int64_t> integers = {4, 5};
  std::vector<std::string> texts = {"a"};
  std::optional<Sweep> sweep;
  Shade shade = Shade::dark;
  std::optional<Shade> maybe_shade;
  double inner_number = 7;

  Schema schema() {
    Schema schema;
    declare(schema, flag);
    declare(schema, flow, has_flow);
    schema.table("types", "One key of each type.", &has_types)
        .key({"number", &number, "a number", Range{0, 10}})
        .key({"maybe_number", &maybe_number, "a number that may be unset"})
        .key({"integer", &integer, "an integer", Range{1, 100}})
        .key({"is_on", &is_on, "true or false"})
        .key({"text", &text, "any text"})
        .key({"known_text", &known_text, "one of two", any_sign, false, {}, {"wu", "lamb"}})
        .key({"triple", &triple, "three numbers"})
        .key({"numbers", &numbers, "numbers", Range{-5, 5}})
        .key({"integers", &integers, "integers", Range{0, 9}})
        .key({"texts", &texts, "texts"})
        .key({"sweep", &sweep, "a sweep", positive})
        .key({"shade", choice(shade, {"dark", "light"}), "a choice"})
        .key({"maybe_shade", choice(maybe_shade, {"dark", "light"}), "a choice that may be unset"});
    schema.table("types.inner", "A table in a table.", &has_inner)
        .key({"number", &inner_number, "a number", positive});
    return schema;
  }

  /// Reads a text named "case.toml"; throws InputError with all its faults.
  void read(const std::string& toml, const std::vector<std::string>& overrides = {}) {
    Schema bound = schema();
    read_case_text(toml, "case.toml", overrides, bound).raise();
  }
};

/// The faults of a text as "where: what" each; none if it can be read.
inline std::vector<std::string> faults_of(const std::string& toml,
                                          const std::vector<std::string>& overrides = {}) {
  std::vector<std::string> texts;
  try {
    EveryTypeCase().read(toml, overrides);
  } catch (const InputError& error) {
    for (const InputFault& fault : error.faults()) texts.push_back(fault.where + ": " + fault.what);
  }
  return texts;
}

}  // namespace pennon::test
