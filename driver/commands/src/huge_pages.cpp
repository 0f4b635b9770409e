// SPDX-License-Identifier: Apache-2.0
#include "huge_pages.hpp"

#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{1} << 21;  // [byte]

}  // namespace

// The program's aligned operator new puts arrays of some megabytes on huge pages, if the system allows. From
// 100 000 elements on, the arrays of a membrane exceed the processor's table of 4-kB pages.
void* operator new(std::size_t size, std::align_val_t alignment) {
  const bool many_pages = size >= 2 * huge_page;
  const std::size_t unit = std::max(static_cast<std::size_t>(alignment), many_pages ? huge_page : 1);
  const std::size_t rounded = (std::max(size, std::size_t{1}) + unit - 1) / unit * unit;
  void* const memory = rounded < size ? nullptr : std::aligned_alloc(unit, rounded);
  if (!memory) throw std::bad_alloc();
#ifdef MADV_HUGEPAGE
  if (many_pages) madvise(memory, rounded, MADV_HUGEPAGE);  // if refused, pages have the usual size
#endif
  return memory;
}

void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}

void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace driver::commands {

void use_huge_heap() {
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE)
  constexpr int heap = 16 << 20;  // [byte]
  const auto end = [] { return reinterpret_cast<std::uintptr_t>(sbrk(0)); };
  mallopt(M_MMAP_THRESHOLD, 2 * huge_page);
  mallopt(M_TRIM_THRESHOLD, 2 * heap);  // what was freed is kept for the next scene
  mallopt(M_TOP_PAD, heap);
  const std::uintptr_t first = (end() + huge_page - 1) / huge_page * huge_page;
  sbrk(static_cast<std::intptr_t>(first - end()));
  void* volatile more = std::malloc(huge_page);  // lets the heap grow
  std::free(more);
  if (end() > first) madvise(reinterpret_cast<void*>(first), end() - first, MADV_HUGEPAGE);
#endif
}

}  // namespace driver::commands
