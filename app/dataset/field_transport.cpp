#include "app/dataset/field_transport.h"

#include "core/base/error.h"
#include "core/base/parallel.h"
#include "core/base/text.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cctype>
#include <utility>

namespace pbffd {

Transport parseTransport(std::string_view text) {
  Transport transport{std::string(text), std::nullopt};
  for (const auto& [ending, kind] : {std::pair{std::string_view(":vector"), FieldKind::vector},
                                     std::pair{std::string_view(":normal"), FieldKind::normal}}) {
    if (text.ends_with(ending)) {
      transport = {std::string(text.substr(0, text.size() - ending.size())), kind};
    }
  }
  if (transport.array.empty()) {
    throw InvalidInput(
        format("Could not tell which array to transport: '{}' names none. Give NAME, NAME:vector or "
               "NAME:normal.",
               text));
  }
  return transport;
}

std::vector<Transport> parseTransports(const std::vector<std::string>& texts) {
  std::vector<Transport> transports;
  for (const std::string& text : texts) {
    Transport transport = parseTransport(text);
    if (std::any_of(transports.begin(), transports.end(),
                    [&](const Transport& other) { return other.array == transport.array; })) {
      throw InvalidInput(format("Could not transport the array '{}': it is named twice. Name each array once.",
                                transport.array));
    }
    transports.push_back(std::move(transport));
  }
  return transports;
}

bool namesNormals(std::string_view name) {
  std::string lower(name);
  std::transform(lower.begin(), lower.end(), lower.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower == "normal" || lower == "normals" || lower.ends_with("normals");
}

Vec3 transported(const Mat3& gradient, const Vec3& value, FieldKind kind) {
  if (kind == FieldKind::vector) {
    return gradient * value;
  }
  // The cofactors need no inverse, and keep the side of the surface where the deformation mirrors.
  const Vec3 turned = value.x() * gradient.col(1).cross(gradient.col(2)) +
                      value.y() * gradient.col(2).cross(gradient.col(0)) +
                      value.z() * gradient.col(0).cross(gradient.col(1));
  const double length = turned.norm();
  return length > 0.0 ? Vec3(turned * (value.norm() / length)) : value;
}

void transportRows(Points& rows, const std::vector<Mat3>& gradients, FieldKind kind) {
  constexpr std::size_t grain = 1 << 14;
  parallelFor(gradients.size(), grain, [&](std::size_t begin, std::size_t end) {
    for (auto i = static_cast<Eigen::Index>(begin); i < static_cast<Eigen::Index>(end); ++i) {
      rows.row(i) = transported(gradients[static_cast<std::size_t>(i)], rows.row(i), kind);
    }
  });
}

}  // namespace pbffd
