#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace pbffd {

/// A tag of an XML text and where it stands in it.
struct XmlTag {
  struct Attribute {
    std::string name;
    std::string value;      ///< with the five predefined entities resolved
    std::size_t begin = 0;  ///< of the value in the text, behind the quote
    std::size_t end = 0;
  };

  std::string name;
  bool isEnd = false;     ///< </name>
  bool isEmpty = false;   ///< <name/>
  std::size_t begin = 0;  ///< of '<'
  std::size_t end = 0;    ///< behind '>'
  std::vector<Attribute> attributes;

  /// Null where there is none.
  const Attribute* find(std::string_view attribute) const;
  /// Empty where there is none.
  std::string value(std::string_view attribute) const;
};

/// The tags of a text in their order, to its end or through the first one named `last`; comments, declarations
/// and text between tags are passed over. Throws InvalidInput with the byte where a tag is malformed.
std::vector<XmlTag> scanXmlTags(std::string_view text, std::string_view last = {});

/// `text` fit to stand between the quotes of an attribute.
std::string escapedForXml(std::string_view text);

}  // namespace pbffd
