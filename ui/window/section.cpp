#include "ui/window/section.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/window/labels.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

namespace pbffd::ui {
namespace {

constexpr int labelWidth = 70;

}  // namespace

Section::Section(const Theme& theme, const QString& title, QWidget* parent)
    : QFrame(parent),
      heading_(new QPushButton(title)),
      headingRow_(new QHBoxLayout),
      content_(new QWidget),
      body_(new QVBoxLayout(content_)),
      theme_(theme) {
  setProperty("role", "section");
  heading_->setProperty("role", "fold");
  heading_->setCheckable(true);
  heading_->setIconSize({14, 14});
  headingRow_->addWidget(heading_);
  headingRow_->addStretch();
  headingRow_->setContentsMargins(0, 0, 0, 0);
  body_->setContentsMargins(0, 4, 0, 2);
  body_->setSpacing(6);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 10);
  column->setSpacing(2);
  column->addLayout(headingRow_);
  column->addWidget(content_);
  connect(heading_, &QPushButton::toggled, this, &Section::setFolded);
  setFolded(false);
}

void Section::addToHeading(QWidget* widget) {
  headingRow_->addWidget(widget);
}

void Section::setFolded(bool folded) {
  heading_->setChecked(folded);
  heading_->setIcon(makeIcon(theme_, folded ? "chevron-right" : "chevron-down", {"text.3", "text.3"}));
  content_->setVisible(!folded);
}

QHBoxLayout* labelledRow(const QString& label, const QList<QWidget*>& fields) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  QLabel* name = makeLabel(label, "label");
  name->setFixedWidth(labelWidth);
  row->addWidget(name);
  for (QWidget* field : fields) {
    row->addWidget(field);
  }
  return row;
}

}  // namespace pbffd::ui
