/**
 * @class   pqOutputViewWidget
 * @brief   A button of the panel that shows a table of the filter beside the active view.
 *
 * ParaView offers no eye for a table while a render view is active. The property's hint
 * `<OutputView port="3" view="XYChartView" bottom="Iteration" left="Energy" />` tells what to show
 * where, and the titles of a chart's axes, if any; its label is the button's.
 * A view that shows the table already is used again. The active view stays active.
 */
#ifndef pqOutputViewWidget_h
#define pqOutputViewWidget_h

#include "pqPropertyWidget.h"

#include <string>

class QPushButton;
class pqOutputPort;
class pqView;

class pqOutputViewWidget : public pqPropertyWidget
{
  Q_OBJECT
  typedef pqPropertyWidget Superclass;

public:
  pqOutputViewWidget(vtkSMProxy* proxy, vtkSMProperty* property, QWidget* parent = nullptr);
  ~pqOutputViewWidget() override;

private Q_SLOTS:
  void showOutput();
  /** There is nothing to show before the first Apply. */
  void enable();

private:
  Q_DISABLE_COPY(pqOutputViewWidget)

  pqOutputPort* port() const;
  /** The view of the hint's kind that has the output, or nullptr. */
  pqView* existingView() const;
  /** A new one, which splits the active view's place. */
  pqView* createView() const;

  QPushButton* Button;
  int Port = 0;
  std::string ViewType;
  std::string BottomTitle;
  std::string LeftTitle;
};

#endif
