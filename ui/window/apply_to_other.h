#pragma once

#include "ui/document/apply_service.h"

#include <QObject>
#include <QString>

class QWidget;

namespace pbffd::ui {

class Actions;
class Document;

/// File > Apply to another mesh: asks which, and deforms it off the UI thread. Without a service the action is
/// not there.
class ApplyToOther : public QObject {
  Q_OBJECT

 public:
  ApplyToOther(ApplyService service, Document& document, const Actions& actions, QWidget& window);

 private:
  void ask();
  void start(const ApplyService::Request& request);

  ApplyService service_;
  Document& document_;
  QWidget& window_;
  QString folder_;
};

}  // namespace pbffd::ui
