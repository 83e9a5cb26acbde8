#pragma once

#include <QColor>
#include <QFont>
#include <QObject>
#include <QString>

#include <map>

namespace pbffd::ui {

/// The design tokens of the current theme, by the names of the palette ("panel", "accent.bg", "mesh.edges",
/// "axis.x", "point.interior"): the one source of colour for widgets and render views. Loaded from
/// resources/themes/{dark,light}.json.
class Theme : public QObject {
  Q_OBJECT

 public:
  enum class Choice { system, dark, light };
  explicit Theme(QObject* parent = nullptr);

  Choice choice() const { return choice_; }
  /// Loads the tokens and sets the application's palette and style sheet.
  void choose(Choice choice);
  bool isDark() const { return dark_; }

  /// Throws std::out_of_range for a name that is no token (a mistake in the program).
  QColor color(const QString& token) const;

  /// The interface's font: Inter where it is installed, else the desktop's; figures of one width.
  static QFont font(int pixels, QFont::Weight weight = QFont::Normal);

 Q_SIGNALS:
  void changed();

 private:
  void load(const QString& name);
  QString styleSheet() const;

  Choice choice_ = Choice::system;
  bool dark_ = true;
  bool hasStyle_ = false;
  std::map<QString, QColor> colors_;
};

}  // namespace pbffd::ui
