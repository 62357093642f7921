#include "app/import/collada_text.h"

#include <QStringDecoder>

#include <algorithm>

namespace app
{
namespace
{
constexpr std::string_view blanks = " \t\r\n";

std::string asUtf8(std::string_view bytes)
{
    const bool isUtf16 = bytes.starts_with("\xff\xfe") || bytes.starts_with("\xfe\xff") ||
                         bytes.starts_with(std::string_view("<\0", 2)) || bytes.starts_with(std::string_view("\0<", 2));
    if (!isUtf16)
        return std::string(bytes.starts_with("\xef\xbb\xbf") ? bytes.substr(3) : bytes);
    const bool isLittle = bytes.front() == '\xff' || bytes.front() == '<';
    QStringDecoder decode(isLittle ? QStringDecoder::Utf16LE : QStringDecoder::Utf16BE);
    const QString text = decode(QByteArrayView(bytes.data(), static_cast<qsizetype>(bytes.size())));
    return text.toStdString();
}

/// Removes everything before the first tag and the XML declaration, whose encoding may no longer be that of the text.
void dropDeclaration(std::string& text)
{
    text.erase(0, std::min(text.find_first_not_of(blanks), text.size()));
    if (text.starts_with("<?xml"))
        text.erase(0, std::min(text.find("?>"), text.size() - 2) + 2);
}

/// Removes the blanks before an element's values: Assimp 5.2 does not parse numbers after blanks.
void dropBlanksBeforeValues(std::string& text)
{
    std::size_t to = 0;
    bool isAfterTag = false;
    for (std::size_t from = 0; from < text.size(); ++from) {
        const char c = text[from];
        if (isAfterTag && blanks.find(c) != std::string_view::npos)
            continue;
        isAfterTag = c == '>';
        text[to++] = c;
    }
    text.resize(to);
}

/// Names a file in references of images that have none, at which Assimp 5.2 fails an assertion. Images are not read.
std::string withReferences(std::string_view text)
{
    constexpr std::string_view begin = "<init_from", end = "</init_from", none = "<init_from>none</init_from>";
    std::string result;
    for (std::size_t at; (at = text.find(begin)) != std::string_view::npos;) {
        const std::size_t close = text.find('>', at);
        if (close == std::string_view::npos)
            break;
        const bool isClosed = text[close - 1] == '/';
        const std::size_t endTag = isClosed ? close : text.find(end, close);
        const std::size_t last = endTag == std::string_view::npos ? endTag : text.find('>', endTag);
        if (last == std::string_view::npos)
            break;
        std::string_view words = isClosed ? std::string_view() : text.substr(close + 1, endTag - close - 1);
        words.remove_prefix(std::min(words.find_first_not_of(blanks), words.size()));
        const bool isEmpty = words.empty() || words.starts_with("<!") || words == "file://";
        result.append(text.substr(0, at)).append(isEmpty ? none : text.substr(at, last + 1 - at));
        text.remove_prefix(last + 1);
    }
    return result.append(text);
}

std::size_t wordsIn(std::string_view text)
{
    std::size_t words = 0;
    while (true) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        if (text.empty())
            return words;
        text.remove_prefix(std::min(text.find_first_of(blanks), text.size()));
        ++words;
    }
}

/// Returns the tag of a float_array with its count attribute set to `count`.
std::string withCount(std::string_view tag, std::size_t count)
{
    constexpr std::string_view attribute = "count";
    for (std::size_t at = tag.find(attribute); at != std::string_view::npos; at = tag.find(attribute, at + 1)) {
        const std::size_t equals = tag.find_first_not_of(blanks, at + attribute.size());
        if (equals == std::string_view::npos || tag[equals] != '=')
            continue;
        const std::size_t first = std::min(tag.find_first_of("\"'", equals), tag.size() - 1) + 1;
        return std::string(tag.substr(0, first)) + std::to_string(count) +
               std::string(tag.substr(std::min(tag.find(tag[first - 1], first), tag.size())));
    }
    return tag.ends_with('/') ? std::string(tag) : std::string(tag) + " count=\"" + std::to_string(count) + '"';
}
} // namespace

std::string colladaText(std::string_view bytes)
{
    std::string text = asUtf8(bytes);
    dropDeclaration(text);
    dropBlanksBeforeValues(text);
    text = withReferences(text);
    std::string result;
    std::string_view rest = text;
    while (true) {
        const std::size_t tag = rest.find("<float_array");
        const std::size_t values = tag == std::string_view::npos ? tag : rest.find('>', tag);
        const std::size_t end = values == std::string_view::npos ? values : rest.find('<', values);
        if (end == std::string_view::npos)
            return result.append(rest);
        const std::size_t count = wordsIn(rest.substr(values + 1, end - values - 1));
        result.append(rest.substr(0, tag)).append(withCount(rest.substr(tag, values - tag), count));
        result.append(rest.substr(values, end - values));
        rest.remove_prefix(end);
    }
}
} // namespace app
