#pragma once

#include "core/base/progress.h"
#include "core/ffd/levels/weight_cache.h"
#include "core/ffd/placement/placement.h"
#include "core/project/project.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace pbffd {

// The edits of contract.md, section 2: one vocabulary for undo entries, the command line, scripts and
// tests. Levels count from 1, the coarsest; none is the finest.

enum class Axis { x, y, z };
enum class Follow { frames, none };

/// The points that an edit acts on.
struct PointSelection {
  std::optional<int> level;
  std::vector<PointId> points;
};

/// Places control points afresh; manual, curve and locked points survive.
struct Place {
  PlacementOptions options;
  bool keepEdits = false;
  std::optional<Axis> symmetric;
};

/// Options that Move and Transform share.
struct Spread {
  std::vector<double> weights;  ///< soft selection: one a point, or empty for all 1
  bool master = false;          ///< the master goes along
  std::vector<Axis> mirror;     ///< acts on the mirror partners too
  Vec3 plane = Vec3::Zero();    ///< the point that the mirror planes pass through
  bool hasPlane = false;        ///< without one: the middle of the mesh's bounds
};

struct Move {
  PointSelection where;
  std::vector<Vec3> by;  ///< one for all, or one a point
  Follow follow = Follow::frames;
  Spread spread;
};

/// Scale along `basis`, then a right-handed rotation, both about the pivot.
struct Transform {
  PointSelection where;
  std::optional<Vec3> pivot;      ///< none: the median of the posed centres
  bool eachItsOwn = false;        ///< pivot "each": each point's own centre
  Mat3 basis = Mat3::Identity();  ///< columns: the axes of the scale
  Vec3 scale = Vec3::Ones();
  Vec3 rotationAxis = Vec3::UnitZ();
  double degrees = 0.0;
  Spread spread;
};

struct SetPose {
  std::optional<int> level;
  PointId point = 0;
  Frame pose;
};

struct SetRegion {
  std::optional<int> level;
  PointId point = 0;
  Frame rest;
};

struct Add {
  std::optional<int> level;
  Frame rest;
  bool defaultAxes = false;  ///< no axes given: a sphere of the size that placement would take there
  bool posed = false;        ///< the centre is given in the deformed space
  std::optional<PointId> id;
  std::string name;
};

struct Remove {
  PointSelection where;
};

struct Enable {
  PointSelection where;
  bool enabled = true;
};

struct Lock {
  PointSelection where;
  bool locked = true;
};

struct Strength {
  PointSelection where;
  double value = 1.0;
};

struct SetReach {
  PointSelection where;
  Reach value = Reach::connected;
};

struct Rename {
  std::optional<int> level;
  PointId point = 0;
  std::string name;
};

/// Gives the regions of points more and smaller ones.
struct Refine {
  PointSelection where;
  int factor = 2;  ///< so many points where one was; 2 to 64
};

/// Rebuilds the coarser levels from the finest, or only makes those that are missing and drops those too many.
struct SetLevels {
  int count = 3;
  bool keep = false;  ///< levels that there are stay as they are; they come and go at the coarse end
};

struct SetMaster {
  double value = 0.01;
  MasterMode mode = MasterMode::constant;
};

struct SetKernel {
  Basis basis;
};

/// Poses back to rest: all of them and the master's, or those of `where`.
struct Reset {
  std::optional<PointSelection> where;
  bool master = false;  ///< with `where`: the master's too
};

struct Edit;

/// Several edits that are one undo entry.
struct Group {
  std::string text;
  std::vector<Edit> edits;
};

struct Edit : std::variant<Place, Move, Transform, SetPose, SetRegion, Add, Remove, Enable, Lock, Strength,
                           SetReach, Refine, Rename, SetLevels, SetMaster, SetKernel, Reset, Group> {
  using variant::variant;
  const variant& value() const { return *this; }
};

/// What apply() finds again from one edit to the next; results do not depend on it.
struct EditWorkspace {
  WeightCache weights;
  std::shared_ptr<const PlacementCache> placement;
  /// Whether another `place` may follow that `placement` is worth its memory for, which is that of the mesh.
  bool keepsPlacement = true;
};

/// What an edit made: the new project, and sentences that the user should read (fewer points placed than
/// asked for, and why).
struct EditResult {
  Project project;
  std::vector<std::string> remarks;
};

/// The project after an edit. Throws InvalidInput that says why it cannot be done (no such point, axes
/// that are not orthogonal, a number that is not finite, a point of another kind); the given project is a
/// value and stays as it is. Throws Cancelled.
EditResult apply(const Project& project, const Edit& edit, EditWorkspace& workspace,
                 const Progress& progress = {});

/// Applies edits one after the other, as a file of edits does. Throws InvalidInput like apply(); the message
/// then begins with the place of the edit: "edit 3 (move, at /2): there is no point 999 on level 2".
EditResult applyAll(const Project& project, const std::vector<Edit>& edits, EditWorkspace& workspace,
                    const Progress& progress = {});

/// The edit's name in contract.md: "move", "set_pose".
std::string_view nameOf(const Edit& edit);

/// The undo text: an imperative that names what and how much ("Move 39 points by 0, 0.35, 0").
std::string describe(const Project& before, const Edit& edit);

}  // namespace pbffd
