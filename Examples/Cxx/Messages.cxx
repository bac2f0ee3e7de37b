#include "Messages.h"

#include "Failure.h"

#include <vtkLogger.h>
#include <vtkObjectFactory.h>

#include <algorithm>

vtkStandardNewMacro(Messages);

namespace
{
/**
 * VTK's message as a sentence in one line: without "ERROR: In File.cxx, line 1" and
 * "vtkClass (0x1234): " in front, without what is not plain text and what comes after the first
 * line.
 */
std::string Sentence(const char* message)
{
  std::string text = message == nullptr ? "" : message;
  for (const char* head : { "ERROR: In ", "Warning: In ", "Generic Warning: In " })
  {
    if (text.rfind(head, 0) == 0)
    {
      text.erase(0, text.find('\n') == std::string::npos ? 0 : text.find('\n') + 1);
    }
  }
  const std::size_t address = text.find("(0x");
  const std::size_t colon = text.find("): ");
  if (text.rfind("vtk", 0) == 0 && address < colon && colon != std::string::npos)
  {
    text.erase(0, colon + 3);
  }
  text.erase(0, text.find_first_not_of(" \t\r\n"));
  text.resize(std::min<std::size_t>(std::min(text.find_first_of("\r\n"), text.size()), 400));
  std::replace_if(
    text.begin(), text.end(), [](unsigned char c) { return c < 32 || c > 126; }, '?');
  text.erase(text.find_last_not_of(" .!") + 1);
  return text;
}
} // namespace

vtkSmartPointer<Messages> Messages::Install()
{
  auto messages = vtkSmartPointer<Messages>::New();
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(messages);
  return messages;
}

void Messages::ThrowIfError(const std::string& what)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  if (!this->Errors.empty())
  {
    const std::string sentence = what + ": " + this->Errors.front();
    this->Errors.clear();
    throw Failure(sentence);
  }
}

void Messages::ThrowIfWarning(const std::string& part, const std::string& what)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  for (const std::string& warning : this->Warnings)
  {
    if (warning.find(part) != std::string::npos)
    {
      throw Failure(what + ": " + warning);
    }
  }
}

std::vector<std::string> Messages::GetWarnings()
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  return this->Warnings;
}

void Messages::DisplayText(const char*) {}

void Messages::DisplayErrorText(const char* text)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  this->Errors.push_back(Sentence(text));
}

void Messages::DisplayWarningText(const char* text)
{
  std::lock_guard<std::mutex> lock(this->Mutex);
  this->Warnings.push_back(Sentence(text));
}

void Messages::DisplayGenericWarningText(const char* text)
{
  this->DisplayWarningText(text);
}

void Messages::DisplayDebugText(const char*) {}
