#include "app/dataset/xml_tags.h"

#include "core/base/error.h"
#include "core/base/text.h"

#include <algorithm>
#include <array>
#include <utility>

namespace pbffd {
namespace {

constexpr std::string_view space = " \t\r\n";
constexpr std::array<std::pair<std::string_view, char>, 5> entities{
    {{"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}, {"&amp;", '&'}}};

[[noreturn]] void fail(std::size_t at, std::string_view what) {
  throw InvalidInput(format("at byte {} {}", at, what));
}

std::string resolved(std::string_view text) {
  std::string result;
  while (!text.empty()) {
    const auto entity = std::find_if(entities.begin(), entities.end(),
                                     [&](const auto& candidate) { return text.starts_with(candidate.first); });
    result += entity == entities.end() ? text.front() : entity->second;
    text.remove_prefix(entity == entities.end() ? 1 : entity->first.size());
  }
  return result;
}

/// Passes over what begins at `at` with `opening`; `at` stays where it does not.
bool skip(std::string_view text, std::size_t& at, std::string_view opening, std::string_view closing) {
  if (!text.substr(at).starts_with(opening)) {
    return false;
  }
  const std::size_t end = text.find(closing, at + opening.size());
  if (end == std::string_view::npos) {
    fail(at, format("'{}' is never closed", opening));
  }
  at = end + closing.size();
  return true;
}

std::size_t pastSpace(std::string_view text, std::size_t at) {
  const std::size_t next = text.find_first_not_of(space, at);
  return next == std::string_view::npos ? text.size() : next;
}

XmlTag::Attribute scanAttribute(std::string_view text, std::size_t& at) {
  const std::size_t nameEnd = text.find_first_of("= \t\r\n/>", at);
  const std::size_t equals = nameEnd == std::string_view::npos ? text.size() : pastSpace(text, nameEnd);
  const std::size_t quote = equals < text.size() ? pastSpace(text, equals + 1) : text.size();
  if (quote >= text.size() || nameEnd == at || text[equals] != '=' ||
      (text[quote] != '"' && text[quote] != '\'')) {
    fail(at, "an attribute is malformed");
  }
  const std::size_t end = text.find(text[quote], quote + 1);
  if (end == std::string_view::npos) {
    fail(quote, "an attribute's value is never closed");
  }
  XmlTag::Attribute attribute{std::string(text.substr(at, nameEnd - at)),
                              resolved(text.substr(quote + 1, end - quote - 1)), quote + 1, end};
  at = end + 1;
  return attribute;
}

XmlTag scanTag(std::string_view text, std::size_t at) {
  XmlTag tag;
  tag.begin = at;
  tag.isEnd = text.substr(at).starts_with("</");
  at += tag.isEnd ? 2 : 1;
  const std::size_t nameEnd = text.find_first_of(" \t\r\n/>", at);
  if (nameEnd == std::string_view::npos || nameEnd == at) {
    fail(tag.begin, "a tag is malformed");
  }
  tag.name = text.substr(at, nameEnd - at);
  for (at = pastSpace(text, nameEnd); at < text.size() && text[at] != '>' && text[at] != '/';
       at = pastSpace(text, at)) {
    tag.attributes.push_back(scanAttribute(text, at));
  }
  tag.isEmpty = at < text.size() && text[at] == '/';
  at += tag.isEmpty ? 1 : 0;
  if (at >= text.size() || text[at] != '>') {
    fail(tag.begin, "a tag is never closed");
  }
  tag.end = at + 1;
  return tag;
}

}  // namespace

const XmlTag::Attribute* XmlTag::find(std::string_view attribute) const {
  const auto found = std::find_if(attributes.begin(), attributes.end(),
                                  [&](const Attribute& candidate) { return candidate.name == attribute; });
  return found == attributes.end() ? nullptr : &*found;
}

std::string XmlTag::value(std::string_view attribute) const {
  const Attribute* found = find(attribute);
  return found == nullptr ? std::string() : found->value;
}

std::vector<XmlTag> scanXmlTags(std::string_view text, std::string_view last) {
  std::vector<XmlTag> tags;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at)) {
    if (skip(text, at, "<!--", "-->") || skip(text, at, "<?", "?>") || skip(text, at, "<![CDATA[", "]]>") ||
        skip(text, at, "<!", ">")) {
      continue;
    }
    tags.push_back(scanTag(text, at));
    at = tags.back().end;
    if (!last.empty() && tags.back().name == last) {
      break;
    }
  }
  return tags;
}

std::string escapedForXml(std::string_view text) {
  std::string result;
  for (const char c : text) {
    const auto entity = std::find_if(entities.begin(), entities.end(),
                                     [c](const auto& candidate) { return candidate.second == c; });
    result += entity == entities.end() ? std::string(1, c) : std::string(entity->first);
  }
  return result;
}

}  // namespace pbffd
