/**
 * Collects what VTK's readers, filters, writers and their executives complain about, instead of
 * having it printed.
 */
#ifndef Messages_h
#define Messages_h

#include <vtkOutputWindow.h>
#include <vtkSmartPointer.h>

#include <mutex>
#include <string>
#include <vector>

class Messages : public vtkOutputWindow
{
public:
  static Messages* New();
  vtkTypeMacro(Messages, vtkOutputWindow);

  /** From now on the returned object gets VTK's messages, and nothing is printed. */
  static vtkSmartPointer<Messages> Install();

  /**
   * Throws Failure with `what`, a colon and the first error since the last call, if there is one.
   */
  void ThrowIfError(const std::string& what);

  /** Does what ThrowIfError does for a warning that contains `part`. */
  void ThrowIfWarning(const std::string& part, const std::string& what);

  std::vector<std::string> GetWarnings();

  void DisplayText(const char* text) override;
  void DisplayErrorText(const char* text) override;
  void DisplayWarningText(const char* text) override;
  void DisplayGenericWarningText(const char* text) override;
  void DisplayDebugText(const char* text) override;

protected:
  Messages() = default;
  ~Messages() override = default;

private:
  Messages(const Messages&) = delete;
  void operator=(const Messages&) = delete;

  std::mutex Mutex; // messages may come from any thread
  std::vector<std::string> Errors;
  std::vector<std::string> Warnings;
};

#endif
