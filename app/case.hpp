/// A whole case: every table that a case file may have, for all models.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include "analysis/decomposition/settings.hpp"
#include "analysis/signal/settings.hpp"
#include "app/compare_settings.hpp"
#include "common/case/case_reader.hpp"
#include "common/case/parameters.hpp"
#include "common/case/schema.hpp"
#include "dns/run/settings.hpp"
#include "lsa/settings.hpp"
#include "modes/global/study/settings.hpp"
#include "modes/normal/settings.hpp"

namespace pennon::app {

/// What a command computes whatever tables the case has: these are checked, with the defaults of
/// what is not given.
struct Asked {
  bool flow = false;  ///< [flow], which has no defaults
  bool lsa = false;
  bool modes = false;  ///< normal modes
  bool global_modes = false;
  bool dns = false;
  bool compare = false;
};

struct Case {
  FlagParameters flag;
  FlowParameters flow;
  bool has_flow = false;
  lsa::Settings lsa;
  modes::Settings modes;
  modes::global::Settings global_modes;
  dns::Settings dns;
  analysis::Settings analysis;
  decomposition::Settings decompose;
  CompareSettings compare;

  std::string name;  ///< of the file, without its ending
  Schema schema;     ///< bound to the members above, so a case does not move

  /// A fault that was found after the case was read, with the place of the key that it is about.
  InputError located(const InputError& error) const { return faults_->located(error); }

  /// All defaults; only its schema is of use.
  Case();
  /// Reads and checks a case file with its overrides. The echo of the schema has the tables that
  /// are given and those of what is asked. Throws InputError with every fault.
  Case(const std::filesystem::path& file, std::span<const std::string> overrides, const Asked&);
  Case(const Case&) = delete;
  Case& operator=(const Case&) = delete;
  ~Case() = default;

 private:
  std::optional<Faults> faults_;  // none where there is no file
};

}  // namespace pennon::app
