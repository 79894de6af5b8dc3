/// The loop through time that every run of a flag, a fluid or both has: steps, what is kept at
/// intervals, checkpoints, interrupts.
#pragma once

#include <concepts>
#include <cstdint>
#include <filesystem>
#include <string>

#include "common/errors.hpp"
#include "common/interrupt.hpp"
#include "common/io/hdf5.hpp"
#include "common/io/output_folder.hpp"
#include "common/parallel/ranks.hpp"
#include "common/progress.hpp"
#include "common/stop_watch.hpp"
#include "dns/run/history_records.hpp"
#include "dns/run/output_settings.hpp"
#include "dns/run/restart.hpp"
#include "dns/run/schedule.hpp"

namespace pennon::dns {

/// What the loop advances. Every rank calls every function.
template <class Body>
concept RunsThroughTime = requires(Body body, const Body& self, hdf5::Writer* file,
                                   const hdf5::Reader& reader, const HistoryCount& count,
                                   RecordFile& records) {
  { self.name() } -> std::convertible_to<std::string>;  ///< for the bar of progress
  { self.time() } -> std::same_as<double>;
  { self.is_at_end() } -> std::same_as<bool>;
  body.start();  ///< from the case, with what is kept of t = 0
  body.step();   ///< throws SolverError, and Interrupted where it leaves a step that takes long
  body.keep_state();     ///< all that the next step depends on,
  body.restore_state();  ///< and back, to be written; no step follows
  { self.words_of_step() } -> std::convertible_to<std::string>;

  body.keep_row();
  body.keep_shape();
  body.keep_fields();
  { self.has_rows() } -> std::same_as<bool>;
  self.write_results();

  /// The attribute "kind" of its checkpoints, as "flag_checkpoint", and what messages call them, as
  /// "a checkpoint of a flag".
  { self.checkpoint_kind() } -> std::convertible_to<std::string>;
  { self.words_of_checkpoint() } -> std::convertible_to<std::string>;
  self.write(file);  ///< all but the kind and the history; null but on the leading rank
  /// What is kept of the history so far; adds to the file, on the leading rank, what comes behind
  /// the first so many.
  { self.history_count() } -> std::same_as<HistoryCount>;
  self.add_records(count, records);
  body.read(reader);
};

struct LoopSummary {
  double t_end = 0;
  std::int64_t steps = 0;   ///< of this run, without those before a restart
  double step_seconds = 0;  ///< of the steps alone
  std::string checkpoint;   ///< the last one; empty: none
};

template <RunsThroughTime Body>
class TimeLoop {
 public:
  TimeLoop(Body& body, const OutputSettings& output, double t_end, const Beginning& beginning,
           const OutputFolder& folder)
      : body_(body), output_(output), t_end_(t_end), beginning_(beginning), folder_(folder) {}

  /// Starts, or goes on from a checkpoint, and leaves results and a checkpoint at the end. Throws
  /// SolverError (the last checkpoint's name in it), InputError (a checkpoint of something else),
  /// FileError, and Interrupted after a checkpoint.
  LoopSummary run(bool shows_progress) {
    if (beginning_.checkpoint)
      read_checkpoint(*beginning_.checkpoint);
    else
      body_.start();
    Progress progress(body_.name(), ticks, shows_progress);
    progress.begin_at(ticks_at(body_.time()));
    while (!body_.is_at_end()) {
      const Request request = largest_request();
      if (request == stop_now) stop();
      if (request == checkpoint_now) write_checkpoint();
      const double before = body_.time();
      step();
      keep_what_is_due(before);
      progress.advance_to(ticks_at(body_.time()), [this] { return body_.words_of_step(); });
    }
    write_checkpoint();
    body_.write_results();
    summary_.t_end = body_.time();
    return summary_;
  }

 private:
  static constexpr std::int64_t ticks = 1'000'000;
  std::int64_t ticks_at(double t) const {
    return static_cast<std::int64_t>(static_cast<double>(ticks) * t / t_end_);
  }

  // What a rank asks for before a step; all do what the largest number says.
  enum Request { nothing, checkpoint_now, stop_now };
  Request largest_request() const {
    const bool is_due = output_.checkpoint_minutes > 0 && ranks::is_leading() &&
                        since_checkpoint_.seconds() >= 60 * output_.checkpoint_minutes;
    const Request mine = is_interrupted() ? stop_now : is_due ? checkpoint_now : nothing;
    return static_cast<Request>(ranks::largest(mine));
  }

  void step() {
    const StopWatch watch;
    body_.keep_state();
    try {
      body_.step();
    } catch (const Interrupted&) {
      body_.restore_state();
      stop();
    } catch (const SolverError& fault) {
      if (body_.has_rows()) body_.write_results();
      const std::string saved = summary_.checkpoint.empty()
                                    ? "no checkpoint was written before"
                                    : "the last checkpoint is " + summary_.checkpoint;
      throw SolverError(std::string(fault.what()) + "; " + saved);
    }
    summary_.step_seconds += watch.seconds();
    ++summary_.steps;
  }

  void keep_what_is_due(double before) {
    const auto is_due = [&](double interval) {
      return passes_multiple(interval, before, body_.time());
    };
    if (output_.history_interval == 0 || is_due(output_.history_interval)) body_.keep_row();
    if (is_due(output_.shape_interval)) body_.keep_shape();
    if (is_due(output_.field_interval)) body_.keep_fields();
    if (is_due(output_.checkpoint_interval)) write_checkpoint();
  }

  [[noreturn]] void stop() {
    write_checkpoint();
    body_.write_results();
    const std::string advice = "go on with --restart " + summary_.checkpoint;
    stop_if_interrupted(advice.c_str());
    throw Interrupted("stopped by another rank; " + advice);
  }

  void write_checkpoint() {
    const std::filesystem::path path = folder_ / "checkpoint.h5";
    std::optional<hdf5::Writer> file;
    if (ranks::is_leading()) {
      file.emplace(path);
      file->attributes({{"kind", body_.checkpoint_kind()}});
      pennon::dns::write(beginning_.the_case, *file);
    }
    body_.write(file ? &*file : nullptr);
    if (file) {
      pennon::dns::write(append_history(), *file);
      file->write_contents();
      file->finish();
      records_->remove_others();
    }
    summary_.checkpoint = path.string();
    since_checkpoint_.lap();
  }

  // What the run has kept since the last checkpoint goes behind the rest, before a checkpoint that
  // counts on it takes the place of the last one.
  RecordsEnd append_history() {
    if (!records_) records_.emplace(folder_.path(), checkpoint_stem);
    body_.add_records(recorded_, *records_);
    recorded_ = body_.history_count();
    return records_->flush();
  }

  void read_checkpoint(const std::filesystem::path& path) {
    const hdf5::Reader file(path);
    if (file.text("/", "kind") != body_.checkpoint_kind())
      file.fail("is not " + std::string(body_.words_of_checkpoint()));
    file.expect_contents();
    body_.read(file);
    go_on_with_records_of(file);
    summary_.checkpoint = path.string();
  }

  // In the folder of the checkpoint the run writes on behind its history; in another one it begins
  // a file that will have all of it.
  void go_on_with_records_of(const hdf5::Reader& file) {
    const std::optional<RecordsEnd> records = records_of(file);
    const std::filesystem::path folder = file.path().parent_path();
    std::error_code ignored;
    if (!records ||
        !std::filesystem::equivalent(folder.empty() ? "." : folder, folder_.path(), ignored))
      return;
    records_.emplace(folder_.path(), checkpoint_stem, *records);
    recorded_ = body_.history_count();
  }

  Body& body_;
  const OutputSettings& output_;
  double t_end_;
  const Beginning& beginning_;
  const OutputFolder& folder_;
  LoopSummary summary_;
  std::optional<RecordFile> records_;  // of the leading rank: the history beside the checkpoints
  HistoryCount recorded_;              // what lies in it
  StopWatch since_checkpoint_;
};

}  // namespace pennon::dns
