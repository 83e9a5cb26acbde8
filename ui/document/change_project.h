#pragma once

#include "core/project/edit.h"

#include <QDateTime>
#include <QUndoCommand>

namespace pbffd::ui {

class Document;

/// The one undo command: it swaps whole project values, so it can neither fail nor drift. The work was done
/// before it was made.
class ChangeProject : public QUndoCommand {
 public:
  struct Step {
    Project before;
    Project after;
    Edit edit;
    int mergeKey = 0;
  };

  ChangeProject(Document& document, Step step);

  void undo() override;
  void redo() override;
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* newer) override;

  const QDateTime& time() const { return time_; }
  const Edit& edit() const { return step_.edit; }
  /// One line, as in the files that `pbffd edit` reads.
  QString editJson() const;

 private:
  Document& document_;
  Step step_;
  QDateTime time_ = QDateTime::currentDateTime();
  bool isFirstTime_ = true;
};

}  // namespace pbffd::ui
