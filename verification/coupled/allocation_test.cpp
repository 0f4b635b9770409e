// SPDX-License-Identifier: Apache-2.0
// No allocation inside a step.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "run_case.hpp"

namespace {
std::atomic<long> allocations{0};
void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = alignment ? std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment)
                           : std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size, 0);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace {

long allocations_of_steps(const driver::Scene& scene, int warm_up, int steps) {
  driver::State state = driver::make_state(scene);
  driver::StepRecords records;
  const auto advance = [&](int count) {
    for (int i = 0; i < count; ++i) {
      driver::step(scene, state, {}, records);
      state.time += state.step.after;
      ++state.steps;
    }
  };
  advance(warm_up);
  const long before = allocations;
  advance(steps);
  return allocations - before;
}

TEST(allocation, none_inside_a_step) {
  // 300 steps reach contact with the pendulum; the first step may still fill the workspace of the search.
  for (const char* name : {"passenger_pendulum", "passenger_pendulum_no_jet", "sphere_inflation",
                           "tank_blowdown", "plate_jet"}) {
    const auto scene = coupled::scene_of(name);
    EXPECT_EQ(allocations_of_steps(scene, 1, 300), 0) << name;
  }
  const long before = allocations;
  { std::vector<double> control(10); }
  EXPECT_GT(allocations - before, 0) << "the counter counts";
}

}  // namespace
