#include "ProgramMemory.h"

#include <vtkAlgorithm.h>

#include <cstdint>
#include <cstdlib>
#include <limits>
#include <new>
#include <utility>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

void KeepFreedMemory()
{
#ifdef __GLIBC__
  mallopt(M_MMAP_THRESHOLD, 1 << 25);
  mallopt(M_TRIM_THRESHOLD, std::numeric_limits<int>::max());
#endif
}

void MemoryReturn::Execute(vtkObject* caller, unsigned long event, void* vtkNotUsed(callData))
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
  if (event != vtkCommand::ProgressEvent || algorithm == nullptr)
  {
    return;
  }
  const char* text = algorithm->GetProgressText();
  std::string phase = text != nullptr ? text : "";
  if (phase != this->Phase)
  {
    this->Phase = std::move(phase);
#ifdef __GLIBC__
    malloc_trim(0);
#endif
  }
}

// A sanitizer has its own.
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE) && !defined(__SANITIZE_ADDRESS__) &&              \
  !defined(__SANITIZE_THREAD__)

namespace
{
/** Asks for large pages where the whole of them is in an array; the system may refuse. */
void AdviseLargePages(void* memory, std::size_t size)
{
  constexpr std::size_t smallPage = 1U << 12U;
  constexpr std::size_t minSize = 1U << 22U; // two large pages
  if (size < minSize)
  {
    return;
  }
  const auto begin = reinterpret_cast<std::uintptr_t>(memory);
  const std::uintptr_t first = (begin + smallPage - 1) / smallPage * smallPage;
  const std::uintptr_t end = (begin + size) / smallPage * smallPage;
  (void)madvise(reinterpret_cast<void*>(first), end - first, MADV_HUGEPAGE);
}
}

void* operator new(std::size_t size)
{
  for (;;)
  {
    if (void* const memory = std::malloc(size > 0 ? size : 1))
    {
      AdviseLargePages(memory, size);
      return memory;
    }
    const std::new_handler makeRoom = std::get_new_handler();
    if (makeRoom == nullptr)
    {
      throw std::bad_alloc();
    }
    makeRoom();
  }
}

void operator delete(void* memory) noexcept
{
  std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept
{
  std::free(memory);
}

#endif
