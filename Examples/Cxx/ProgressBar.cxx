#include "ProgressBar.h"

#include "Interruption.h"

#include <vtkAlgorithm.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

void ProgressBar::SetVisible(bool visible)
{
  this->Visible = visible && isatty(STDERR_FILENO) != 0;
}

void ProgressBar::Execute(vtkObject* caller, unsigned long event, void* callData)
{
  auto* algorithm = vtkAlgorithm::SafeDownCast(caller);
  if (event != vtkCommand::ProgressEvent || algorithm == nullptr)
  {
    return;
  }
  if (Interrupted())
  {
    algorithm->SetAbortExecute(1);
  }
  const auto now = std::chrono::steady_clock::now();
  if (this->Visible && now - this->LastDrawing > std::chrono::milliseconds(100))
  {
    this->LastDrawing = now;
    const char* text = algorithm->GetProgressText();
    const double* fraction = static_cast<const double*>(callData);
    this->Draw(text != nullptr ? text : this->Phase, fraction != nullptr ? *fraction : 0.0);
  }
}

void ProgressBar::Draw(const std::string& text, double fraction)
{
  constexpr int width = 32;
  const double clamped = std::clamp(fraction, 0.0, 1.0);
  const int full = static_cast<int>(clamped * width);
  const std::string bar = std::string(full, '#') + std::string(width - full, '.');
  // Carriage return in front, "erase to the end of the line" behind.
  std::fprintf(stderr, "\r[%s] %3d %% %.40s\033[K", bar.c_str(), static_cast<int>(100 * clamped),
    text.c_str());
  std::fflush(stderr);
  this->Drawn = true;
}

void ProgressBar::Clear()
{
  if (this->Drawn)
  {
    std::fputs("\r\033[K", stderr);
    std::fflush(stderr);
    this->Drawn = false;
  }
}
