// STL: unconnected triangles, binary or text. Corners with equal bits are welded. Colours of a binary file are read.
// None are written, because STL colours triangles and Fettle colours vertices.

#include "core/io/mesh/binary.h"
#include "core/io/mesh/record_writer.h"
#include "core/io/mesh/stl_colors.h"
#include "core/io/mesh/text_scanner.h"
#include "core/io/mesh/text_writer.h"
#include "core/io/mesh/vertex_welder.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace core::io
{
namespace
{
constexpr std::size_t chunkSize = 1 << 15;

const char* cornerAt(const FileBytes& file, std::size_t corner)
{
    return file.bytes.data() + stlHeaderSize + corner / 3 * stlTriangleSize + 12 + corner % 3 * 12; // skips the normal
}

/// Returns the mesh of triangles given by their corners, after welding equal corners.
TriangleMesh meshOf(std::size_t triangles, const PointLoader& corners, const std::stop_token& stop)
{
    const WeldedPoints same = weldPoints(3 * triangles, corners, stop);
    TriangleMesh mesh;
    resizeInLargePages(mesh.points, same.firsts.size());
    forEachChunk(same.firsts.size(), chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            corners(same.firsts[i], {&mesh.points[i], 1});
    });
    resizeInLargePages(mesh.triangles, triangles);
    forEachChunk(triangles, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            mesh.triangles[i] = {same.numbers[3 * i], same.numbers[3 * i + 1], same.numbers[3 * i + 2]};
    });
    return mesh;
}

/// Throws an error at the first number that is not finite. Precondition: there is one.
[[noreturn]] void refuseNumber(const FileBytes& file)
{
    for (std::size_t corner = 0;; ++corner)
        for (const char* at = cornerAt(file, corner); at != cornerAt(file, corner) + 12; at += 4)
            if (!std::isfinite(load<float>(at, std::endian::little)))
                throw errorAtByte(FileErrorKind::NotANumber, file, at);
}

/// Returns whether the record can be a triangle: finite, with three different corners. Padding is not a triangle.
bool isTriangle(const FileBytes& file, std::size_t number)
{
    std::array<std::array<float, 3>, 3> corners;
    for (std::size_t i = 0; i < corners.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            corners[i][k] = load<float>(cornerAt(file, 3 * number + i) + 4 * k, std::endian::little);
    const auto isFinite = [](const auto& p) {
        return std::ranges::all_of(p, [](float x) { return std::isfinite(x); });
    };
    return std::ranges::all_of(corners, isFinite) && corners[0] != corners[1] && corners[1] != corners[2] &&
           corners[2] != corners[0];
}

/// Returns whether the character is a part of UTF-8 text.
bool canBeText(char c)
{
    return static_cast<unsigned char>(c) >= 0x80 || (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r');
}

/// Returns whether the bytes are UTF-8 text, which may end with padding. Nearly all triangles have other bytes.
bool isUtf8Text(std::string_view bytes)
{
    bytes = withoutPadding(bytes);
    while (!bytes.empty()) {
        const std::size_t length = utf8Length(bytes);
        if (length == 0 || !canBeText(bytes.front()))
            return false;
        bytes.remove_prefix(length);
    }
    return true;
}

/// Returns how many records of triangles come before what can be text at the end of the file.
std::size_t triangleRecordsIn(const FileBytes& file)
{
    const std::size_t all = (file.bytes.size() - stlHeaderSize) / stlTriangleSize;
    std::size_t end = withoutPadding(file.bytes).size();
    while (end > stlHeaderSize && canBeText(file.bytes[end - 1]))
        --end;
    const std::size_t before = (std::max(end, stlHeaderSize) - stlHeaderSize + stlTriangleSize - 1) / stlTriangleSize;
    return before < all && isUtf8Text(file.bytes.substr(stlHeaderSize + before * stlTriangleSize)) ? before : all;
}

/// Returns whether each edge is used as often in one direction as in the other.
bool isClosed(const TriangleMesh& mesh)
{
    std::vector<std::pair<Slot, Slot>> there, back;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            there.emplace_back(t[i], t[(i + 1) % 3]);
            back.emplace_back(t[(i + 1) % 3], t[i]);
        }
    std::ranges::sort(there);
    std::ranges::sort(back);
    return there == back;
}

/// Returns the number of triangles to read. Normally this is the header's count. All triangles in the file are read if
/// the count is 0, as written by programs that do not know it yet, or too large, or if nothing but triangles follows.
/// Text behind the triangles is not counted.
std::size_t trianglesIn(const FileBytes& file)
{
    const std::uint64_t announced = announcedStlTriangles(file.bytes),
                        room = (file.bytes.size() - stlHeaderSize) / stlTriangleSize;
    const bool isWhole = stlHeaderSize + room * stlTriangleSize == file.bytes.size();
    if (announced == 0 || announced > room)
        return triangleRecordsIn(file);
    if (announced < room && isUtf8Text(file.bytes.substr(stlHeaderSize + announced * stlTriangleSize)))
        return announced;
    for (std::uint64_t i = announced; i < room; ++i)
        if (!isWhole || !isTriangle(file, i))
            return announced;
    return room;
}

ReadResult readBinary(const FileBytes& file)
{
    const std::size_t count = trianglesIn(file);
    const auto corners = [&file](std::size_t begin, std::span<Vec3f> into) {
        for (Vec3f& p : into) {
            const char* const at = cornerAt(file, begin++);
            for (int k = 0; k < 3; ++k)
                p[k] = load<float>(at + 4 * k, std::endian::little) + 0.0F; // adding 0 removes the sign of -0
        }
    };
    TriangleMesh mesh = meshOf(count, corners, file.stop);
    if (!std::ranges::all_of(mesh.points, [](const Vec3f& p) { return p.allFinite(); }))
        refuseNumber(file);
    std::vector<std::uint16_t> words(count);
    forEachChunk(count, chunkSize, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            words[i] = load<std::uint16_t>(cornerAt(file, 3 * i) + 36, std::endian::little);
    });
    StopCheck stopCheck(file.stop);
    mesh.colors = stlColors(file.bytes.substr(0, stlHeaderSize - 4), words, mesh, stopCheck);
    const std::uint64_t announced = announcedStlTriangles(file.bytes);
    if (announced > count && announced != unknownStlTriangles && !isClosed(mesh))
        throw stlCutOff(file.path, announced, file.bytes.size());
    ReadRemarks remarks;
    remarks.bytesBehind = file.bytes.size() - stlHeaderSize - count * stlTriangleSize;
    if (announced != count) {
        remarks.announcedTriangles = announced;
        remarks.containedTriangles = count;
    }
    return {std::move(mesh), remarks};
}

/// Reads text STL word by word, independent of line ends. Normals may be missing; comments (#, ;, //) may be anywhere.
/// Skips words after a loop or a facet, and everything outside of solids.
class TextStlReader
{
public:
    explicit TextStlReader(const FileBytes& file)
        : m_file(file)
        , m_text(file, file.bytes.data())
        , m_stopCheck(file.stop)
    {}

    ReadResult read()
    {
        while (findSolid())
            readSolid();
        const auto load = [this](std::size_t begin, std::span<Vec3f> into) {
            std::ranges::copy_n(m_corners.begin() + static_cast<std::ptrdiff_t>(begin),
                                static_cast<std::ptrdiff_t>(into.size()), into.begin());
        };
        return {meshOf(m_corners.size() / 3, load, m_file.stop), {}};
    }

private:
    /// Skips everything up to the next "solid" and its name: to the next line, or to a facet on the same line. Returns
    /// false if there is no further solid.
    bool findSolid()
    {
        for (bool hasLine = true; hasLine; hasLine = m_text.nextLine()) {
            const std::string_view word = m_text.word();
            if (is(word, "facet"))
                m_text.fail(FileFault::Keyword, word, "solid");
            if (!is(word, "solid"))
                continue;
            if (!toFacetOnLine())
                m_text.nextLine();
            return true;
        }
        return false;
    }

    /// Moves to a facet on this line. Returns false, and does not move, if there is none.
    bool toFacetOnLine()
    {
        TextScanner ahead = m_text;
        for (std::size_t before = 0; !ahead.atLineEnd(); ++before) {
            if (!is(ahead.word(), "facet"))
                continue;
            if (!isBehindFacet(ahead))
                continue; // a word of the solid's name
            for (; before > 0; --before)
                m_text.word();
            return true;
        }
        return false;
    }

    /// Returns whether a facet's content follows: an optional normal, and a loop with its first vertex. A solid's name
    /// never continues so.
    static bool isBehindFacet(TextScanner words)
    {
        std::string_view word = words.wordAnywhere();
        if (is(word, "normal"))
            for (int i = 0; i < 4 && !is(word, "outer"); ++i)
                word = words.wordAnywhere();
        if (!is(word, "outer") || !is(words.wordAnywhere(), "loop"))
            return false;
        bool isAtEnd = false;
        do { // skip the words after "loop"
            isAtEnd = words.atLineEnd();
            word = words.wordAnywhere();
        } while (!isAtEnd && !is(word, "vertex") && !is(word, "facet"));
        return is(word, "vertex");
    }

    /// Reads a solid, and further solids that begin on the line where it ends.
    void readSolid()
    {
        do
            for (std::string_view word = nextWord(); !is(word, "endsolid"); word = wordAfterLine("facet"))
                readFacet(word);
        while (toFacetOnLine());
        m_text.nextLine();
    }

    void readFacet(std::string_view word)
    {
        m_stopCheck();
        require(word, "facet");
        word = nextWord();
        if (is(word, "normal"))
            for (int i = 0; i < 4 && !is(word, "outer"); ++i) // skip the normal, which follows from the corners
                word = nextWord();
        require(word, "outer");
        require(nextWord(), "loop");
        word = wordAfterLine("vertex");
        for (int corner = 0; corner < 3; ++corner) {
            require(corner == 0 ? word : nextWord(), "vertex");
            Vec3f& p = m_corners.emplace_back();
            for (int i = 0; i < 3; ++i)
                p[i] = m_text.toNumber(nextWord()) + 0.0F;
        }
        require(nextWord(), "endloop");
        require(wordAfterLine("endfacet"), "endfacet");
    }

    /// Returns the next word outside of comments; empty at the end of the file.
    std::string_view nextWord()
    {
        for (;;) {
            const std::string_view word = m_text.wordAnywhere();
            if (!word.starts_with('#') && !word.starts_with(';') && !word.starts_with("//"))
                return word;
            m_text.nextLine();
        }
    }

    /// Returns the keyword if it is on this line, else the first word of the following lines.
    std::string_view wordAfterLine(std::string_view keyword)
    {
        while (!m_text.atLineEnd())
            if (const std::string_view word = m_text.word(); is(word, keyword) || is(word, "endsolid"))
                return word;
        return nextWord();
    }

    static bool is(std::string_view word, std::string_view keyword)
    {
        const auto same = [](char w, char k) { return w == k || (w >= 'A' && w <= 'Z' && w - 'A' + 'a' == k); };
        return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), same);
    }

    void require(std::string_view word, std::string_view keyword) const
    {
        if (!is(word, keyword))
            m_text.fail(FileFault::Keyword, word, keyword);
    }

    FileBytes m_file;
    TextScanner m_text;
    StopCheck m_stopCheck;
    std::vector<Vec3f> m_corners;
};

/// Returns the unit normal, or 0 if the triangle has no area.
Vec3f normalOf(const std::array<Vec3f, 3>& p)
{
    const Vec3 a = p[0].cast<double>();
    const Vec3 n = (p[1].cast<double>() - a).cross(p[2].cast<double>() - a);
    const double length = std::sqrt(n.squaredNorm());
    return length > 0 ? Vec3f((n / length).cast<float>()) : Vec3f(Vec3f::Zero());
}

void writeBinary(AtomicFile& out, const TriangleMesh& mesh)
{
    std::string header = "binary STL"; // not "solid", which many programs take for a text file
    header.resize(stlHeaderSize - 4);
    append(header, static_cast<std::uint32_t>(mesh.triangles.size()));
    out.write(header);
    writeRecords(out, mesh.triangles.size(), stlTriangleSize, [&mesh](std::size_t i, char* into) {
        const auto& [a, b, c] = mesh.triangles[i];
        const std::array<Vec3f, 3> corners{mesh.points[a], mesh.points[b], mesh.points[c]};
        for (const Vec3f& p : {normalOf(corners), corners[0], corners[1], corners[2]})
            for (int k = 0; k < 3; ++k)
                store(into, p[k] + 0.0F);
        store(into, std::uint16_t(0));
    });
}

void writeText(AtomicFile& out, const TriangleMesh& mesh)
{
    TextWriter text(out);
    text << "solid\n";
    for (const Triangle& t : mesh.triangles) {
        const std::array<Vec3f, 3> corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
        const Vec3f n = normalOf(corners);
        text << "facet normal " << n.x() << ' ' << n.y() << ' ' << n.z() << "\n outer loop\n";
        for (const Vec3f& p : corners)
            text << "  vertex " << p.x() + 0.0f << ' ' << p.y() + 0.0f << ' ' << p.z() + 0.0f << '\n';
        text << " endloop\nendfacet\n";
    }
    text << "endsolid\n";
}
} // namespace

ReadResult readStl(const FileBytes& file)
{
    const bool isText = !isBinaryStl(file.bytes, file.bytes.size()) && isTextStl(file.bytes.substr(0, startSize));
    return isText ? TextStlReader(file).read() : readBinary(file);
}

void writeStl(AtomicFile& out, const TriangleMesh& mesh, bool ascii)
{
    ascii ? writeText(out, mesh) : writeBinary(out, mesh);
}
} // namespace core::io
