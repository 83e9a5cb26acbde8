#pragma once

#include <QIcon>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QObject>
#include <QString>

namespace pbffd::ui {

enum class ToolId { select, move, rotate, scale, add };

/// What the left button and the keys do in the view while this tool is active. Handlers return whether the
/// event is used up; what is not goes on to the camera and the window.
class Tool : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual ToolId id() const = 0;
  /// "Move".
  virtual QString name() const = 0;
  /// Of resources/icons.
  virtual QString iconName() const = 0;
  /// For the status bar; keys stand in square brackets: "Drag boxes  [Shift] adds".
  virtual QString hint() const = 0;

  virtual void activate() {}
  /// Drops what is going on, exactly.
  virtual void deactivate() {}

  virtual bool mousePress(const QMouseEvent& event) = 0;
  virtual bool mouseMove(const QMouseEvent& event) = 0;
  virtual bool mouseRelease(const QMouseEvent& event) = 0;
  virtual bool keyPress(const QKeyEvent& event) = 0;
  virtual bool keyRelease(const QKeyEvent& event) = 0;
  virtual void cursorLeft() {}

  /// Whether a drag or a modal gesture is going on, which all keys then belong to.
  virtual bool isBusy() const { return false; }
  /// Restores what was before the gesture, exactly.
  virtual void cancel() {}

 Q_SIGNALS:
  void hintChanged(const QString& hint);
};

}  // namespace pbffd::ui
