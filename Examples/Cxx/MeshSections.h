/**
 * The sections of .mesh, .meshb, .sol and .solb files (of Medit, mmg, refine and others), one after
 * the other: as text, or as binary files of versions 1 to 4 in either order of bytes.
 *
 * Own code: VTK has no reader, and Debian no library. A binary file is the number 1 and the
 * version, then sections: a code, where the next one is, and the data. Whole numbers and places
 * have 4 bytes, numbers 8. Of version 1, numbers have 4; from version 3 on, places have 8; in
 * version 4 whole numbers have 8, too. (L. Marechal, The LibMeshb library, Inria.)
 */
#ifndef MeshSections_h
#define MeshSections_h

#include <memory>
#include <string>

class MeshSections
{
public:
  MeshSections() = default;
  MeshSections(const MeshSections&) = delete;
  MeshSections& operator=(const MeshSections&) = delete;
  virtual ~MeshSections() = default;

  /**
   * Goes on to the next section, whatever is left of this one; its name, "" at the end. Sections
   * that nobody here reads may have any other name.
   */
  virtual std::string Next() = 0;

  /** The next finite number. `what` it is, for the sentence of the Failure where there is none. */
  virtual double Number(const char* what) = 0;

  /** The next whole number. Throws Failure unless it is from `least` to `most`. */
  virtual long long Integer(long long least, long long most, const char* what) = 0;

  /** The same for numbers that version 4 keeps in 4 bytes: dimensions, and types of solutions. */
  virtual long long ShortInteger(long long least, long long most, const char* what) = 0;

  /** How many there are of something that takes a byte at least: not more than the file has. */
  long long Count(const char* what) { return this->Integer(0, this->Size(), what); }

  /** Of the file, in bytes. */
  virtual long long Size() const = 0;
};

/**
 * `extension` tells what the file is; `bytes` have to outlive what is returned. Throws Failure
 * unless they begin as such a file.
 */
std::unique_ptr<MeshSections> OpenMeshSections(
  const std::string& bytes, const std::string& extension);

/** Whether they begin as a binary file, whatever its version. */
bool IsBinaryMesh(const std::string& bytes);

/** The code of a section in binary files; 0: no section that is read or written here. */
int SectionCode(const std::string& name);

#endif
