// SPDX-License-Identifier: Apache-2.0
// The runs of a ladder's rungs, and what they say of each: as many as its verdict needs.
#pragma once

#include "many_runs/ladder.hpp"
#include "run_jobs.hpp"

namespace driver {

/// Seeds that tell a chaotic scene, and the scatter of one that is not.
inline constexpr int probes = 4;

class RungRuns {
 public:
  /// Arguments must outlive the runs; these fill in the values of `result`'s rungs.
  RungRuns(const Scene& scene, const LadderOptions& options, Crew& crew, LadderResult& result,
           ResultFolder* folder);

  /// Whether seeds scatter by what the tolerance would notice: then every rung is a mean.
  void probe();
  /// The rungs from `first` on. One run of each goes first: it says how long all take.
  void run(std::size_t first, const char* what);
  /// Twice the runs where the verdict is open.
  void look_again();
  /// The volume that the bag has at each pressure, as TOML, if it has been kept.
  std::optional<std::string> kept_volume() const;
  void keep_volume(const std::string& text);

 private:
  struct Sample;
  bool is_mean(std::size_t rung) const;
  int wanted(std::size_t rung) const;
  long number(std::size_t rung, int seed) const;
  std::vector<Sample> samples(std::size_t rung, int count) const;
  RunJob job(std::size_t rung, int seed) const;
  void compute(std::vector<RunJob> jobs, const std::string& what);
  void run_missing(std::size_t first, int most, const std::string& what);
  void tell_cost(std::size_t first) const;
  void collect(std::size_t rung);
  void need(const std::string& name, const Sample& sample);

  const Scene& scene_;
  const LadderOptions& options_;
  Crew& crew_;
  LadderResult& result_;
  int most_seeds_;
  RunJournal journal_;
  std::vector<int> wanted_;  // runs of each rung that is a mean
  double deviation_ = 0.0;   // of one seed from another, in the full case
};

}  // namespace driver
