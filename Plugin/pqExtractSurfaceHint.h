/**
 * @class   pqExtractSurfaceHint
 * @brief   Tells, where the menu's entries are grey, that Extract Surface helps.
 *
 * ParaView's status bar lists five data types then, of which it has room for two. Its XML has no
 * word for anything else. So what it says of inputs of just these types is replaced on its way.
 */
#ifndef pqExtractSurfaceHint_h
#define pqExtractSurfaceHint_h

#include <QObject>
#include <QString>

class pqExtractSurfaceHint : public QObject
{
  Q_OBJECT
  typedef QObject Superclass;

public:
  pqExtractSurfaceHint() = default;
  ~pqExtractSurfaceHint() override = default;

  void startup();
  void shutdown();

protected:
  bool eventFilter(QObject* receiver, QEvent* event) override;

private:
  Q_DISABLE_COPY(pqExtractSurfaceHint)

  /** ParaView's own words for what the filters take; "" without a server. */
  static QString domainDescription();
};

#endif
