#include "VtpWriter.h"

#include "Failure.h"
#include "ProgressBar.h"

#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <ostream>

namespace
{
/** A file that takes whatever is written to it, and tells in the end whether it has it. */
class PatientFile : private std::filebuf
{
public:
  explicit PatientFile(const std::string& path)
    : Stream(this)
  {
    errno = 0;
    this->Note(this->open(path, std::ios::out | std::ios::binary | std::ios::trunc) != nullptr);
  }

  std::ostream& GetStream() { return this->Stream; }

  /** Throws Failure if the file does not hold all that was written, where it was to be. */
  void Close()
  {
    this->Note(this->close() != nullptr);
    if (this->Failed || this->Stream.fail())
    {
      throw Failure(this->Reason != 0 ? std::strerror(this->Reason)
                                      : "the file is not complete, perhaps the disk is full");
    }
  }

protected:
  std::streamsize xsputn(const char* bytes, std::streamsize count) override
  {
    this->Note(std::filebuf::xsputn(bytes, count) == count);
    return count;
  }

  int_type overflow(int_type byte) override
  {
    this->Note(!traits_type::eq_int_type(std::filebuf::overflow(byte), traits_type::eof()));
    return traits_type::not_eof(byte);
  }

  int sync() override
  {
    this->Note(std::filebuf::sync() == 0);
    return 0;
  }

private:
  void Note(bool done)
  {
    if (!done && !this->Failed)
    {
      this->Failed = true;
      this->Reason = errno;
    }
    errno = 0;
  }

  bool Failed = false;
  int Reason = 0; ///< the number of the first error, if the system told one
  std::ostream Stream;
};

/** Writes to a stream instead of to a file that it opens. */
class XMLStreamWriter : public vtkXMLPolyDataWriter
{
public:
  static XMLStreamWriter* New();
  vtkTypeMacro(XMLStreamWriter, vtkXMLPolyDataWriter);

  void SetStream(std::ostream& stream) { this->Stream = &stream; }
};
vtkStandardNewMacro(XMLStreamWriter);
} // namespace

void WriteVtp(vtkPolyData* surface, const std::string& path, ProgressBar* progress)
{
  PatientFile file(path);
  vtkNew<XMLStreamWriter> writer;
  writer->SetInputData(surface);
  writer->SetStream(file.GetStream());
  writer->SetDataModeToBinary();
  writer->SetHeaderTypeToUInt64();
  writer->SetCompressorTypeToLZ4(); // zlib takes five times as long to save a fifth of the bytes
  progress->SetPhase("Writing");
  writer->AddObserver(vtkCommand::ProgressEvent, progress);
  writer->Update();
  file.Close();
  if (writer->GetErrorCode() != 0)
  {
    throw Failure(vtkErrorCode::GetStringFromErrorCode(writer->GetErrorCode()));
  }
}
