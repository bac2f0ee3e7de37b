/**
 * Shows the progress of an algorithm on the terminal, and aborts it when the program is
 * interrupted.
 */
#ifndef ProgressBar_h
#define ProgressBar_h

#include <vtkCommand.h>

#include <chrono>
#include <string>

class vtkAlgorithm;

class ProgressBar : public vtkCommand
{
public:
  static ProgressBar* New() { return new ProgressBar; }
  vtkTypeMacro(ProgressBar, vtkCommand);

  /** Draws only if `visible` and standard error is a terminal. */
  void SetVisible(bool visible);

  /** The text to show for algorithms that have none of their own. */
  void SetPhase(const std::string& phase) { this->Phase = phase; }

  /** Takes the bar off the screen. */
  void Clear();

  void Execute(vtkObject* caller, unsigned long event, void* callData) override;

protected:
  ProgressBar() = default;
  ~ProgressBar() override = default;

private:
  void Draw(const std::string& text, double fraction);

  bool Visible = false;
  bool Drawn = false;
  std::string Phase;
  std::chrono::steady_clock::time_point LastDrawing;
};

#endif
