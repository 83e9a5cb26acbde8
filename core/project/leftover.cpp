#include "core/project/leftover.h"

namespace pbffd {
namespace {

void overlayObject(Json& target, const Json& additions) {
  for (const auto& [key, value] : additions.items()) {
    const auto found = target.find(key);
    if (found == target.end()) {
      target[key] = value;
    } else if (found->is_object() && value.is_object()) {
      overlayObject(*found, value);
    }
  }
}

}  // namespace

Json leftover(const Json& original, const Json& known) {
  Json rest = Json::object();
  if (!original.is_object() || !known.is_object()) {
    return rest;
  }
  for (const auto& [key, value] : original.items()) {
    const auto found = known.find(key);
    if (found == known.end()) {
      rest[key] = value;
      continue;
    }
    Json within = leftover(value, *found);
    if (!within.empty()) {
      rest[key] = std::move(within);
    }
  }
  return rest;
}

std::string textOf(const Json& object) {
  return object.empty() ? std::string() : object.dump();
}

void overlay(Json& target, const std::string& leftover) {
  if (!leftover.empty()) {
    overlayObject(target, Json::parse(leftover));
  }
}

}  // namespace pbffd
