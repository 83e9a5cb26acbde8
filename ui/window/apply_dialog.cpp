#include "ui/window/apply_dialog.h"

#include "ui/window/labels.h"

#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>

#include <utility>

namespace pbffd::ui {
namespace {

constexpr int leastWidth = 560;

std::filesystem::path pathOf(const QString& path) {
  return std::filesystem::path(path.toStdU16String());
}

/// "*.obj *.vtu" of ".obj, .off and .vtu".
QString patternsOf(const std::string& endings) {
  QStringList patterns;
  for (const QString& word : QString::fromStdString(endings).split(QRegularExpression("[ ,]+"))) {
    if (word.startsWith(u'.')) {
      patterns += "*" + word;
    }
  }
  return patterns.join(u' ');
}

}  // namespace

ApplyDialog::ApplyDialog(const ApplyService& service, QString folder, QWidget* parent)
    : QDialog(parent),
      service_(service),
      folder_(std::move(folder)),
      source_(new QLineEdit),
      target_(new QLineEdit),
      align_(new QCheckBox(tr("&Fit its place, size and turn to the project's mesh first"))),
      arrays_(new QLineEdit),
      reason_(makeLabel({}, "quiet")) {
  setWindowTitle(tr("Apply to another mesh"));
  setObjectName("applyDialog");
  setMinimumWidth(leastWidth);
  makeRows();
  connect(source_, &QLineEdit::textChanged, this, [this] {
    suggestTarget();
    showState();
  });
  connect(target_, &QLineEdit::textChanged, this, &ApplyDialog::showState);
  connect(target_, &QLineEdit::textEdited, this, [this] { isSuggested_ = false; });
  showState();
}

void ApplyDialog::makeRows() {
  source_->setObjectName("source");
  target_->setObjectName("target");
  align_->setObjectName("align");
  arrays_->setObjectName("arrays");
  arrays_->setPlaceholderText(tr("none"));
  arrays_->setToolTip(
      tr("Arrays of vectors or normals that turn with the deformation, parted by commas: velocity, "
         "Normals:normal"));
  reason_->setObjectName("reason");
  reason_->setWordWrap(true);
  const auto withButton = [this](QLineEdit* field, const QString& name, auto choose) {
    auto* row = new QHBoxLayout;
    auto* button = new QPushButton(tr("Choose..."));
    button->setAccessibleName(tr("Choose: %1").arg(name));
    button->setAutoDefault(false);
    connect(button, &QPushButton::clicked, this, choose);
    field->setAccessibleName(name);
    row->addWidget(field);
    row->addWidget(button);
    return row;
  };
  auto* form = new QFormLayout;
  form->addRow(tr("&Mesh or data set"),
               withButton(source_, tr("Mesh or data set"), &ApplyDialog::chooseSource));
  form->addRow(tr("&Write to"), withButton(target_, tr("Write to"), &ApplyDialog::chooseTarget));
  form->addRow(tr("&Turn arrays along"), arrays_);
  form->addRow(QString(), align_);
  qobject_cast<QLabel*>(form->itemAt(0, QFormLayout::LabelRole)->widget())->setBuddy(source_);
  qobject_cast<QLabel*>(form->itemAt(1, QFormLayout::LabelRole)->widget())->setBuddy(target_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
  apply_ = buttons->addButton(tr("Apply"), QDialogButtonBox::AcceptRole);
  apply_->setDefault(true);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  auto* column = new QVBoxLayout(this);
  column->addLayout(form);
  column->addWidget(reason_);
  column->addWidget(buttons);
}

ApplyService::Request ApplyDialog::request() const {
  ApplyService::Request request{pathOf(source_->text()), pathOf(targetPath()), align_->isChecked(), {}};
  for (const QString& name : hasArrays() ? arrays_->text().split(u',') : QStringList()) {
    if (!name.trimmed().isEmpty()) {
      request.transports.push_back(name.trimmed().toStdString());
    }
  }
  return request;
}

void ApplyDialog::chooseSource() {
  const QString path = QFileDialog::getOpenFileName(
      this, tr("Mesh or data set"), folder_,
      tr("Meshes and data sets (%1);;All files (*)").arg(patternsOf(service_.endings)));
  if (!path.isEmpty()) {
    folder_ = QFileInfo(path).absolutePath();
    source_->setText(path);
  }
}

void ApplyDialog::chooseTarget() {
  const QString ending = QFileInfo(source_->text()).suffix();
  const QString path = QFileDialog::getSaveFileName(
      this, tr("Write to"), target_->text(),
      ending.isEmpty() ? tr("All files (*)") : QString("*.%1;;%2").arg(ending, tr("All files (*)")));
  if (!path.isEmpty()) {
    isSuggested_ = false;
    target_->setText(path);
  }
}

void ApplyDialog::suggestTarget() {
  if (!isSuggested_) {
    return;
  }
  const QFileInfo source(source_->text());
  if (source.fileName().isEmpty()) {
    return target_->clear();
  }
  const QString beginning = source.absolutePath() + u'/' + source.completeBaseName() + "-deformed";
  QString name = beginning;
  for (int number = 2; QFileInfo::exists(name + u'.' + source.suffix()); ++number) {
    name = QString("%1-%2").arg(beginning).arg(number);
  }
  target_->setText(name + u'.' + source.suffix());
}

QString ApplyDialog::targetPath() const {
  return target_->text().isEmpty() ? QString()
                                   : QFileInfo(source_->text()).absoluteDir().absoluteFilePath(target_->text());
}

bool ApplyDialog::hasArrays() const {
  return service_.hasArrays && service_.hasArrays(pathOf(source_->text()));
}

void ApplyDialog::showState() {
  const QString reason = reasonAgainst();
  const QFileInfo target(targetPath());
  const bool replaces = reason.isEmpty() && target.exists();
  reason_->setText(replaces ? tr("%1 is there already and will be replaced.").arg(target.fileName()) : reason);
  apply_->setText(replaces ? tr("Replace") : tr("Apply"));
  apply_->setEnabled(reason.isEmpty());
  arrays_->setEnabled(hasArrays());
}

QString ApplyDialog::reasonAgainst() const {
  const QFileInfo source(source_->text());
  if (source_->text().isEmpty()) {
    return tr("Choose the file that is to be deformed: %1.").arg(QString::fromStdString(service_.endings));
  }
  if (!source.isFile()) {
    return tr("%1 is not there.").arg(source.fileName());
  }
  if (!service_.knows(pathOf(source_->text()))) {
    return tr("%1 is of no kind that can be deformed: %2.")
        .arg(source.fileName(), QString::fromStdString(service_.endings));
  }
  if (target_->text().isEmpty()) {
    return tr("Name the file to write.");
  }
  if (!service_.fits(pathOf(source_->text()), pathOf(targetPath()))) {
    return tr("%1 keeps its format: let the file to write end in .%2.").arg(source.fileName(), source.suffix());
  }
  return {};
}

}  // namespace pbffd::ui
