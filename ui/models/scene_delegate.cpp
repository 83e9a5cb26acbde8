#include "ui/models/scene_delegate.h"

#include "ui/document/icons.h"
#include "ui/document/theme.h"
#include "ui/models/scene_model.h"

#include <QLineEdit>
#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QTreeView>

#include <algorithm>

namespace pbffd::ui {
namespace {

constexpr double iconSize = 16.0;
constexpr double checkSize = 14.0;

QRectF centered(const QRect& cell, double size) {
  return {cell.center().x() + 0.5 - size / 2, cell.center().y() + 0.5 - size / 2, size, size};
}

struct Symbol {
  QString icon;
  QString token;
};

Symbol symbolOf(const QModelIndex& index) {
  switch (static_cast<SceneModel::Row>(index.data(SceneModel::rowRole).toInt())) {
    case SceneModel::Row::mesh:
      return {"mesh", "text.2"};
    case SceneModel::Row::controls:
      return {"controls", "text.2"};
    case SceneModel::Row::level:
      return {};
    default:
      break;
  }
  const auto kind = static_cast<PointKind>(index.data(SceneModel::kindRole).toInt());
  const bool dim = index.data(SceneModel::isDimRole).toBool();
  return {kindIcon(kind), dim ? "disabled" : kindToken(kind)};
}

}  // namespace

SceneDelegate::SceneDelegate(const Theme& theme, QObject* parent)
    : QStyledItemDelegate(parent), theme_(theme) {}

QSize SceneDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const {
  return {40, rowHeight};
}

void SceneDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const {
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  switch (index.column()) {
    case SceneModel::nameColumn:
      paintName(*painter, option, index);
      break;
    case SceneModel::countColumn:
      painter->setPen(theme_.color("text.3"));
      painter->drawText(option.rect.adjusted(0, 0, -6, 0), Qt::AlignRight | Qt::AlignVCenter,
                        index.data().toString());
      break;
    default:
      paintCheck(*painter, option.rect, index);
  }
  painter->restore();
}

void SceneDelegate::paintName(QPainter& painter, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const {
  QRect rest = option.rect.adjusted(2, 0, -4, 0);
  // What a count does not need of its column is lent to the name.
  if (const auto* view = qobject_cast<const QTreeView*>(option.widget)) {
    const QString count = index.siblingAtColumn(SceneModel::countColumn).data().toString();
    const int needed = count.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(count) + 10;
    rest.setRight(rest.right() + std::max(0, view->columnWidth(SceneModel::countColumn) - needed));
  }
  if (const Symbol symbol = symbolOf(index); !symbol.icon.isEmpty()) {
    const bool isGlyph = symbol.icon.startsWith("kind-");
    const QRect cell(rest.left(), rest.top(), 16, rest.height());
    drawIcon(painter, centered(cell, isGlyph ? 14.0 : iconSize), symbol.icon, theme_.color(symbol.token));
    rest.setLeft(rest.left() + 22);
  }
  const QString detail = index.data(SceneModel::detailRole).toString();
  const int detailWidth = detail.isEmpty() ? 0 : option.fontMetrics.horizontalAdvance(detail) + 6;
  const QString name =
      option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, rest.width() - detailWidth);
  painter.setPen(theme_.color(index.data(SceneModel::isDimRole).toBool() ? "disabled" : "text"));
  painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter, name);
  if (detailWidth > 0) {
    rest.setLeft(rest.left() + option.fontMetrics.horizontalAdvance(name) + 6);
    painter.setPen(theme_.color("text.3"));
    painter.drawText(rest, Qt::AlignLeft | Qt::AlignVCenter, detail);
  }
}

void SceneDelegate::paintCheck(QPainter& painter, const QRect& cell, const QModelIndex& index) const {
  const QVariant state = index.data(Qt::CheckStateRole);
  if (!state.isValid()) {
    return;
  }
  const bool on = state.toInt() == Qt::Checked;
  if (index.column() == SceneModel::eyeColumn) {
    return drawIcon(painter, centered(cell, checkSize), on ? "eye" : "eye-off",
                    theme_.color(on ? "text.2" : "text.3"));
  }
  if (index.column() == SceneModel::lockColumn) {
    return drawIcon(painter, centered(cell, checkSize), on ? "lock" : "unlock",
                    theme_.color(on ? "text" : "disabled"));
  }
  const QRectF box = centered(cell, checkSize).adjusted(0.5, 0.5, -0.5, -0.5);
  painter.setPen(theme_.color(on ? "accent" : "field.line"));
  painter.setBrush(theme_.color(on ? "accent" : "field"));
  painter.drawRoundedRect(box, 3.5, 3.5);
  if (on) {
    painter.setPen(QPen(theme_.color("accent.text"), 1.8, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    QPainterPath tick(box.topLeft() + QPointF(3.2, 6.8));
    tick.lineTo(box.topLeft() + QPointF(5.6, 9.2));
    tick.lineTo(box.topLeft() + QPointF(9.9, 4.2));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(tick);
  }
}

bool SceneDelegate::editorEvent(QEvent* event, QAbstractItemModel* model, const QStyleOptionViewItem& option,
                                const QModelIndex& index) {
  if (index.column() < SceneModel::eyeColumn || event->type() != QEvent::MouseButtonRelease) {
    return QStyledItemDelegate::editorEvent(event, model, option, index);
  }
  const auto* mouse = static_cast<QMouseEvent*>(event);
  const QVariant state = index.data(Qt::CheckStateRole);
  if (mouse->button() != Qt::LeftButton || !option.rect.contains(mouse->position().toPoint()) ||
      !state.isValid()) {
    return false;
  }
  return model->setData(index, state.toInt() == Qt::Checked ? Qt::Unchecked : Qt::Checked, Qt::CheckStateRole);
}

void SceneDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex&) const {
  editor->setGeometry(option.rect.adjusted(22, 1, -2, -1));
}

}  // namespace pbffd::ui
