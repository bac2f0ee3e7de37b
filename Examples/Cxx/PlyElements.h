/**
 * What a PLY file holds, whatever it means: elements, their properties, and the numbers of each.
 */
#ifndef PlyElements_h
#define PlyElements_h

#include <vtkType.h>

#include <string>
#include <vector>

struct PlyType
{
  int Size = 0; // bytes
  bool IsFloat = false;
  int VtkType = VTK_DOUBLE;
};

struct PlyProperty
{
  std::string Name;
  bool IsList = false;
  PlyType Length; // of a list
  PlyType Item;
  std::vector<double> Values;       // of all rows, one after the other
  std::vector<std::size_t> Offsets; // of a list: row i has the values from Offsets[i] on
};

struct PlyElement
{
  std::string Name;
  vtkIdType Count = 0;
  std::vector<PlyProperty> Properties;

  const PlyProperty* Find(const std::string& name) const; // null: there is none
};

/** Throws Failure. */
[[noreturn]] void MalformedPly(const std::string& what);

/** Throws Failure unless the file is well formed and has all that its header announces. */
std::vector<PlyElement> ReadPlyElements(const std::string& bytes);

#endif
