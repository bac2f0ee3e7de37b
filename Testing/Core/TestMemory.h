/**
 * @file TestMemory.h
 * @brief Memory that runs out when a test says so. For one file of an executable: it replaces the
 *        operators that allocate.
 */
#ifndef remesh_TestMemory_h
#define remesh_TestMemory_h

#include <cstdlib>
#include <limits>
#include <new>

namespace remesh::test
{
constexpr long noShortage = std::numeric_limits<long>::max();

/** So often more can this thread allocate. */
inline thread_local long allocationsLeft = noShortage;
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
  long& left = remesh::test::allocationsLeft;
  void* memory = left > 0 ? std::malloc(size > 0 ? size : 1) : nullptr;
  left -= left > 0 && left < remesh::test::noShortage ? 1 : 0;
  return memory;
}

void* operator new(std::size_t size)
{
  void* memory = operator new(size, std::nothrow);
  if (!memory)
  {
    throw std::bad_alloc();
  }
  return memory;
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
