#include "tests/model/formats/allocation_meter.h"

#include <malloc.h>

#include <atomic>
#include <cerrno>

namespace {

std::atomic<std::size_t> held{0}, most{0};

}  // namespace

#ifndef REMOUNT_SANITIZED

extern "C" {

void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);
void __libc_free(void*);

}  // extern "C"

namespace {

void* taken(void* memory) {
  if (memory == nullptr) return memory;
  const std::size_t now = held += malloc_usable_size(memory);
  for (std::size_t before = most; before < now && !most.compare_exchange_weak(before, now);) {
  }
  return memory;
}

void given_back(void* memory) {
  if (memory != nullptr) held -= malloc_usable_size(memory);
}

}  // namespace

extern "C" {

void* malloc(std::size_t bytes) noexcept { return taken(__libc_malloc(bytes)); }
void* calloc(std::size_t count, std::size_t bytes) noexcept { return taken(__libc_calloc(count, bytes)); }
/// The old block is counted until it is gone: both may be there at once.
void* realloc(void* memory, std::size_t bytes) noexcept {
  const std::size_t old = memory == nullptr ? 0 : malloc_usable_size(memory);
  void* now = __libc_realloc(memory, bytes);
  if (now != nullptr) taken(now);
  if (now != nullptr || bytes == 0) held -= old;
  return now;
}
void* memalign(std::size_t alignment, std::size_t bytes) noexcept { return taken(__libc_memalign(alignment, bytes)); }
void* aligned_alloc(std::size_t alignment, std::size_t bytes) noexcept {
  return taken(__libc_memalign(alignment, bytes));
}
int posix_memalign(void** memory, std::size_t alignment, std::size_t bytes) noexcept {
  *memory = taken(__libc_memalign(alignment, bytes));
  return *memory == nullptr ? ENOMEM : 0;
}
void free(void* memory) noexcept {
  given_back(memory);
  __libc_free(memory);
}

}  // extern "C"

#endif

namespace remount::formats {

AllocationMeter::AllocationMeter() : before_(held) { most = before_; }

std::size_t AllocationMeter::peak_bytes() const { return most - before_; }

bool AllocationMeter::works() {
  const std::size_t before = held;
  const char* volatile kept = new char[1000];
  const bool counted = held >= before + 1000;
  delete[] kept;
  return counted;
}

}  // namespace remount::formats
