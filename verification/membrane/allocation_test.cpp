// SPDX-License-Identifier: Apache-2.0
// No stage allocates after make_state.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "scenes.hpp"

namespace {
std::atomic<long> allocations{0};

void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* p = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (p == nullptr) throw std::bad_alloc();
  return p;
}
}  // namespace

void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new[](std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
void* operator new(std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void* operator new[](std::size_t size, std::align_val_t a) {
  return counted(size, static_cast<std::size_t>(a));
}
void operator delete(void* p) noexcept {
  std::free(p);
}
void operator delete[](void* p) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete(void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}
void operator delete[](void* p, std::size_t, std::align_val_t) noexcept {
  std::free(p);
}

TEST(Allocation, stages_allocate_nothing) {
  const auto mesh = membrane::icosphere(0.3, 3);
  auto d = scenes::describe(mesh, membrane::Compression::none);
  d.straps = {{0, 10, 4500.0, 0.01}};
  d.plates = {{{0.0, 0.0, -0.1}, {0.0, 0.0, 1.0}, 1e6}};
  const auto model = make_model(d);
  auto state = membrane::make_state(model, mesh.nodes, {.jet = true, .contact = true});
  const std::vector<double> dp(static_cast<std::size_t>(model.element_count), 700.0);
  const long before = allocations;
  EXPECT_GT(before, 0);  // the counter works
  for (int i = 0; i < 3; ++i) {
    membrane::update_surface(model, state);
    membrane::membrane_forces(model, state);
    membrane::pressure_forces(state, 1000.0);
    membrane::jet_forces(model, state, dp);
    membrane::support_forces(model, state);
    const auto shares = membrane::stiffness_shares(model, state, 1.4, 1.1e5);
    membrane::advance(model, state, 1e-6, 0.5 * membrane::critical_time_step(shares));
    membrane::governing_element(model, state);
  }
  const long during = allocations - before;
  EXPECT_EQ(during, 0);
}
