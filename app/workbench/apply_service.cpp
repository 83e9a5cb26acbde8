#include "app/workbench/apply_service.h"

#include "app/dataset/apply.h"

#include <utility>

namespace pbffd::workbench {
namespace {

ui::ApplyService::Report applyTo(const Project& project, const ui::ApplyService::Request& request,
                                 const Progress& progress) {
  ApplyOptions options;
  options.align = request.align;
  options.transports = parseTransports(request.transports);
  const ApplyReport report = applyToFile(project, request.source, request.target, options, progress);
  std::vector<std::string> remarks;
  for (const Remark& remark : report.remarks) {
    remarks.push_back(remark.text);
  }
  return {report.points, report.pieces, std::move(remarks)};
}

}  // namespace

ui::ApplyService applyService() {
  return {applyTo, isApplicable, isApplicableAs, hasNamedArrays, applicableEndings()};
}

}  // namespace pbffd::workbench
