// SPDX-License-Identifier: Apache-2.0
#include "many_runs/crew.hpp"

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

  void compute(std::size_t count, const std::function<std::string(std::size_t)>& job,
               const std::function<void(CrewResult)>& keep) override {
    std::mutex lock;
    executor_.for_each(static_cast<int>(count), [&](int i) {
      if (interrupted()) return;
      work_(job(static_cast<std::size_t>(i)), [&](CrewResult result) {
        const std::lock_guard<std::mutex> guard(lock);
        keep(std::move(result));
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

}  // namespace driver
