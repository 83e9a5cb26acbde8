#include "app/dataset/remark.h"

#include <algorithm>
#include <iterator>

namespace pbffd {

std::string withOption(const Remark& remark) {
  if (remark.option.empty()) {
    return remark.text;
  }
  const std::size_t end = remark.text.ends_with('.') ? remark.text.size() - 1 : remark.text.size();
  return remark.text.substr(0, end) + " (" + remark.option + ")" + remark.text.substr(end);
}

std::vector<std::string> withOptions(const std::vector<Remark>& remarks) {
  std::vector<std::string> texts;
  std::transform(remarks.begin(), remarks.end(), std::back_inserter(texts), withOption);
  return texts;
}

}  // namespace pbffd
