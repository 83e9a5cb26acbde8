#include "ui/controllers/transform_gesture.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace pbffd::ui {
namespace {

constexpr double preciseShare = 0.1;

QString translated(const char* text) {
  return QCoreApplication::translate("TransformGesture", text);
}

}  // namespace

TransformGesture::TransformGesture(GestureSubject subject, AxisLock lock, const QPointF& start)
    : subject_(std::move(subject)), lock_(lock), start_(start), last_(start), cursor_(start) {}

void TransformGesture::moveTo(const Projection& projection, const GesturePointer& pointer) {
  cursor_ += (pointer.isPrecise ? preciseShare : 1.0) * (pointer.position - last_);
  last_ = pointer.position;
  isPrecise_ = pointer.isPrecise;
  snaps_ = pointer.snaps;
  follow(projection);
}

void TransformGesture::relock(const AxisLock& lock, const Projection& projection) {
  lock_ = lock;
  entry_.setCount(numberCount());
  lockChanged();
  follow(projection);
}

void TransformGesture::pressAxis(const Projection& projection, int axis, bool toPlane) {
  if (!toPlane || takesPlanes()) {
    relock(lock_.afterKey(axis, toPlane), projection);
  }
}

void TransformGesture::type(const Projection& projection, QChar character) {
  entry_.setCount(numberCount());
  entry_.type(character);
  follow(projection);
}

void TransformGesture::erase(const Projection& projection) {
  entry_.erase();
  follow(projection);
}

void TransformGesture::nextNumber() {
  entry_.setCount(numberCount());
  entry_.next();
}

Mat3 TransformGesture::lockAxes() const {
  switch (lock_.space) {
    case AxisLock::Space::global:
      return Mat3::Identity();
    case AxisLock::Space::local:
      return subject_.localAxes;
    case AxisLock::Space::gizmo:
      break;
  }
  return subject_.gizmoAxes;
}

std::optional<double> TransformGesture::typed(int field) const {
  if (entry_.isEmpty()) {
    return std::nullopt;
  }
  return entry_.value(field).value_or(0.0);
}

QString TransformGesture::readOut() const {
  const QStringList names = letters();
  const QStringList numbers = amounts();
  QStringList parts;
  for (int i = 0; i < numbers.size(); ++i) {
    QString number = numbers[i];
    if (!entry_.isEmpty() && i < entry_.count()) {
      number = entry_.text(i).isEmpty() ? QStringLiteral("0") : entry_.text(i);
      number += i == entry_.field() ? QStringLiteral("|") : QString();
    }
    parts << (i < names.size() ? QStringLiteral("%1 %2").arg(names[i], number) : number);
  }
  return parts.join(QStringLiteral("   "));
}

QString TransformGesture::readOutHint() const {
  if (entry_.isEmpty()) {
    return translated("type a number");
  }
  const auto value = entry_.value(entry_.field());
  if (!value) {
    return translated("not a number yet");
  }
  bool isPlain = false;
  entry_.text(entry_.field()).toDouble(&isPlain);
  return isPlain ? QString() : QStringLiteral("= %1").arg(*value, 0, 'g', 6);
}

QString TransformGesture::keyHints() const {
  QStringList others;
  for (int axis = 0; axis < 3; ++axis) {
    if (lock_.kind != AxisLock::Kind::axis || lock_.axis != axis) {
      others << QStringLiteral("[%1]").arg(axisLetter(axis));
    }
  }
  return translated("[Shift] precise  [Ctrl] snap  %1 axis  [Enter] confirm  [Esc] cancel")
      .arg(others.join(QLatin1Char(' ')));
}

QString lengthText(double length, double size) {
  int decimals = 3;
  if (size >= 100.0) {
    decimals = std::max(0, 4 - static_cast<int>(std::floor(std::log10(size))));
  } else if (size < 1.0 && size > 0.0) {
    decimals = std::min(9, 3 + static_cast<int>(std::ceil(-std::log10(size))));
  }
  QString text = QString::number(std::abs(length), 'f', decimals);
  const bool isZero = text.toDouble() == 0.0;
  return (length < 0.0 && !isZero ? QStringLiteral("\u2212") : QStringLiteral("+")) + text;
}

QString axisLetter(int axis) {
  return QString(QLatin1Char(static_cast<char>('X' + axis)));
}

QString lockText(const AxisLock& lock) {
  const bool isLocal = lock.space == AxisLock::Space::local;
  switch (lock.kind) {
    case AxisLock::Kind::axis:
      return (isLocal ? translated("along local %1") : translated("along %1")).arg(axisLetter(lock.axis));
    case AxisLock::Kind::plane:
      return (isLocal ? translated("in the local plane %1%2") : translated("in the plane %1%2"))
          .arg(axisLetter(std::min((lock.axis + 1) % 3, (lock.axis + 2) % 3)),
               axisLetter(std::max((lock.axis + 1) % 3, (lock.axis + 2) % 3)));
    case AxisLock::Kind::free:
      break;
  }
  return {};
}

}  // namespace pbffd::ui
