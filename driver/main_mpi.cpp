// SPDX-License-Identifier: Apache-2.0
// `mpirun gasjet_mpi ensemble|ladder|study run ...`: the command of `gasjet` on rank 0, which hands out its
// runs to whoever is free; the other ranks compute.
#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <cstdio>
#include <stdexcept>
#include <string>
#include <utility>

#include "base/case_reader.hpp"
#include "base/progress.hpp"
#include "base/result_folder.hpp"
#include "commands/command.hpp"
#include "commands/program.hpp"
#include "many_runs/crew.hpp"

namespace driver {
namespace {

enum Tag {
  tag_job = 1,      // to a rank; empty: there are no more
  tag_line,         // of its results, and then one of the following
  tag_ended,        // the job
  tag_interrupted,  // the rank; its job may not have ended
  tag_refused,      // what() of a CaseError
  tag_failed,       // of another error
};

struct Message {
  int from, tag;
  std::string text;
};

Message receive(int from) {
  MPI_Status status;
  MPI_Probe(from, MPI_ANY_TAG, MPI_COMM_WORLD, &status);
  int size = 0;
  MPI_Get_count(&status, MPI_CHAR, &size);
  std::string text(static_cast<std::size_t>(size), ' ');
  MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, status.MPI_TAG, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return {status.MPI_SOURCE, status.MPI_TAG, std::move(text)};
}

void send(const std::string& text, int to, Tag tag) {
  MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
}

// The other ranks, as workers of rank 0.
class RankCrew : public Crew {
 public:
  // `out` counts the jobs that have not ended.
  RankCrew(int ranks, std::size_t& out) : ranks_(ranks), out_(out) {}
  RankCrew(const RankCrew&) = delete;
  RankCrew& operator=(const RankCrew&) = delete;
  ~RankCrew() override {
    for (int rank = 1; rank < ranks_ && out_ == 0; ++rank) send("", rank, tag_job);
  }

  int workers() const override { return ranks_ - 1; }

  // A rank that ends a job gets the next one.
  void compute(std::size_t count, const std::function<std::string(std::size_t)>& job,
               const std::function<void(CrewResult)>& keep) override {
    std::vector<int> free;
    for (int rank = ranks_ - 1; rank > 0; --rank) free.push_back(rank);
    std::size_t next = 0;
    const auto is_more = [&] { return next < count && !interrupted(); };
    while (is_more() || out_ > 0) {
      for (; !free.empty() && is_more(); free.pop_back(), ++out_) send(job(next++), free.back(), tag_job);
      if (out_ == 0) return;  // an interrupt has come meanwhile
      Message message = receive(MPI_ANY_SOURCE);
      if (message.tag == tag_line) {
        keep({std::move(message.text)});
        continue;
      }
      free.push_back(message.from);
      --out_;
      if (message.tag == tag_refused) throw CaseError(message.text);
      if (message.tag == tag_failed) throw std::runtime_error(message.text);
      if (message.tag == tag_interrupted) interrupt();
    }
  }

 private:
  int ranks_;
  std::size_t& out_;
};

// This process among the others. All meet once: where their crew is made, or at the end of a command that has
// made none.
class Rank {
 public:
  Rank() {
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &ranks_);
    if (leads()) return;
    // Before all meet, rank 0 says the same. What this rank says is kept, and told only if rank 0 goes on.
    errors_ = dup(STDERR_FILENO);
    said_ = std::tmpfile();
    if (said_) dup2(fileno(said_), STDERR_FILENO);
    if (!std::freopen("/dev/null", "w", stdout)) throw std::runtime_error("/dev/null: cannot be opened");
  }

  bool leads() const { return rank_ == 0; }
  int ranks() const { return ranks_; }

  std::unique_ptr<Crew> crew(const std::string& id, const CrewWork& work) {
    const std::string own = digits_of(id), first = meet(own);
    if (leads()) return std::make_unique<RankCrew>(ranks_, out_);
    if (first != own)
      throw CaseError(
          fmt::format("rank {} reads another plan, case or file than rank 0, or is another build", rank_));
    help(work);
    return nullptr;
  }

  // The end of this rank's command, with its exit code. A failure ends all ranks that would wait for it.
  void end(int code) {
    const bool is_alone = !has_met_;
    if (code != 0 && leads() && (is_alone || out_ > 0)) MPI_Abort(MPI_COMM_WORLD, code);
    if (is_alone) meet(digits_of(""));  // where rank 0 has failed, this never returns
    if (code == 0 || leads()) return;
    if (is_alone && said_) {
      std::rewind(said_);
      for (int c = 0; (c = std::fgetc(said_)) != EOF;) std::fputc(c, stderr);
    }
    MPI_Abort(MPI_COMM_WORLD, code);
  }

 private:
  // Returns the digits of rank 0.
  std::string meet(std::string digits) {
    MPI_Bcast(digits.data(), static_cast<int>(digits.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
    has_met_ = true;
    if (!leads()) dup2(errors_, STDERR_FILENO);
    return digits;
  }

  static void help(const CrewWork& work) {
    catch_interrupt();
    for (std::string job; !(job = receive(0).text).empty();) {
      try {
        work(job, [](const CrewResult& result) { send(result.line, 0, tag_line); });
        send("", 0, interrupted() ? tag_interrupted : tag_ended);
      } catch (const CaseError& error) {
        send(error.what(), 0, tag_refused);
      } catch (const std::exception& error) {
        send(text_of(error), 0, tag_failed);
      }
    }
  }

  int rank_ = 0, ranks_ = 1;
  int errors_ = -1;            // where a rank's own errors go once all have met
  std::FILE* said_ = nullptr;  // before that
  bool has_met_ = false;
  std::size_t out_ = 0;  // jobs that have not ended
};

int run_ranks(int argc, char** argv) {
  Rank rank;
  const auto word = [&](int i) { return i < argc ? std::string(argv[i]) : std::string(); };
  const bool asks = word(1) == "--help" || word(1) == "--version";
  const bool has_runs =
      word(1) == "ensemble" || word(1) == "ladder" || (word(1) == "study" && word(2) == "run");
  int code = commands::exit_input;
  if (!asks && (rank.ranks() < 2 || !has_runs))
    tell("usage: mpirun -n RANKS gasjet_mpi ensemble|ladder|study run ..., with 2 ranks or more");
  else
    code = commands::program(
        argc, argv, [&](const std::string& id, const CrewWork& work, int) { return rank.crew(id, work); });
  rank.end(code);
  return rank.leads() ? code : 0;
}

}  // namespace
}  // namespace driver

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  const int code = driver::run_ranks(argc, argv);
  MPI_Finalize();
  return code;
}
