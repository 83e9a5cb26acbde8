#include "app/workbench/apply_service.h"

#include "app/dataset/apply.h"

namespace pbffd::workbench {
namespace {

ui::ApplyService::Report applyTo(const Project& project, const ui::ApplyService::Request& request,
                                 const Progress& progress) {
  ApplyOptions options;
  options.align = request.align;
  for (const std::string& text : request.transports) {
    options.transports.push_back(parseTransport(text));
  }
  const ApplyReport report = applyToFile(project, request.source, request.target, options, progress);
  return {report.points, report.pieces, report.remarks};
}

}  // namespace

ui::ApplyService applyService() {
  return {applyTo, isApplicable, hasNamedArrays, applicableEndings()};
}

}  // namespace pbffd::workbench
