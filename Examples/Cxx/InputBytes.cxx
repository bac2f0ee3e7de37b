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
constexpr const char* gzipMark = "\x1f\x8b"; // that an archive begins with
constexpr std::size_t chunkSize = std::size_t(1) << 18;

/** What is left to read. Closes the descriptor. */
std::string ReadAll(int descriptor)
{
  std::string bytes;
  std::string chunk(chunkSize, '\0');
  ssize_t size = 0;
  do
  {
    size = read(descriptor, chunk.data(), chunk.size());
    bytes.append(chunk, 0, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  } while (size > 0 || (size < 0 && errno == EINTR));
  const int error = errno;
  close(descriptor);
  if (size < 0)
  {
    throw Failure(std::strerror(error));
  }
  return bytes;
}

/** The streams of a gzip archive, one after the other; what follows them does not count. */
std::string Inflated(const std::string& archive)
{
  z_stream stream = {};
  bool good = inflateInit2(&stream, 16 + MAX_WBITS) == Z_OK; // 16: gzip alone
  std::string bytes;
  std::string chunk(chunkSize, '\0');
  std::size_t taken = 0;
  bool ended = false;
  while (good && !(ended && archive.compare(taken, 2, gzipMark) != 0))
  {
    const std::size_t size = std::min(archive.size() - taken, chunkSize);
    good = size > 0 && (!ended || inflateReset(&stream) == Z_OK);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(archive.data() + taken));
    stream.avail_in = static_cast<uInt>(size);
    ended = false;
    while (good && !ended && (stream.avail_in > 0 || stream.avail_out == 0))
    {
      stream.next_out = reinterpret_cast<Bytef*>(chunk.data());
      stream.avail_out = static_cast<uInt>(chunk.size());
      const int status = inflate(&stream, Z_NO_FLUSH);
      bytes.append(chunk, 0, chunk.size() - stream.avail_out);
      ended = status == Z_STREAM_END;
      good = ended || status == Z_OK || status == Z_BUF_ERROR;
    }
    taken += size - stream.avail_in;
  }
  inflateEnd(&stream);
  if (!good)
  {
    throw Failure("the gzip archive is damaged or not complete");
  }
  return bytes;
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
  if (descriptor < 0)
  {
    throw Failure(std::strerror(errno));
  }
  std::string bytes = ReadAll(descriptor);
  if (bytes.compare(0, 2, gzipMark) == 0)
  {
    bytes = Inflated(bytes);
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

std::string WithoutExtension(const std::string& path)
{
  const std::string plain = WithoutGz(path);
  return plain.substr(0, plain.size() - LowerCaseExtension(path).size());
}
