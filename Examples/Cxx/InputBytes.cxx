#include "InputBytes.h"

#include "Failure.h"
#include "TextLines.h"

#include <vtk_zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

namespace fs = std::filesystem;

namespace
{
[[noreturn]] void GiveUp(int status)
{
  throw Failure(
    status == Z_ERRNO ? std::strerror(errno) : "the gzip archive is damaged or not complete");
}
} // namespace

std::string ReadBytes(const std::string& path)
{
  std::error_code error;
  if (fs::is_directory(path, error))
  {
    throw Failure("it is a directory");
  }
  const int descriptor = path == "-" ? dup(STDIN_FILENO) : open(path.c_str(), O_RDONLY | O_CLOEXEC);
  gzFile file = descriptor < 0 ? nullptr : gzdopen(descriptor, "rb"); // or what is no archive
  if (file == nullptr)
  {
    throw Failure(std::strerror(errno));
  }
  std::string bytes;
  std::string chunk(1 << 18, '\0');
  int size = 0;
  while ((size = gzread(file, chunk.data(), static_cast<unsigned>(chunk.size()))) > 0)
  {
    bytes.append(chunk, 0, static_cast<std::size_t>(size));
  }
  int status = Z_OK;
  gzerror(file, &status);
  const int closing = gzclose(file);
  // Some releases of zlib read nothing of a damaged archive, and tell by the status alone.
  if (status != Z_OK || closing != Z_OK)
  {
    GiveUp(status != Z_OK ? status : closing);
  }
  if (bytes.empty())
  {
    throw Failure("it is empty");
  }
  return bytes;
}

void CompressFile(const std::string& path)
{
  const std::string bytes = ReadBytes(path);
  gzFile file = gzopen(path.c_str(), "wb");
  if (file == nullptr)
  {
    throw Failure(std::strerror(errno));
  }
  bool good = true;
  for (std::size_t start = 0; good && start < bytes.size(); start += 1U << 20U)
  {
    const auto size = static_cast<unsigned>(std::min<std::size_t>(bytes.size() - start, 1U << 20U));
    good = gzwrite(file, bytes.data() + start, size) == static_cast<int>(size);
  }
  const int closing = gzclose(file);
  if (!good || closing != Z_OK)
  {
    throw Failure(errno != 0 ? std::strerror(errno) : "the disk is full");
  }
}

std::string WithoutGz(const std::string& path)
{
  const bool compressed = LowerCase(fs::path(path).extension().string()) == ".gz";
  return compressed ? path.substr(0, path.size() - 3) : path;
}

std::string LowerCaseExtension(const std::string& path)
{
  return LowerCase(fs::path(WithoutGz(path)).extension().string());
}
