// SPDX-License-Identifier: Apache-2.0
// Who computes many runs: threads of this process, or the ranks of an MPI job.
#pragma once

#include <any>
#include <cstddef>
#include <functional>
#include <memory>
#include <string>

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
  /// Does `count` jobs side by side, in any order; several threads may ask for their texts. Calls `keep` with
  /// each result, as soon as there is one and one call at a time. After an interrupt no job begins, and those
  /// that run may end without results. Throws what the work and `keep` throw.
  virtual void compute(std::size_t count, const std::function<std::string(std::size_t)>& job,
                       const std::function<void(CrewResult result)>& keep) = 0;
};

/// Makes the crew that does `work`; `threads` counts its workers if they are threads. Returns null in a
/// process that has been a worker of another one: all jobs are done then. Throws CaseError where the other
/// one has another `id`, which stands for the command and all that it reads.
using MakeCrew =
    std::function<std::unique_ptr<Crew>(const std::string& id, const CrewWork& work, int threads)>;

/// Threads of this process.
std::unique_ptr<Crew> thread_crew(const CrewWork& work, int threads);

}  // namespace driver
