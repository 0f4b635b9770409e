// SPDX-License-Identifier: Apache-2.0
#include "many_runs/cost.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <deque>

#include "base/progress.hpp"
#include "case_settings.hpp"
#include "engine/run.hpp"
#include "engine/stage_clock.hpp"
#include "results/load_scene.hpp"
#include "results/run_to_folder.hpp"

namespace driver {
namespace {

constexpr double short_variant = 0.02;  // [s] a shorter one is repeated until it has taken so long
constexpr int most_repeats = 1000;
constexpr double long_variant = 5.0;  // of the case's own time: it gets a third of the runs

// A folder for the files of runs, removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "gasjet_cost_XXXXXX").string();
    if (!mkdtemp(name.data())) throw OutputError(fmt::format("{}: cannot be made", name));
    path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct Timed {
  RunOutcome outcome;
  double cpu_seconds = 0.0;
  long steps = 0;
};

// A variant with what is kept between its runs.
struct Prepared {
  CostVariant* variant = nullptr;
  std::optional<Scene> scene;
  int repeats = 1;
  int runs = 0;
  std::array<double, kStages> stage_sums{};  // of each stage's share of its run's CPU time
  int sampled_runs = 0;
};

class Measurement {
 public:
  explicit Measurement(const CostOptions& options) : options_(options) {}

  // Once, untimed: caches and memory are warm from here on, and it says how long a run is.
  void warm_up(Prepared& p, double base_seconds) {
    const Timed timed = run(p);
    CostVariant& variant = *p.variant;
    if (timed.outcome.status == RunStatus::failed) variant.failure = timed.outcome.message;
    if (timed.outcome.status == RunStatus::interrupted) variant.failure = "interrupted";
    variant.steps = timed.steps;
    p.repeats = static_cast<int>(
        std::clamp(std::ceil(short_variant / std::max(timed.cpu_seconds, 1e-9)), 1.0, 1.0 * most_repeats));
    const bool is_long = base_seconds > 0.0 && timed.cpu_seconds > long_variant * base_seconds;
    p.runs = variant.failure.empty() ? is_long ? std::max(3, options_.runs / 3) : options_.runs : 0;
    warm_seconds_ = timed.cpu_seconds;
  }
  double warm_seconds() const { return warm_seconds_; }

  void measure(Prepared& p) {
    double seconds = 0.0;
    for (int i = 0; i < p.repeats; ++i) {
      const Timed timed = run(p);
      if (timed.outcome.status == RunStatus::interrupted) return;
      seconds += timed.cpu_seconds;
      if (!(timed.cpu_seconds > 0.0)) continue;
      for (std::size_t s = 0; s < kStages; ++s)
        p.stage_sums[s] += timed.outcome.stage_seconds[s] / timed.cpu_seconds;
      ++p.sampled_runs;
    }
    p.variant->cpu_seconds.push_back(seconds / p.repeats);
  }

  static void finish(Prepared& p) {
    CostVariant& variant = *p.variant;
    if (variant.cpu_seconds.empty()) return;
    const double least = variant.least();
    variant.rest_seconds = least;
    for (std::size_t s = 0; s < kStages; ++s) {
      variant.stage_seconds[s] = least * p.stage_sums[s] / std::max(1, p.sampled_runs);
      variant.rest_seconds -= variant.stage_seconds[s];
    }
  }

 private:
  Timed run(const Prepared& p) const {
    Timed timed;
    const auto watch = [&](bool, const State& now) { timed.steps = now.steps; };
    const double before = cpu_seconds(false);
    if (p.variant->writes_files) {
      RunOptions options;
      options.quiet = true;
      options.threads = options_.threads;
      options.watch = watch;
      timed.outcome = run_to_folder(*p.scene, scratch_.path(), {}, options);
    } else {
      State state = make_state(*p.scene);
      timed.outcome = run_scene(*p.scene, state, watch, {}, Executor(options_.threads));
    }
    timed.cpu_seconds = cpu_seconds(false) - before;
    return timed;
  }

  const CostOptions& options_;
  ScratchFolder scratch_;
  double warm_seconds_ = 0.0;
};

// Rows cost nothing where nothing is written, unless the steps follow them.
void leave_out_rows(Scene& scene) {
  if (scene.moves() && !scene.output.history_exact) scene.output.history_every = scene.time.end;
}

std::deque<Prepared> prepare(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                             CostResult& result) {
  std::deque<Prepared> all;
  for (CostVariant& variant : result.variants) {
    Prepared& p = all.emplace_back();
    p.variant = &variant;
    try {
      p.scene = load_variant(file, overrides, variant.overrides);
      if (!variant.writes_files) leave_out_rows(*p.scene);
    } catch (const CaseError& error) {
      variant.failure = error.what();
    }
  }
  return all;
}

void warm_up_all(std::deque<Prepared>& all, Measurement& measurement) {
  double base = 0.0;
  for (Prepared& p : all) {
    if (!p.scene || interrupted()) continue;
    measurement.warm_up(p, base);
    if (base == 0.0) base = measurement.warm_seconds();
  }
}

double quantile(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double place = share * static_cast<double>(values.size() - 1);
  const auto low = static_cast<std::size_t>(place);
  const std::size_t high = std::min(low + 1, values.size() - 1);
  return values[low] + (place - static_cast<double>(low)) * (values[high] - values[low]);
}

}  // namespace

double CostVariant::least() const {
  return *std::ranges::min_element(cpu_seconds);
}
double CostVariant::median() const {
  return quantile(cpu_seconds, 0.5);
}
double CostVariant::largest() const {
  return *std::ranges::max_element(cpu_seconds);
}
double CostVariant::per_step() const {
  return least() / static_cast<double>(std::max(1L, steps));
}

const CostVariant* CostResult::find(const std::string& name) const {
  const auto found = std::ranges::find(variants, name, &CostVariant::name);
  return found == variants.end() || found->cpu_seconds.empty() ? nullptr : &*found;
}

CostDifference cost_difference(const CostVariant& base, const CostVariant& variant) {
  CostDifference d;
  d.run_seconds = base.least() - variant.least();
  d.by_steps = base.per_step() * static_cast<double>(base.steps - variant.steps);
  d.by_cost = d.run_seconds - d.by_steps;
  d.ratio = base.least() / variant.least();
  std::vector<double> differences, ratios;
  for (std::size_t i = 0; i < std::min(base.cpu_seconds.size(), variant.cpu_seconds.size()); ++i) {
    differences.push_back(base.cpu_seconds[i] - variant.cpu_seconds[i]);
    ratios.push_back(base.cpu_seconds[i] / variant.cpu_seconds[i]);
  }
  d.scatter = 0.5 * (quantile(differences, 0.75) - quantile(differences, 0.25));
  d.low = quantile(ratios, 0.25);
  d.high = quantile(ratios, 0.75);
  return d;
}

CostResult measure_cost(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const CostOptions& options) {
  CostResult result;
  {
    CaseDocument document(file, overrides);
    const Scene scene = load_scene(document);
    result.scene = scene.name;
    result.runs = options.runs;
    result.threads = options.threads;
    if (scene.bag) result.elements = scene.bag->model.element_count;
    add_variants(scene, document, result);
  }
  auto all = prepare(file, overrides, result);
  Measurement measurement(options);
  warm_up_all(all, measurement);
  double asked = 0.0, done = 0.0;
  for (const Prepared& p : all) asked += p.runs;
  Progress progress("cost of " + result.scene, asked, options.quiet);
  const std::size_t count = all.size();
  for (int round = 0; round < options.runs; ++round)
    for (std::size_t k = 0; k < count; ++k) {
      // Each follows another one in each round, so that none gets the caches of the same neighbour.
      Prepared& p = all[(k + static_cast<std::size_t>(round)) % count];
      if (round >= p.runs || interrupted()) continue;
      measurement.measure(p);
      progress.update(++done, [&] { return p.variant->name; });
    }
  for (Prepared& p : all) Measurement::finish(p);
  return result;
}

}  // namespace driver
