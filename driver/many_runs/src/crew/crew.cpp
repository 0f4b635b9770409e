// SPDX-License-Identifier: Apache-2.0
#include "many_runs/crew.hpp"

#include <fmt/format.h>

#include <mutex>
#include <utility>

#include "base/executor.hpp"
#include "base/progress.hpp"

namespace driver {
namespace {

class ThreadCrew : public Crew {
 public:
  ThreadCrew(const CrewWork& work, int threads) : work_(work), executor_(threads) {}

  int workers() const override { return executor_.threads(); }

  void compute(const std::vector<std::string>& jobs,
               const std::function<void(std::size_t, CrewResult)>& keep) override {
    std::mutex lock;
    executor_.for_each(static_cast<int>(jobs.size()), [&](int i) {
      if (interrupted()) return;
      const auto job = static_cast<std::size_t>(i);
      work_(jobs[job], [&](CrewResult result) {
        const std::lock_guard<std::mutex> guard(lock);
        keep(job, std::move(result));
      });
    });
  }

 private:
  CrewWork work_;
  Executor executor_;
};

}  // namespace

std::unique_ptr<Crew> thread_crew(const CrewWork& work, int threads) {
  return std::make_unique<ThreadCrew>(work, threads);
}

void compute_jobs(const std::string& title, Crew& crew, const std::vector<std::string>& jobs, bool quiet,
                  const std::function<void(std::size_t, CrewResult)>& keep) {
  const std::size_t count = jobs.size();
  std::size_t ended = 0;
  Progress progress(title, static_cast<double>(count), quiet);
  crew.compute(jobs, [&](std::size_t job, CrewResult result) {
    keep(job, std::move(result));
    ++ended;
    progress.update(static_cast<double>(ended), [&] { return fmt::format("run {} of {}", ended, count); });
  });
}

}  // namespace driver
