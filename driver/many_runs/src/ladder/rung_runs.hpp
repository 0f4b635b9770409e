// SPDX-License-Identifier: Apache-2.0
// The runs of a ladder's rungs, and what they say of each: as many as its verdict needs.
#pragma once

#include "ladder/parts.hpp"

namespace driver {

class RungRuns {
 public:
  /// Arguments must outlive the runs; these fill in the values of `result`'s rungs.
  RungRuns(const Scene& scene, const std::vector<std::string>& user, const LadderOptions& options, Crew& crew,
           LadderResult& result, Journal& journal)
      : scene_(scene), user_(user), options_(options), crew_(crew), result_(result), journal_(journal) {}

  /// Whether seeds scatter by what the tolerance would notice: then every rung is a mean.
  void probe();
  /// The rungs from `first` on. One run of each goes first: it says how long all take.
  void run(std::size_t first, const char* what);
  /// Twice the runs where the verdict is open.
  void look_again();
  /// All of a rung.
  std::vector<std::string> overrides(std::size_t rung) const;

 private:
  int wanted(std::size_t rung) const;
  LadderJob job(std::size_t rung, int seed) const;
  std::vector<LadderSample> samples_of(const std::vector<LadderJob>& jobs, const std::string& what) const;
  void run_missing(std::size_t first, int most, const std::string& what);
  void tell_cost(std::size_t first) const;
  void collect(std::size_t rung);
  void need(const std::string& name, const LadderSample& sample);

  const Scene& scene_;
  const std::vector<std::string>& user_;
  const LadderOptions& options_;
  Crew& crew_;
  LadderResult& result_;
  Journal& journal_;
  std::vector<std::vector<LadderSample>> samples_;  // of each rung
  std::vector<int> wanted_;                         // runs of each rung that is a mean
  double deviation_ = 0.0;                          // of one seed from another, in the full case
};

}  // namespace driver
