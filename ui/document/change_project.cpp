#include "ui/document/change_project.h"

#include "core/project/edit_json.h"
#include "ui/document/document.h"

#include <utility>

namespace pbffd::ui {

ChangeProject::ChangeProject(Document& document, Step step) : document_(document), step_(std::move(step)) {
  setText(QString::fromStdString(describe(step_.before, step_.edit)));
}

void ChangeProject::undo() {
  document_.setCommitted(step_.before);
  document_.edited_ = editedPoints(step_.edit, step_.after, step_.before);
}

void ChangeProject::redo() {
  document_.setCommitted(step_.after);
  if (!std::exchange(isFirstTime_, false)) {
    document_.edited_ = editedPoints(step_.edit, step_.before, step_.after);
  }
}

bool ChangeProject::mergeWith(const QUndoCommand* newer) {
  const auto* next = dynamic_cast<const ChangeProject*>(newer);
  if (next == nullptr || step_.mergeKey == 0 || next->step_.mergeKey != step_.mergeKey) {
    return false;
  }
  // A placement replaces the one before it; all other edits of a run follow each other.
  if (std::holds_alternative<Place>(next->step_.edit)) {
    step_.edit = next->step_.edit;
  } else {
    Group run;
    if (const auto* group = std::get_if<Group>(&step_.edit.value()); group != nullptr) {
      run = *group;
    } else {
      run.text = text().toStdString();
      run.edits.push_back(step_.edit);
    }
    run.edits.push_back(next->step_.edit);
    step_.edit = run;
  }
  step_.after = next->step_.after;
  time_ = next->time_;
  setText(QString::fromStdString(describe(step_.before, step_.edit)));
  return true;
}

QString ChangeProject::editJson() const {
  return QString::fromStdString(toJson(step_.edit));
}

}  // namespace pbffd::ui
