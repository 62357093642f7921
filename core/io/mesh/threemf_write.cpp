// 3MF: content types, relationships and one model part, whose text is generated while it is compressed. It has an
// object and a build item for each part of the mesh and, if there are colours, a colour group that the triangles'
// corners refer to.
#include "core/io/mesh/file_parts.h"
#include "core/io/mesh/format.h"
#include "core/io/mesh/object_labels.h"
#include "core/io/mesh/palette.h"
#include "core/io/mesh/zip_writer.h"

#include <zip.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace core::io
{
namespace
{
constexpr std::string_view contentTypes = R"(<?xml version="1.0" encoding="UTF-8"?>
<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/>
</Types>
)";
constexpr std::string_view relationships = R"(<?xml version="1.0" encoding="UTF-8"?>
<Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="model" )"
                                           R"(Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
</Relationships>
)";
constexpr std::string_view modelStart = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" )"
                                        R"(xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" )"
                                        R"(xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02">
<metadata name="Application">Fettle</metadata>
<resources>
)";
constexpr std::size_t colorGroupId = 2;

/// Returns the id of an object; it is not that of the colour group.
std::size_t idOf(std::size_t object)
{
    return object == 0 ? 1 : object + colorGroupId;
}

std::string escaped(std::string_view text)
{
    std::string result;
    for (const char c : text) {
        constexpr std::string_view special = "&<>\"";
        constexpr std::string_view entities[] = {"&amp;", "&lt;", "&gt;", "&quot;"};
        const std::size_t which = special.find(c);
        result += which == std::string_view::npos ? std::string_view(&c, 1) : entities[which];
    }
    return result;
}

std::uint32_t numberOf(const Rgb& color)
{
    return static_cast<std::uint32_t>(color.r) << 16 | static_cast<std::uint32_t>(color.g) << 8 | color.b;
}

/// Generates the text of the model part piece by piece.
class ModelText
{
public:
    /// `parts`: not owned.
    ModelText(const TriangleMesh& mesh, const FileParts& parts) : m_parts(parts.all())
    {
        m_colors.reserve(mesh.colors.size());
        for (const Rgb& color : mesh.colors)
            m_colors.push_back(numberOf(color));
        std::ranges::sort(m_colors);
        m_colors.erase(std::unique(m_colors.begin(), m_colors.end()),
                       m_colors.end()); // Clang 14, which the fuzzers need, knows no ranges::unique
    }

    /// Returns the size of the whole text in bytes. Must be called before read(). The zip's entries can have the short
    /// headers of old zip versions only if the size is known.
    std::size_t size()
    {
        std::size_t bytes = 0;
        for (restart(); addNext(); m_text.clear())
            bytes += m_text.size();
        return bytes;
    }

    void restart() { m_section = m_next = m_taken = 0, m_text.clear(); }

    std::size_t read(char* to, std::size_t size)
    {
        while (m_text.size() - m_taken < size && addNext()) {
        }
        const std::size_t given = std::min(size, m_text.size() - m_taken);
        std::memcpy(to, m_text.data() + m_taken, given);
        m_taken += given;
        constexpr std::size_t enough = 1 << 16;
        if (m_taken > enough) {
            m_text.erase(0, m_taken);
            m_taken = 0;
        }
        return given;
    }

private:
    /// Appends the next element to m_text: the start with the colours, each object, the build. Returns false after the
    /// last one.
    bool addNext()
    {
        for (; m_section < m_parts.size() + 2; ++m_section, m_next = 0)
            if (addOf(m_section, m_next)) {
                ++m_next;
                return true;
            }
        return false;
    }

    /// Appends an element of a section. Returns false if the section has fewer elements.
    bool addOf(std::size_t section, std::size_t at)
    {
        if (section == 0)
            return addStart(at);
        if (section <= m_parts.size())
            return addObject(section - 1, at);
        return addBuild(at);
    }

    bool addStart(std::size_t at)
    {
        if (at == 0)
            *this << modelStart;
        if (m_colors.empty())
            return at == 0;
        if (at == 0)
            *this << "<m:colorgroup id=\"" << colorGroupId << "\">\n";
        else if (at <= m_colors.size())
            addColor(m_colors[at - 1]);
        else if (at == m_colors.size() + 1)
            *this << "</m:colorgroup>\n";
        else
            return false;
        return true;
    }

    bool addObject(std::size_t index, std::size_t at)
    {
        const auto& [mesh, name] = m_parts[index];
        const std::size_t points = mesh.points.size(), triangles = mesh.triangles.size();
        if (at == 0)
            addObjectStart(index, cleanName(name));
        else if (at <= points)
            addPoint(mesh.points[at - 1]);
        else if (at == points + 1)
            *this << "</vertices><triangles>\n";
        else if (at <= points + 1 + triangles)
            addTriangle(mesh, mesh.triangles[at - points - 2]);
        else if (at == points + triangles + 2)
            *this << "</triangles></mesh></object>\n";
        else
            return false;
        return true;
    }

    void addObjectStart(std::size_t index, std::string_view name)
    {
        *this << "<object id=\"" << idOf(index) << "\" type=\"model\"";
        if (!name.empty())
            *this << " name=\"" << escaped(name) << "\"";
        if (!m_colors.empty())
            *this << " pid=\"" << colorGroupId << "\" pindex=\"0\"";
        *this << "><mesh><vertices>\n";
    }

    void addPoint(const Vec3f& p)
    {
        *this << "<vertex x=\"" << p.x() << "\" y=\"" << p.y() << "\" z=\"" << p.z() << "\"/>\n";
    }

    bool addBuild(std::size_t at)
    {
        if (at > m_parts.size())
            return false;
        if (at == 0)
            *this << "</resources>\n<build>";
        if (at < m_parts.size())
            *this << "<item objectid=\"" << idOf(at) << "\"/>";
        else
            *this << "</build>\n</model>\n";
        return true;
    }

    void addColor(std::uint32_t color)
    {
        constexpr std::string_view hex = "0123456789ABCDEF";
        *this << "<m:color color=\"#";
        for (int shift = 20; shift >= 0; shift -= 4)
            *this << hex.substr(color >> shift & 15, 1);
        *this << "\"/>\n";
    }

    void addTriangle(const TriangleMesh& mesh, const Triangle& t)
    {
        *this << "<triangle v1=\"" << t[0] << "\" v2=\"" << t[1] << "\" v3=\"" << t[2];
        if (!m_colors.empty()) {
            const auto [a, b, c] = std::array{indexOf(mesh, t[0]), indexOf(mesh, t[1]), indexOf(mesh, t[2])};
            *this << "\" p1=\"" << a;
            if (b != a || c != a)
                *this << "\" p2=\"" << b << "\" p3=\"" << c;
        }
        *this << "\"/>\n";
    }

    std::size_t indexOf(const TriangleMesh& mesh, Slot corner) const
    {
        return static_cast<std::size_t>(std::ranges::lower_bound(m_colors, numberOf(mesh.colors[corner])) -
                                        m_colors.begin());
    }

    ModelText& operator<<(std::string_view text)
    {
        m_text += text;
        return *this;
    }
    template <typename Number>
    requires std::is_arithmetic_v<Number> ModelText& operator<<(Number number)
    {
        char digits[64];
        const auto [end, error] = std::to_chars(digits, digits + sizeof digits, number);
        return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
    }

    const std::vector<FilePart>& m_parts;
    std::vector<std::uint32_t> m_colors;   ///< each colour once, sorted
    std::size_t m_section = 0, m_next = 0; ///< section, and index of its next element
    std::string m_text;                    ///< text from m_taken on has not been read yet
    std::size_t m_taken = 0;
};

struct ModelSource
{
    ModelText text;
    std::size_t size = text.size();
};

/// The callback by which libzip reads the model part.
zip_int64_t answer(void* self, void* data, zip_uint64_t size, zip_source_cmd_t command)
{
    auto& [text, textSize] = *static_cast<ModelSource*>(self);
    switch (command) {
    case ZIP_SOURCE_OPEN:
        text.restart();
        return 0;
    case ZIP_SOURCE_READ:
        try {
            return static_cast<zip_int64_t>(text.read(static_cast<char*>(data), size));
        } catch (const std::bad_alloc&) {
            return -1;
        }
    case ZIP_SOURCE_STAT:
        zip_stat_init(static_cast<zip_stat_t*>(data));
        static_cast<zip_stat_t*>(data)->valid = ZIP_STAT_SIZE;
        static_cast<zip_stat_t*>(data)->size = textSize;
        return sizeof(zip_stat_t);
    case ZIP_SOURCE_ERROR: {
        const std::array<int, 2> error{ZIP_ER_MEMORY, ENOMEM};
        std::memcpy(data, error.data(), sizeof error);
        return sizeof error;
    }
    case ZIP_SOURCE_SUPPORTS:
        return zip_source_make_command_bitmap(ZIP_SOURCE_OPEN, ZIP_SOURCE_READ, ZIP_SOURCE_CLOSE, ZIP_SOURCE_STAT,
                                              ZIP_SOURCE_ERROR, ZIP_SOURCE_FREE, -1);
    default:
        return 0;
    }
}
} // namespace

void writeThreeMf(AtomicFile& out, const TriangleMesh& mesh, std::span<const Rgb> palette, const PartList& parts)
{
    // the first part is stored uncompressed: readMetadata() reads the palette from the file's first bytes
    std::string types(contentTypes);
    if (!palette.empty())
        types += "<!--\n# " + paletteWords(palette) + "\n-->\n";
    const FileParts pieces(mesh, parts);
    ModelSource model{ModelText(mesh, pieces)};
    ZipWriter package;
    package.add("[Content_Types].xml", types, ZipWriter::Packing::Stored);
    package.add("_rels/.rels", relationships, ZipWriter::Packing::Stored);
    package.add("3D/3dmodel.model", zip_source_function(package.archive(), &answer, &model),
                ZipWriter::Packing::Deflated);
    package.writeTo(out);
}
} // namespace core::io
