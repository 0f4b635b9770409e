// SPDX-License-Identifier: Apache-2.0
// Who computes many runs: threads of this process, or the ranks of an MPI job.
#pragma once

#include <any>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace driver {

/// One result of a job, as a line of text.
struct CrewResult {
  std::string line;
  /// The same as an object, or nothing. It comes from threads of this process alone, and spares the time to
  /// read the line, which can be that of a short run.
  std::any object = {};
};

/// What a crew does: computes a job, a text that any process can read, and calls `emit` with each result.
/// Several threads may call it at a time.
using CrewWork =
    std::function<void(const std::string& job, const std::function<void(CrewResult result)>& emit)>;

/// The workers of a command that makes many runs.
class Crew {
 public:
  virtual ~Crew() = default;
  /// Jobs at a time.
  virtual int workers() const = 0;
  /// Does the jobs side by side, in any order. Calls `keep` with each result and the index of its job, as
  /// soon as there is one and one call at a time. After an interrupt no job begins, and those that run may
  /// end without results. Throws what the work and `keep` throw.
  virtual void compute(const std::vector<std::string>& jobs,
                       const std::function<void(std::size_t job, CrewResult result)>& keep) = 0;
};

/// Makes the crew that does `work`; `threads` counts its workers if they are threads. Returns null in a
/// process that has been a worker of another one: all jobs are done then. Throws CaseError where the other
/// one has another `id`, which stands for the command and all that it reads.
using MakeCrew =
    std::function<std::unique_ptr<Crew>(const std::string& id, const CrewWork& work, int threads)>;

/// Threads of this process.
std::unique_ptr<Crew> thread_crew(const CrewWork& work, int threads);

/// Crew::compute() for jobs of one result each; shows the progress under `title`.
void compute_jobs(const std::string& title, Crew& crew, const std::vector<std::string>& jobs, bool quiet,
                  const std::function<void(std::size_t job, CrewResult result)>& keep);

}  // namespace driver
