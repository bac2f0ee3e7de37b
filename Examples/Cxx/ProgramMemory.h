/**
 * How the program takes memory from the system, where its C library is glibc: large arrays on large
 * pages, if the system offers them (Linux: transparent huge pages by `madvise`). At a million
 * points that, and keeping what is freed, saves a tenth of a run or more.
 *
 * Large pages need no call: the operator new of the whole program, its libraries included, asks for
 * them. Other programs get the same with GLIBC_TUNABLES=glibc.malloc.hugetlb=1 in the environment.
 */
#ifndef ProgramMemory_h
#define ProgramMemory_h

#include <vtkCommand.h>

#include <string>

/**
 * Keeps memory that is freed for what comes next: large arrays come and go, and pages that are
 * got anew from the system and zeroed each time take up to a twentieth of a run. The largest go
 * back at once.
 */
void KeepFreedMemory();

/**
 * Gives back what is kept when an algorithm goes on to another phase, of which it tells in progress
 * events: what one phase has freed would add to what the next takes.
 */
class MemoryReturn : public vtkCommand
{
public:
  static MemoryReturn* New() { return new MemoryReturn; }
  vtkTypeMacro(MemoryReturn, vtkCommand);

  void Execute(vtkObject* caller, unsigned long event, void* callData) override;

protected:
  MemoryReturn() = default;
  ~MemoryReturn() override = default;

private:
  std::string Phase;
};

#endif
