/**
 * All files of a run, or none: each is written under a temporary name beside its own, and they
 * get their names together when all are complete.
 */
#ifndef OutputFiles_h
#define OutputFiles_h

#include <string>
#include <vector>

class OutputFiles
{
public:
  OutputFiles() = default;
  OutputFiles(const OutputFiles&) = delete;
  OutputFiles& operator=(const OutputFiles&) = delete;

  /** Removes what was written but not committed. */
  ~OutputFiles();

  /** A file that is read: no output may take its place. */
  void Protect(const std::string& path);

  /**
   * Announces a file and tries whether it can be written; to be called before the long run.
   * Links are followed. Throws Failure for a folder, a device, a missing or read-only folder, or a
   * file announced or protected before. Returns the number of the file.
   */
  std::size_t Add(const std::string& path);

  /** The same for standard output, which gets its bytes when all files are complete. */
  std::size_t AddStandardOutput();

  /** The name to write file `number` under. */
  const std::string& GetTemporaryName(std::size_t number) const;

  /**
   * Gives all files their names, replacing older ones. Throws Failure, and then none is left, and
   * older ones are as they were.
   */
  void Commit();

private:
  struct File
  {
    std::string Name; // as the user wrote it
    std::string Final;
    std::string Temporary;
    std::string Aside;   // where an older file waits until all new ones have their names
    bool Waits = false;  // whether there is one
    bool Stands = false; // whether the new file has its name
  };
  void Announce(const File& file);
  static void Replace(File& file);
  void TakeBack();
  std::vector<File> Files;
  std::vector<std::string> Protected;
  bool Committed = false;
};

/** Writes the bytes and makes sure that they fit. Throws Failure. */
void WriteBytes(const std::string& path, const std::string& bytes);

#endif
