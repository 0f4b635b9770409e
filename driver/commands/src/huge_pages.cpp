// SPDX-License-Identifier: Apache-2.0
// The program's aligned operator new puts arrays of some megabytes on huge pages, if the system allows. From
// 100 000 elements on, the arrays of a membrane exceed the processor's table of 4-kB pages. The libraries
// leave this choice to the program.
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

void* operator new(std::size_t size, std::align_val_t alignment) {
  constexpr std::size_t huge_page = std::size_t{1} << 21;  // [byte]
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
