#pragma once

#include "ui/document/apply_service.h"

#include <QDialog>

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;

namespace pbffd::ui {

/// Asks which file to deform, how, and where to write it. `Apply` is grey until both are there, and a line says
/// why.
class ApplyDialog : public QDialog {
  Q_OBJECT

 public:
  /// folder: where the file choosers begin.
  ApplyDialog(const ApplyService& service, QString folder, QWidget* parent);

  ApplyService::Request request() const;
  /// Of the file that was chosen last.
  const QString& folder() const { return folder_; }

 private:
  void makeRows();
  void chooseSource();
  void chooseTarget();
  void suggestTarget();
  void showState();
  QString reasonAgainst() const;
  bool hasArrays() const;
  /// A name without a folder is one beside the source.
  QString targetPath() const;

  const ApplyService& service_;
  QString folder_;
  QLineEdit* source_;
  QLineEdit* target_;
  QCheckBox* align_;
  QLineEdit* arrays_;
  QLabel* reason_;
  QPushButton* apply_ = nullptr;
  bool isSuggested_ = true;  ///< the target is the program's own choice still
};

}  // namespace pbffd::ui
