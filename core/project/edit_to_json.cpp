#include "core/project/edit_from_json.h"

namespace pbffd {
namespace {

std::string wordOf(Axis axis) {
  return axis == Axis::x ? "x" : axis == Axis::y ? "y" : "z";
}

Json levelOnly(const std::optional<int>& level) {
  Json json = Json::object();
  if (level) {
    json["level"] = *level;
  }
  return json;
}

Json onSelection(const PointSelection& where) {
  Json json = levelOnly(where.level);
  json["points"] = where.points;
  return json;
}

Json onPoint(const std::optional<int>& level, PointId point) {
  Json json = levelOnly(level);
  json["point"] = point;
  return json;
}

void add(Json& json, const Spread& spread) {
  if (!spread.weights.empty()) {
    json["weights"] = spread.weights;
  }
  if (spread.master) {
    json["master"] = true;
  }
  for (const Axis axis : spread.mirror) {
    json["mirror"].push_back(wordOf(axis));
  }
  if (spread.hasPlane) {
    json["plane"] = toJson(spread.plane);
  }
}

void add(Json& json, const Frame& frame) {
  json["center"] = toJson(frame.center);
  json["axes"] = axesToJson(frame.axes);
}

/// What stands beside the edit's name.
struct Body {
  Json operator()(const Place& edit) const {
    Json json = toJson(edit.options);
    if (edit.keepEdits) {
      json["keep_edits"] = true;
    }
    if (edit.symmetric) {
      json["symmetric"] = wordOf(*edit.symmetric);
    }
    return json;
  }

  Json operator()(const Move& edit) const {
    Json json = onSelection(edit.where);
    // One vector for one point reads the same either way.
    if (edit.by.size() == 1) {
      json["by"] = toJson(edit.by[0]);
    } else {
      json["by"] = Json::array();
      for (const Vec3& by : edit.by) {
        json["by"].push_back(toJson(by));
      }
    }
    if (edit.follow == Follow::none) {
      json["follow"] = "none";
    }
    add(json, edit.spread);
    return json;
  }

  Json operator()(const Transform& edit) const {
    Json json = onSelection(edit.where);
    if (edit.eachItsOwn) {
      json["pivot"] = "each";
    } else if (edit.pivot) {
      json["pivot"] = toJson(*edit.pivot);
    }
    if (edit.basis != Mat3::Identity()) {
      json["basis"] = axesToJson(edit.basis);
    }
    if (edit.scale != Vec3::Ones()) {
      json["scale"] = toJson(edit.scale);
    }
    if (edit.degrees != 0.0) {
      json["rotate"] = {{"axis", toJson(edit.rotationAxis)}, {"degrees", edit.degrees}};
    }
    add(json, edit.spread);
    return json;
  }

  Json operator()(const SetPose& edit) const {
    Json json = onPoint(edit.level, edit.point);
    add(json, edit.pose);
    return json;
  }

  Json operator()(const SetRegion& edit) const {
    Json json = onPoint(edit.level, edit.point);
    add(json, edit.rest);
    return json;
  }

  Json operator()(const Add& edit) const {
    Json json = levelOnly(edit.level);
    json["center"] = toJson(edit.rest.center);
    if (!edit.defaultAxes) {
      json["axes"] = axesToJson(edit.rest.axes);
    }
    if (edit.posed) {
      json["posed"] = true;
    }
    if (edit.id) {
      json["id"] = *edit.id;
    }
    if (!edit.name.empty()) {
      json["name"] = edit.name;
    }
    return json;
  }

  Json operator()(const Remove& edit) const { return onSelection(edit.where); }

  Json operator()(const Enable& edit) const {
    Json json = onSelection(edit.where);
    json["enabled"] = edit.enabled;
    return json;
  }

  Json operator()(const Lock& edit) const {
    Json json = onSelection(edit.where);
    json["locked"] = edit.locked;
    return json;
  }

  Json operator()(const Strength& edit) const {
    Json json = onSelection(edit.where);
    json["value"] = edit.value;
    return json;
  }

  Json operator()(const SetReach& edit) const {
    Json json = onSelection(edit.where);
    json["value"] = pbffd::wordOf(edit.value);
    return json;
  }

  Json operator()(const Refine& edit) const {
    Json json = onSelection(edit.where);
    json["factor"] = edit.factor;
    return json;
  }

  Json operator()(const Rename& edit) const {
    Json json = onPoint(edit.level, edit.point);
    json["name"] = edit.name;
    return json;
  }

  Json operator()(const SetLevels& edit) const {
    Json json = {{"count", edit.count}};
    if (edit.keep) {
      json["keep"] = true;
    }
    return json;
  }

  Json operator()(const SetMaster& edit) const {
    return {{"value", edit.value}, {"mode", pbffd::wordOf(edit.mode)}};
  }

  Json operator()(const SetKernel& edit) const {
    return {{"name", pbffd::wordOf(edit.basis.kernel)}, {"sigma", edit.basis.sigma}};
  }

  Json operator()(const Reset& edit) const {
    Json json = edit.where ? onSelection(*edit.where) : Json::object();
    if (edit.where && edit.master) {
      json["master"] = true;
    }
    return json;
  }

  Json operator()(const Group& edit) const {
    Json json = {{"text", edit.text}, {"edits", Json::array()}};
    for (const Edit& one : edit.edits) {
      json["edits"].push_back(editToJson(one));
    }
    return json;
  }
};

}  // namespace

Json editToJson(const Edit& edit) {
  Json json = Json::object();
  json[std::string(nameOf(edit))] = std::visit(Body{}, edit.value());
  return json;
}

}  // namespace pbffd
