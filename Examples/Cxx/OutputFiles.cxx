#include "OutputFiles.h"

#include "Failure.h"
#include "InputBytes.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
/** The name at the end of a chain of links, whether there is a file or not. */
fs::path FollowLinks(fs::path path)
{
  constexpr int maximumLinks = 40; // as Linux
  std::error_code error;
  for (int i = 0; i < maximumLinks && fs::is_symlink(path, error); ++i)
  {
    const fs::path next = fs::read_symlink(path, error);
    path = next.is_absolute() ? next : path.parent_path() / next;
  }
  return path;
}

/** Where `path` leads, and whether something that is not an ordinary file is in its way. */
fs::path ResolveTarget(const std::string& path)
{
  std::error_code error;
  fs::path target = FollowLinks(path);
  const fs::file_status status = fs::status(target, error);
  if (fs::is_directory(status))
  {
    throw Failure("cannot write '" + path + "': it is a directory");
  }
  if (fs::exists(status) && !fs::is_regular_file(status))
  {
    throw Failure("cannot write '" + path + "': it is not an ordinary file");
  }
  if (fs::exists(status) && access(path.c_str(), W_OK) != 0)
  {
    throw Failure("cannot write '" + path + "': " + std::strerror(errno));
  }
  if (fs::exists(status))
  {
    target = fs::canonical(target, error);
  }
  else
  {
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (!fs::is_directory(folder, error))
    {
      throw Failure("cannot write '" + path + "': there is no directory '" + folder.string() + "'");
    }
    target = fs::canonical(folder, error) / target.filename();
  }
  if (error)
  {
    throw Failure("cannot write '" + path + "': " + error.message());
  }
  return target;
}
void CopyToStandardOutput(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  std::remove(path.c_str());
  if (std::fwrite(bytes.data(), 1, bytes.size(), stdout) != bytes.size() ||
    std::fflush(stdout) != 0)
  {
    throw Failure(std::string("cannot write to standard output: ") + std::strerror(errno));
  }
}

/** What its Final is. */
constexpr const char* standardOutput = "-";
} // namespace

OutputFiles::~OutputFiles()
{
  for (const File& file : this->Files)
  {
    if (!this->Committed)
    {
      std::remove(file.Temporary.c_str());
    }
  }
}

void OutputFiles::Protect(const std::string& path)
{
  std::error_code error;
  const fs::path place = fs::canonical(path, error);
  if (!error)
  {
    this->Protected.push_back(place.string());
  }
}

std::size_t OutputFiles::AddStandardOutput()
{
  File file;
  file.Name = file.Final = standardOutput;
  file.Temporary =
    fs::temp_directory_path() / ("remesh_surface-" + std::to_string(getpid()) + ".partial");
  this->Announce(file);
  return this->Files.size() - 1;
}

std::size_t OutputFiles::Add(const std::string& path)
{
  File file;
  file.Name = path;
  file.Final = ResolveTarget(path).string();
  if (std::find(this->Protected.begin(), this->Protected.end(), file.Final) !=
    this->Protected.end())
  {
    throw Failure("'" + path + "' is an input, and would be overwritten", EXIT_USAGE);
  }
  // With its extension, which vtkPLYWriter would append.
  const std::string end = std::to_string(getpid()) + LowerCaseExtension(file.Final);
  file.Temporary = file.Final + ".partial-" + end;
  file.Aside = file.Final + ".earlier-" + end;
  std::error_code error;
  if (fs::exists(fs::symlink_status(file.Aside, error)))
  {
    throw Failure("cannot write '" + path + "': '" + file.Aside + "' is in the way");
  }
  this->Announce(file);
  return this->Files.size() - 1;
}

void OutputFiles::Announce(const File& file)
{
  for (const File& other : this->Files)
  {
    if (other.Final == file.Final)
    {
      throw Failure("'" + file.Name + "' is named for two outputs", EXIT_USAGE);
    }
  }
  const int descriptor = open(file.Temporary.c_str(), O_WRONLY | O_CREAT | O_EXCL, 0600);
  if (descriptor < 0)
  {
    throw Failure("cannot write '" + file.Name + "': " + std::strerror(errno));
  }
  close(descriptor);
  std::remove(file.Temporary.c_str());
  this->Files.push_back(file);
}

const std::string& OutputFiles::GetTemporaryName(std::size_t number) const
{
  return this->Files[number].Temporary;
}

/** Puts an older file aside, and the new one in its place. Throws Failure. */
void OutputFiles::Replace(File& file)
{
  if (file.Final == standardOutput)
  {
    return;
  }
  std::error_code error;
  const fs::file_status status = fs::symlink_status(file.Final, error);
  if (fs::exists(status) && !fs::is_regular_file(status)) // it has come there during the run
  {
    throw Failure("cannot write '" + file.Name + "': it is not an ordinary file");
  }
  // By a second name, where there can be one: then the user's name always leads to a whole file.
  file.Waits = fs::exists(status) &&
    (link(file.Final.c_str(), file.Aside.c_str()) == 0 ||
      std::rename(file.Final.c_str(), file.Aside.c_str()) == 0);
  file.Stands = (file.Waits || !fs::exists(status)) &&
    std::rename(file.Temporary.c_str(), file.Final.c_str()) == 0;
  if (!file.Stands)
  {
    throw Failure("cannot write '" + file.Name + "': " + std::strerror(errno));
  }
}

void OutputFiles::TakeBack()
{
  for (File& file : this->Files)
  {
    if (file.Waits)
    {
      std::rename(file.Aside.c_str(), file.Final.c_str());
      std::remove(file.Aside.c_str()); // two names of one file stay as they are
    }
    else if (file.Stands)
    {
      std::remove(file.Final.c_str());
    }
    file.Stands = file.Waits = false;
  }
}

void OutputFiles::Commit()
{
  try
  {
    for (File& file : this->Files)
    {
      Replace(file);
    }
    for (const File& file : this->Files)
    {
      if (file.Final == standardOutput)
      {
        CopyToStandardOutput(file.Temporary);
      }
    }
  }
  catch (...)
  {
    this->TakeBack();
    throw;
  }
  this->Committed = true;
  for (const File& file : this->Files)
  {
    if (file.Waits)
    {
      std::remove(file.Aside.c_str());
    }
  }
}

void WriteBytes(const std::string& path, const std::string& bytes)
{
  std::FILE* file = std::fopen(path.c_str(), "wb");
  bool good = file != nullptr;
  good = good && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  good = good && std::fflush(file) == 0;
  const std::string reason = good ? "" : std::strerror(errno);
  if (file != nullptr && std::fclose(file) != 0)
  {
    good = false;
  }
  if (!good)
  {
    throw Failure(reason.empty() ? "the disk is full" : reason);
  }
}
