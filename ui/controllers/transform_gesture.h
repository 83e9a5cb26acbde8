#pragma once

#include "core/project/edit.h"
#include "ui/controllers/axis_lock.h"
#include "ui/controllers/number_entry.h"
#include "ui/views/camera.h"
#include "ui/views/gizmo.h"

#include <QPointF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace pbffd::ui {

/// What a gesture acts on.
struct GestureSubject {
  int level = 1;
  std::vector<PointId> points;
  Vec3 pivot = Vec3::Zero();
  Mat3 gizmoAxes = Mat3::Identity();  ///< columns: unit directions
  Mat3 localAxes = Mat3::Identity();
  bool isWholeLevel = false;  ///< all points of the level: the master goes along, and with it the whole shape
  bool eachItsOwn = false;    ///< every point turns and scales about its own centre
  double size = 1.0;          ///< of the mesh: its diagonal
};

/// Where the cursor is and what is held.
struct GesturePointer {
  QPointF position;
  bool isPrecise = false;  ///< one tenth of the motion
  bool snaps = false;
};

/// Moving, rotating or scaling points by the cursor, by axis keys and by typed numbers: what the edit is at
/// each moment. Knows no document and no widget.
class TransformGesture {
 public:
  TransformGesture(GestureSubject subject, AxisLock lock, const QPointF& start);
  virtual ~TransformGesture() = default;

  void moveTo(const Projection& projection, const GesturePointer& pointer);
  /// X, Y, Z: 0, 1, 2.
  void pressAxis(const Projection& projection, int axis, bool toPlane);
  void type(const Projection& projection, QChar character);
  void erase(const Projection& projection);
  void nextNumber();

  virtual Edit edit() const = 0;
  /// Whether the edit would change nothing.
  virtual bool isIdentity() const = 0;
  /// What is drawn while it goes on.
  virtual Gizmo gizmo(const Projection& projection) const = 0;
  /// "Y +0.350".
  QString readOut() const;
  /// What stands after it: "type a number", or what the typed sum comes to.
  QString readOutHint() const;
  /// "Moving along Y".
  virtual QString title() const = 0;
  /// The keys that work now, in square brackets.
  QString keyHints() const;

  const AxisLock& lock() const { return lock_; }
  const GestureSubject& subject() const { return subject_; }
  const NumberEntry& entry() const { return entry_; }

 protected:
  /// Works out the amount again from start(), cursor() and what was typed.
  virtual void follow(const Projection& projection) = 0;
  virtual void lockChanged() {}
  virtual int numberCount() const = 0;
  virtual bool takesPlanes() const = 0;
  /// The amount as the mouse gives it, one text a number, and the letters before them ("X", "Y").
  virtual QStringList amounts() const = 0;
  virtual QStringList letters() const { return {}; }

  Mat3 lockAxes() const;
  const QPointF& start() const { return start_; }
  const QPointF& cursor() const { return cursor_; }
  bool isPrecise() const { return isPrecise_; }
  bool snaps() const { return snaps_; }
  /// The number typed in a field; none while nothing is typed at all; what is no number yet counts as 0.
  std::optional<double> typed(int field) const;

 private:
  void relock(const AxisLock& lock, const Projection& projection);

  GestureSubject subject_;
  AxisLock lock_;
  QPointF start_;
  QPointF last_;
  QPointF cursor_;  ///< as if all motion had been at full rate
  bool isPrecise_ = false;
  bool snaps_ = false;
  NumberEntry entry_;
};

/// A length with as many decimals as the size of the mesh gives sense to, signed: "+0.350".
QString lengthText(double length, double size);
/// "X".
QString axisLetter(int axis);
/// "along Y", "in the plane of X and Z", or nothing.
QString lockText(const AxisLock& lock);

}  // namespace pbffd::ui
