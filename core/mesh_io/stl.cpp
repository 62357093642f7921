// STL: triangles as loose corners, binary or text. Corners with equal bits are welded. Colours are read where a binary file has them; none
// are written: a triangle's colour is not a vertex's.

#include "binary.h"
#include "stl_colors.h"
#include "text_scanner.h"
#include "text_writer.h"
#include "welder.h"

#include <array>
#include <bit>
#include <cmath>

namespace core::mesh_io
{
namespace
{
TriangleMesh readBinary(const FileBytes& file)
{
    TriangleMesh mesh;
    const std::size_t count = (file.bytes.size() - stlHeaderSize) / stlTriangleSize;
    Welder welder(count / 2); // as many as a closed surface has
    mesh.triangles.reserve(count);
    std::vector<std::uint16_t> words;
    words.reserve(count);
    StopCheck stopCheck(file.stop);
    for (std::size_t i = 0; i < count; ++i) {
        stopCheck();
        const char* at = file.bytes.data() + stlHeaderSize + i * stlTriangleSize + 12; // past the normal
        Triangle triangle;
        for (Slot& corner : triangle) {
            Vec3f p;
            for (int k = 0; k < 3; ++k, at += 4) {
                p[k] = load<float>(at, std::endian::little) + 0.0f; // adding 0 takes the sign from -0
                if (!std::isfinite(p[k]))
                    throw errorAtByte(FileErrorKind::NotANumber, file, at);
            }
            corner = welder.add(p);
        }
        mesh.triangles.push_back(triangle);
        words.push_back(load<std::uint16_t>(at, std::endian::little));
    }
    mesh.points = welder.takePoints();
    mesh.colors = stlColors(file.bytes.substr(0, stlHeaderSize - 4), words, mesh, stopCheck);
    return mesh;
}

class TextStlReader
{
public:
    explicit TextStlReader(const FileBytes& file) : m_file(file), m_text(file, file.bytes.data()), m_stopCheck(file.stop) {}

    TriangleMesh read()
    {
        while (readSolid()) {
        }
        m_mesh.points = m_welder.takePoints();
        return std::move(m_mesh);
    }

private:
    /// False at the end of the file.
    bool readSolid()
    {
        const std::string_view word = m_text.wordAnywhere();
        if (word.empty())
            return false;
        require(word, "solid");
        for (m_text.nextLine();; readFacet()) { // the rest of the line is a name
            const std::string_view next = m_text.wordAnywhere();
            if (is(next, "endsolid"))
                break;
            require(next, "facet");
        }
        m_text.nextLine();
        return true;
    }

    void readFacet()
    {
        m_stopCheck();
        require(m_text.wordAnywhere(), "normal");
        for (int i = 0; i < 3; ++i) // whatever it is: the corners tell
            if (m_text.wordAnywhere().empty())
                m_text.fail(FileErrorKind::Malformed, {});
        require(m_text.wordAnywhere(), "outer");
        require(m_text.wordAnywhere(), "loop");
        Triangle triangle;
        for (Slot& corner : triangle) {
            require(m_text.wordAnywhere(), "vertex");
            Vec3f p;
            for (int i = 0; i < 3; ++i)
                p[i] = m_text.toNumber(m_text.wordAnywhere()) + 0.0f;
            corner = m_welder.add(p);
        }
        require(m_text.wordAnywhere(), "endloop");
        require(m_text.wordAnywhere(), "endfacet");
        m_mesh.triangles.push_back(triangle);
    }

    static bool is(std::string_view word, std::string_view keyword)
    {
        const auto same = [](char w, char k) { return w == k || (w >= 'A' && w <= 'Z' && w - 'A' + 'a' == k); };
        return std::equal(word.begin(), word.end(), keyword.begin(), keyword.end(), same);
    }

    void require(std::string_view word, std::string_view keyword) const
    {
        if (!is(word, keyword))
            m_text.fail(FileErrorKind::Malformed, word);
    }

    FileBytes m_file;
    TextScanner m_text;
    StopCheck m_stopCheck;
    TriangleMesh m_mesh;
    Welder m_welder;
};

/// Unit normal, or 0 if the triangle has no area.
Vec3f normalOf(const std::array<Vec3f, 3>& p)
{
    const Vec3 a = p[0].cast<double>();
    const Vec3 n = (p[1].cast<double>() - a).cross(p[2].cast<double>() - a);
    const double length = std::sqrt(n.squaredNorm());
    return length > 0 ? Vec3f((n / length).cast<float>()) : Vec3f(Vec3f::Zero());
}

void writeBinary(AtomicFile& out, const TriangleMesh& mesh)
{
    std::string header = "binary STL"; // not "solid", which many take for text
    header.resize(stlHeaderSize - 4);
    append(header, static_cast<std::uint32_t>(mesh.triangles.size()));
    out.write(header);
    std::string record;
    for (const Triangle& t : mesh.triangles) {
        const std::array<Vec3f, 3> corners{mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]]};
        record.clear();
        const Vec3f normal = normalOf(corners);
        for (const Vec3f& p : {normal, corners[0], corners[1], corners[2]})
            for (int i = 0; i < 3; ++i)
                append(record, p[i] + 0.0f);
        append(record, std::uint16_t(0));
        out.write(record);
    }
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

TriangleMesh readStl(const FileBytes& file)
{
    const bool isText = !isBinaryStl(file.bytes, file.bytes.size()) && isTextStl(file.bytes.substr(0, startSize));
    return isText ? TextStlReader(file).read() : readBinary(file);
}

void writeStl(AtomicFile& out, const TriangleMesh& mesh, bool ascii)
{
    ascii ? writeText(out, mesh) : writeBinary(out, mesh);
}
} // namespace core::mesh_io
