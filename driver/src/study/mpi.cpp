// SPDX-License-Identifier: Apache-2.0
// `gasjet_study_mpi PLAN DIR`: the runs of a study on the ranks of an MPI job. Rank 0 hands out chunks to
// whoever is free and keeps what comes back; the others compute.
#include <fmt/format.h>
#include <mpi.h>

#include <cstdio>
#include <string>

#include "driver/case_reader.hpp"
#include "driver/progress.hpp"
#include "driver/result_folder.hpp"
#include "study/parts.hpp"

namespace driver {
namespace {

constexpr int tag_chunk = 1;   // numbers of runs; none: there are no more
constexpr int tag_result = 2;  // lines of runs; none: the first call for work

// A rank that ends a chunk gets the next one.
void hand_out(const StudyPlan& plan, const std::vector<StudyChunk>& chunks,
              const std::function<void(const StudyRun&)>& keep) {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  std::vector<int> free;
  for (int rank = ranks - 1; rank > 0; --rank) free.push_back(rank);
  std::size_t next = 0, busy = 0;
  const auto send = [&](int rank) {
    const StudyChunk& chunk = chunks[next++];
    MPI_Send(chunk.data(), static_cast<int>(chunk.size()), MPI_LONG, rank, tag_chunk, MPI_COMM_WORLD);
    ++busy;
  };
  while (busy > 0 || (next < chunks.size() && !interrupted())) {
    while (!free.empty() && next < chunks.size() && !interrupted()) {
      send(free.back());
      free.pop_back();
    }
    MPI_Status status;
    MPI_Probe(MPI_ANY_SOURCE, tag_result, MPI_COMM_WORLD, &status);
    int size = 0;
    MPI_Get_count(&status, MPI_CHAR, &size);
    std::string text(static_cast<std::size_t>(size), ' ');
    MPI_Recv(text.data(), size, MPI_CHAR, status.MPI_SOURCE, tag_result, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    --busy;
    free.push_back(status.MPI_SOURCE);
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = text.find('\n', begin);
      if (const auto run = run_of_line(plan, text.substr(begin, end - begin))) keep(*run);
      begin = end + 1;
    }
  }
}

void send_home() {
  int ranks = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  for (int rank = 1; rank < ranks; ++rank) MPI_Send(nullptr, 0, MPI_LONG, rank, tag_chunk, MPI_COMM_WORLD);
}

void compute(const StudyPlan& plan) {
  StudyScenes scenes(1);
  for (;;) {
    MPI_Status status;
    MPI_Probe(0, tag_chunk, MPI_COMM_WORLD, &status);
    int count = 0;
    MPI_Get_count(&status, MPI_LONG, &count);
    StudyChunk chunk(static_cast<std::size_t>(count));
    MPI_Recv(chunk.data(), count, MPI_LONG, 0, tag_chunk, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
    if (chunk.empty()) return;
    std::string text;
    run_chunk(plan, chunk, scenes, [&](const StudyRun& run) { text += line_of(run); });
    MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, 0, tag_result, MPI_COMM_WORLD);
  }
}

// A rank of a machine that sees another plan, case or file would compute other runs.
void require_one_plan(const StudyPlan& plan, int rank) {
  std::string facts = plan.text;
  for (const auto& [file, digits] : plan.inputs->list()) facts += digits;
  const std::string own = digits_of(facts);
  std::string first = own;
  MPI_Bcast(first.data(), static_cast<int>(first.size()), MPI_CHAR, 0, MPI_COMM_WORLD);
  if (first != own)
    throw CaseError(
        fmt::format("{}: rank {} reads another plan, case or file than rank 0", plan.file.string(), rank));
}

int lead(const StudyPlan& plan, const std::filesystem::path& folder) {
  const bool whole = run_study(plan, folder, {}, hand_out, false);
  send_home();
  if (!whole) return 130;
  const StudySummary summary = merge_study(folder);
  fmt::print("{} of {} runs, {} done; results in {}\n", summary.runs, summary.asked, summary.done,
             folder.string());
  for (const auto& line : note_lines(summary)) fmt::print("{}\n", line);
  return summary.done == summary.runs ? 0 : 3;
}

int run_ranks(int argc, char** argv) {
  int rank = 0, ranks = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  if (argc != 3 || ranks < 2) {
    if (rank == 0) tell("usage: mpirun -n RANKS gasjet_study_mpi PLAN DIR, with 2 ranks or more");
    return 2;
  }
  const StudyPlan plan = read_study(argv[1]);
  require_one_plan(plan, rank);
  catch_interrupt();
  if (rank == 0) return lead(plan, argv[2]);
  compute(plan);
  return 0;
}

}  // namespace
}  // namespace driver

int main(int argc, char** argv) {
  MPI_Init(&argc, &argv);
  int code = 0;
  try {
    code = driver::run_ranks(argc, argv);
  } catch (const std::exception& error) {
    driver::tell(std::string("gasjet_study_mpi: ") + error.what());
    MPI_Abort(MPI_COMM_WORLD, 2);
  }
  MPI_Finalize();
  return code;
}
