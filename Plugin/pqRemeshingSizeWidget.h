/**
 * @class   pqRemeshingSizeWidget
 * @brief   The panel's choice between a number of points and a distance tolerance.
 *
 * The filter has no property for the choice: a DistanceTolerance above 0 counts instead of
 * NumberOfPoints. So scripts set either one, and this widget derives the choice from the
 * tolerance. Choosing the number of points writes the tolerance 0; choosing the tolerance writes
 * the last one above 0, or a usual one. Fields of what is not chosen are hidden.
 *
 * The property group names the properties by function: NumberOfPoints, DistanceTolerance,
 * DistanceToleranceIsAbsolute and, shown among the advanced properties, MaximumNumberOfPoints.
 * The fields' object names are the functions.
 */
#ifndef pqRemeshingSizeWidget_h
#define pqRemeshingSizeWidget_h

#include "pqPropertyGroupWidget.h"

#include <QString>

class QComboBox;
class QGridLayout;
class QLabel;
class QRadioButton;
class pqDoubleLineEdit;
class pqLineEdit;

class pqRemeshingSizeWidget : public pqPropertyGroupWidget
{
  Q_OBJECT
  Q_PROPERTY(QString distanceTolerance READ distanceTolerance WRITE setDistanceTolerance NOTIFY
      distanceToleranceChanged)
  typedef pqPropertyGroupWidget Superclass;

public:
  pqRemeshingSizeWidget(vtkSMProxy* proxy, vtkSMPropertyGroup* group, QWidget* parent = nullptr);
  ~pqRemeshingSizeWidget() override;

  void updateWidget(bool showingAdvancedProperties) override;

  /** The property's value: "0" if the number of points is chosen. */
  QString distanceTolerance() const;

public Q_SLOTS:
  /** Chooses the tolerance if it is above 0, else the number of points. */
  void setDistanceTolerance(const QString& tolerance);

Q_SIGNALS:
  void distanceToleranceChanged();

private Q_SLOTS:
  /** Shows the fields of the choice, and hides the others. */
  void showChosen();
  /** Puts back the last tolerance above 0 where the field has none. */
  void restoreTolerance();

private:
  Q_DISABLE_COPY(pqRemeshingSizeWidget)

  void addNumberOfPoints(QGridLayout* grid);
  void addDistanceTolerance(QGridLayout* grid);
  void addMaximumNumberOfPoints(QGridLayout* grid);
  void setToolTipOf(QWidget* widget, const char* function);

  QRadioButton* ChooseNumber;
  QRadioButton* ChooseTolerance;
  pqLineEdit* Number;
  pqDoubleLineEdit* Tolerance;
  QComboBox* Unit;
  QLabel* MaximumLabel;
  pqLineEdit* Maximum;
  QString LastTolerance;
  bool ShowingAdvanced = false;
};

#endif
