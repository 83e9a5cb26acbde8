#include "ui/document/icons.h"

#include "ui/document/theme.h"

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

namespace pbffd::ui {
namespace {

/// The drawing in one colour at a size in device pixels.
QPixmap rendered(const QString& name, const QColor& color, const QSize& size) {
  const QString key =
      QString("pbffd/%1/%2/%3x%4").arg(name).arg(color.rgba(), 0, 16).arg(size.width()).arg(size.height());
  QPixmap pixmap;
  if (QPixmapCache::find(key, &pixmap)) {
    return pixmap;
  }
  QFile file(QString(":/icons/%1.svg").arg(name));
  if (!file.open(QIODevice::ReadOnly)) {
    return {};
  }
  QByteArray drawing = file.readAll();
  drawing.replace("currentColor", color.name().toLatin1());
  pixmap = QPixmap(size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  painter.setOpacity(color.alphaF());
  QSvgRenderer(drawing).render(&painter);
  painter.end();
  QPixmapCache::insert(key, pixmap);
  return pixmap;
}

class ThemedEngine : public QIconEngine {
 public:
  ThemedEngine(const Theme& theme, QString name, IconColors colors)
      : theme_(theme), name_(std::move(name)), colors_(std::move(colors)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State state) override {
    drawIcon(*painter, rect, name_, color(mode, state));
  }

  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return rendered(name_, color(mode, state), size);
  }

  QIconEngine* clone() const override { return new ThemedEngine(theme_, name_, colors_); }

 private:
  QColor color(QIcon::Mode mode, QIcon::State state) const {
    if (mode == QIcon::Disabled) {
      return theme_.color("disabled");
    }
    return theme_.color(state == QIcon::On ? colors_.checked : colors_.normal);
  }

  const Theme& theme_;
  QString name_;
  IconColors colors_;
};

}  // namespace

QIcon makeIcon(const Theme& theme, const QString& name, const IconColors& colors) {
  return QIcon(new ThemedEngine(theme, name, colors));
}

void drawIcon(QPainter& painter, const QRectF& rect, const QString& name, const QColor& color) {
  const double ratio = painter.device()->devicePixelRatioF();
  const QPixmap pixmap = rendered(name, color, (rect.size() * ratio).toSize());
  painter.drawPixmap(rect, pixmap, QRectF(pixmap.rect()));
}

}  // namespace pbffd::ui
