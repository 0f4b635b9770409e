// SPDX-License-Identifier: Apache-2.0
// Who computes many runs: threads of this process, or the ranks of an MPI job.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace driver {

/// What a crew does: it computes a job, a text that any process can read, and calls `emit` with each line of
/// results.
using CrewWork =
    std::function<void(const std::string& job, const std::function<void(const std::string& line)>& emit)>;

class Crew {
 public:
  virtual ~Crew() = default;
  /// Jobs at a time.
  virtual int workers() const = 0;
  /// Does jobs in any order and side by side, until an interrupt. Calls `keep` with the place of the job and
  /// a line of it, as soon as there is one and one call at a time.
  virtual void compute(const std::vector<std::string>& jobs,
                       const std::function<void(std::size_t job, const std::string& line)>& keep) = 0;
};

/// Makes the crew that does `work`; none in a process that has only helped another one, whose work is then
/// over. Processes of one `id` alone may help each other.
using MakeCrew =
    std::function<std::unique_ptr<Crew>(const std::string& id, const CrewWork& work, int threads)>;

/// Threads of this process. The work is called by all of them.
std::unique_ptr<Crew> thread_crew(const CrewWork& work, int threads);

/// Crew::compute() for jobs of one line each, with the progress under `title`.
void compute_jobs(const std::string& title, Crew& crew, const std::vector<std::string>& jobs, bool quiet,
                  const std::function<void(std::size_t job, const std::string& line)>& keep);

}  // namespace driver
