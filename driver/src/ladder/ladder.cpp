// SPDX-License-Identifier: Apache-2.0
#include "driver/ladder.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "driver/progress.hpp"
#include "ladder/parts.hpp"
#include "step/stages.hpp"

namespace driver {
namespace {

using Picks = std::vector<std::size_t>;

constexpr int probes = 4;               // seeds that tell a chaotic scene
constexpr double harmless_share = 0.1;  // of the tolerance that the scatter of single runs may take
constexpr double rounding = 1e-12;      // of a difference from a value, as its share: some thousand roundings

// Of the quantity, so that a tolerance can be a share of it.
void need_size(LadderResult& result, double value, const char* where) {
  if (std::abs(value - result.zero) <= rounding * std::abs(result.zero))
    result.reason =
        fmt::format("{} is {:g} in {}, the value that it counts from: no tolerance is a share of that",
                    result.quantity, result.zero, where);
}

class LadderRun {
 public:
  LadderRun(const std::filesystem::path& file, const Scene& scene, const std::vector<std::string>& user,
            const LadderOptions& options, LadderResult& result, Journal& journal)
      : file_(file), scene_(scene), user_(user), options_(options), result_(result), journal_(journal) {
    for (const auto& axis : result.plan.axes) full_.push_back(axis.base);
  }

  void run() {
    add("full", full_);
    probe();
    if (result_.reason.empty()) run_rungs(0, "full case");
    if (const Statistics& full = result_.rungs.front().value; full.count > 0)
      need_size(result_, full.mean, "the full case");
    if (!result_.reason.empty()) return;
    add_finest();
    add_alternatives();
    add_as_it_is();
    add_rungs_without_membrane();
    run_rungs(1, "rungs");
    if (!result_.reason.empty()) return;
    const std::size_t before = result_.rungs.size();
    add_combinations();
    run_rungs(before, "combinations");
  }

 private:
  LadderRung& add(std::string name, const Picks& picks) {
    LadderRung rung;
    rung.name = std::move(name);
    rung.differs = picks == full_ ? rung.name : differing(picks);
    rung.overrides = combine(result_.plan, picks);
    rung.can_be_perturbed = scene_.bag.has_value();
    return result_.rungs.emplace_back(std::move(rung));
  }

  std::string differing(const Picks& picks) const {
    std::vector<std::string> names;
    for (std::size_t a = 0; a < picks.size(); ++a)
      if (picks[a] != full_[a]) names.push_back(result_.plan.axes[a].choices[picks[a]].name);
    return fmt::format("{}", fmt::join(names, ", "));
  }

  bool is_new(const std::vector<std::string>& overrides) const {
    return std::none_of(result_.rungs.begin(), result_.rungs.end(),
                        [&](const LadderRung& r) { return r.overrides == overrides; });
  }

  void add_finest() {
    const Picks picks = finest_picks(result_.plan);
    if (picks == full_) return;
    add("finest", picks);
    result_.finest = 1;
  }

  void add_as_it_is() {
    if (const auto same = std::find_if(result_.rungs.begin() + 1, result_.rungs.end(),
                                       [](const LadderRung& r) { return r.overrides.empty(); });
        same != result_.rungs.end())
      same->name = "as it is: " + same->name;
    if (!is_new({})) return;
    LadderRung& rung = result_.rungs.emplace_back();
    rung.name = rung.differs = "as it is";
    rung.can_be_perturbed = scene_.bag.has_value();
  }

  void add_alternatives() {
    for (std::size_t a = 0; a < full_.size(); ++a) {
      const LadderAxis& axis = result_.plan.axes[a];
      for (std::size_t c = 0; c < axis.choices.size(); ++c) {
        if (c == axis.base) continue;
        Picks picks = full_;
        picks[a] = c;
        const bool is_finest = picks == finest_picks(result_.plan);
        LadderRung& rung = is_finest ? result_.rungs[result_.finest] : add(axis.choices[c].name, picks);
        if (is_finest) rung.name += ": " + axis.choices[c].name;
        rung.axis = a;
        rung.choice = c;
      }
    }
  }

  void add_rungs_without_membrane() {
    if (!result_.plan.no_membrane) return;
    add_without_membrane(bag_by_volume(file_, job(0, 0).overrides, options_.quiet, result_.plan, journal_));
    add_without_membrane(rigid_tank(result_.plan));
  }

  void add_without_membrane(const std::optional<LadderChoice>& choice) {
    if (!choice) return;
    LadderRung& rung = result_.rungs.emplace_back();
    rung.name = rung.differs = choice->name;
    rung.overrides = combine(result_.plan, full_, choice->overrides);
  }

  // The full case less one thing more each time, the least important first. None of it depends on the clock:
  // the rungs are the same whenever and in how many parts a ladder runs.
  void add_combinations() {
    const auto& rungs = result_.rungs;
    const LadderRung& full = rungs.front();
    std::vector<LadderRung> coarser;
    for (const LadderRung& r : rungs)
      if (r.axis && r.choice < full_[*r.axis] && r.failure.empty() && r.value.count > 0 &&
          r.steps <= most_steps * full.steps)
        coarser.push_back(r);
    std::stable_sort(coarser.begin(), coarser.end(), [&](const LadderRung& a, const LadderRung& b) {
      return std::abs(a.value.mean - full.value.mean) < std::abs(b.value.mean - full.value.mean);
    });
    Picks picks = full_;
    for (const LadderRung& r : coarser) {
      if (r.choice >= picks[*r.axis]) continue;
      picks[*r.axis] = r.choice;
      if (is_new(combine(result_.plan, picks)))
        add("and " + result_.plan.axes[*r.axis].choices[r.choice].name, picks);
    }
  }

  // Whether seeds scatter by what the tolerance would notice: then every rung is a mean.
  void probe() {
    if (!scene_.bag) return;
    std::vector<LadderJob> jobs;
    for (int seed = 1; seed <= probes; ++seed) jobs.push_back(job(0, seed));
    const auto samples = run(jobs, "seeds");
    std::vector<double> values;
    for (std::size_t i = 0; i < samples.size(); ++i) {
      need(fmt::format("seed {} of rung \"full\"", i + 1), samples[i]);
      if (samples[i].value) values.push_back(*samples[i].value);
    }
    if (interrupted() || values.empty()) return;
    const Statistics seeds = statistics(values);
    result_.spread = seeds.maximum - seeds.minimum;
    deviation_ = seeds.standard_error * std::sqrt(seeds.count);
    const double size =
        std::max(std::abs(seeds.minimum - result_.zero), std::abs(seeds.maximum - result_.zero));
    result_.chaotic = result_.spread > harmless_share * options_.tolerance * size;
  }

  void run_rungs(std::size_t first, const char* what) {
    std::vector<LadderJob> jobs;
    for (std::size_t r = first; r < result_.rungs.size(); ++r) {
      const bool many = result_.chaotic && result_.rungs[r].can_be_perturbed;
      for (int i = 0; i < (many ? options_.runs : 1); ++i) jobs.push_back(job(r, many ? i + 1 : 0));
    }
    const auto samples = run(jobs, what);
    for (std::size_t r = first; r < result_.rungs.size(); ++r) collect(jobs, samples, r);
  }

  void collect(const std::vector<LadderJob>& jobs, const std::vector<LadderSample>& samples,
               std::size_t index) {
    std::vector<double> values;
    LadderRung& rung = result_.rungs[index];
    double cpu = 0.0, steps = 0.0;
    for (std::size_t j = 0; j < jobs.size(); ++j) {
      if (jobs[j].rung != index) continue;
      if (index == 0 || index == result_.finest) need(fmt::format("rung \"{}\"", rung.name), samples[j]);
      if (!samples[j].failure.empty()) rung.failure = samples[j].failure;
      if (!samples[j].value) continue;
      values.push_back(*samples[j].value);
      cpu += samples[j].cpu_seconds;
      steps += static_cast<double>(samples[j].steps);
    }
    rung.value = statistics(values);
    if (!result_.chaotic && rung.can_be_perturbed) rung.value.standard_error = deviation_;
    if (values.empty()) return;
    rung.cpu_seconds = cpu / static_cast<double>(values.size());
    rung.steps = steps / static_cast<double>(values.size());
  }

  LadderJob job(std::size_t rung, int seed) const {
    auto overrides = user_;
    const auto& own = result_.rungs[rung].overrides;
    overrides.insert(overrides.end(), own.begin(), own.end());
    if (seed > 0) overrides = perturbed(std::move(overrides), default_amplitude, seed);
    return {rung, std::move(overrides), seed > 0};
  }

  std::vector<LadderSample> run(const std::vector<LadderJob>& jobs, const std::string& what) const {
    return run_jobs(file_, jobs, result_.quantity, scene_.name + ", " + what, options_.threads,
                    options_.quiet, journal_);
  }

  // All are compared to this one.
  void need(const std::string& name, const LadderSample& sample) {
    if (interrupted() || sample.failure.empty()) return;
    const auto message = fmt::format("{}, to which all are compared: {}", name, sample.failure);
    if (!sample.no_event) throw std::runtime_error(message);
    if (result_.reason.empty()) result_.reason = message;
  }

  const std::filesystem::path& file_;
  const Scene& scene_;
  const std::vector<std::string>& user_;
  const LadderOptions& options_;
  LadderResult& result_;
  Journal& journal_;
  Picks full_;
  double deviation_ = 0.0;  // of one seed from another, in the full case
};

}  // namespace

LadderResult run_ladder(const std::filesystem::path& file, const std::vector<std::string>& overrides,
                        const LadderOptions& options, ResultFolder* folder) {
  LadderResult result;
  result.plan = plan_ladder(file, overrides, options.quantity, options.hold);
  CaseDocument document(file, overrides);
  const Scene scene = read_scene(document);
  result.quantity = quantity_name(scene, options.quantity);
  if (result.quantity.ends_with("pressure_Pa")) result.zero = scene.ambient.pressure;
  if (options.ready) options.ready();
  Journal journal(folder);
  if (journal.size() > 0 && !options.quiet)
    tell(fmt::format("{}: goes on after {} runs that are done", one_line(scene.name), journal.size()));
  LadderRun(file, scene, overrides, options, result, journal).run();
  if (interrupted() || !result.reason.empty()) return result;
  judge(result, options.tolerance);
  need_size(result, result.reference.value, "the reference");
  return result;
}

}  // namespace driver
