#include "ui/document/theme.h"

#include <QApplication>
#include <QFile>
#include <QFont>
#include <QFontDatabase>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPalette>
#include <QProxyStyle>

#include <stdexcept>
#include <utility>

/// Resources of a static library are only found once this was called; outside any namespace as Qt asks.
static void initializeResources() {
  Q_INIT_RESOURCE(pbffd);
}

namespace pbffd::ui {
namespace {

QByteArray resource(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly)) {
    throw std::logic_error("The program lacks its resource " + path.toStdString());
  }
  return file.readAll();
}

/// Whether the desktop asks for dark windows: Qt's platform palette before any theme of ours is set.
bool desktopIsDark() {
  static const bool dark = QPalette().color(QPalette::Window).lightness() < 128;
  return dark;
}

QPalette paletteOf(const Theme& theme) {
  QPalette palette;
  const std::pair<QPalette::ColorRole, const char*> roles[] = {{QPalette::Window, "panel"},
                                                               {QPalette::WindowText, "text"},
                                                               {QPalette::Base, "field"},
                                                               {QPalette::AlternateBase, "panel"},
                                                               {QPalette::Text, "text"},
                                                               {QPalette::Button, "raised"},
                                                               {QPalette::ButtonText, "text"},
                                                               {QPalette::ToolTipBase, "raised"},
                                                               {QPalette::ToolTipText, "text"},
                                                               {QPalette::PlaceholderText, "text.3"},
                                                               {QPalette::Highlight, "select.bg"},
                                                               {QPalette::HighlightedText, "text"},
                                                               {QPalette::Link, "accent"},
                                                               {QPalette::LinkVisited, "accent"},
                                                               {QPalette::BrightText, "accent.text"},
                                                               {QPalette::Mid, "line"},
                                                               {QPalette::Light, "raised"},
                                                               {QPalette::Dark, "line"},
                                                               {QPalette::Midlight, "hover"},
                                                               {QPalette::Shadow, "window"}};
  for (const auto& [role, token] : roles) {
    palette.setColor(role, theme.color(token));
  }
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, theme.color("disabled"));
  }
  return palette;
}

/// Fusion, the same on every desktop, with mnemonics that act but are not underlined.
class WorkbenchStyle : public QProxyStyle {
 public:
  WorkbenchStyle() : QProxyStyle("Fusion") {}

  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* data) const override {
    return hint == SH_UnderlineShortcut ? 0 : QProxyStyle::styleHint(hint, option, widget, data);
  }
};

QString cssOf(const QColor& color) {
  return QString("rgba(%1, %2, %3, %4)")
      .arg(color.red())
      .arg(color.green())
      .arg(color.blue())
      .arg(color.alpha());
}

}  // namespace

Theme::Theme(QObject* parent) : QObject(parent) {
  initializeResources();
  desktopIsDark();
  load("dark");
}

void Theme::choose(Choice choice) {
  choice_ = choice;
  const bool dark = choice == Choice::system ? desktopIsDark() : choice == Choice::dark;
  load(dark ? "dark" : "light");
  if (!std::exchange(hasStyle_, true)) {
    QApplication::setStyle(new WorkbenchStyle);
  }
  QApplication::setFont(font(12));
  QApplication::setPalette(paletteOf(*this));
  qApp->setStyleSheet(styleSheet());
  Q_EMIT changed();
}

void Theme::load(const QString& name) {
  dark_ = name == "dark";
  const QJsonObject tokens = QJsonDocument::fromJson(resource(QString(":/themes/%1.json").arg(name))).object();
  colors_.clear();
  for (auto token = tokens.begin(); token != tokens.end(); ++token) {
    colors_[token.key()] = QColor(token.value().toString());
  }
}

QColor Theme::color(const QString& token) const {
  return colors_.at(token);
}

QFont Theme::font(int pixels, QFont::Weight weight) {
  static const bool hasInter = QFontDatabase::hasFamily("Inter");
  QFont font = QFontDatabase::systemFont(QFontDatabase::GeneralFont);
  if (hasInter) {
    font.setFamily("Inter");
  }
  font.setPixelSize(pixels);
  font.setWeight(weight);
#if QT_VERSION >= QT_VERSION_CHECK(6, 7, 0)
  font.setFeature("tnum", 1);
#endif
  return font;
}

QString Theme::styleSheet() const {
  QString sheet = QString::fromUtf8(resource(":/themes/style.qss"));
  for (const auto& [token, color] : colors_) {
    sheet.replace("@" + token + "@", cssOf(color));
  }
  return sheet.replace("@theme@", dark_ ? "dark" : "light");
}

}  // namespace pbffd::ui
