#pragma once

#include "core/io/mesh/xml_reader.h"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace core::io
{
/// Another object, put somewhere.
struct ThreeMfComponent
{
    std::string part; ///< where the object is; empty: in the same part
    std::uint32_t object = 0;
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity(); ///< of columns, to the unit of the part that puts it there
};

struct ThreeMfObject
{
    TriangleMesh mesh; ///< in the part's unit; its indices are in range
    std::vector<ThreeMfComponent> components;
    bool isSolid = true;    ///< else a support, solid or not, or something else that is not the model
    std::string otherShape; ///< the extension of a shape of its own that is not read, or empty
};

/// What one model part of a 3MF holds.
struct ThreeMfPart
{
    double millimetres = 1; ///< of its unit
    std::map<std::uint32_t, ThreeMfObject> objects;
    std::vector<ThreeMfComponent> build;
    bool hasTextures = false;
    std::size_t beams = 0;
};

/// Of the package's path as a part names it: without the slash at its front. Throws FileError::Malformed where it
/// leaves the package.
std::string threeMfPath(const FileBytes& file, std::string_view path);

/// Parses a model part, which is given piece by piece. Throws FileError with lines of that part.
class ThreeMfPartReader
{
public:
    explicit ThreeMfPartReader(const FileBytes& file);
    ~ThreeMfPartReader();
    ThreeMfPartReader(const ThreeMfPartReader&) = delete;
    ThreeMfPartReader& operator=(const ThreeMfPartReader&) = delete;

    void take(std::string_view piece) { m_xml.take(piece); }
    ThreeMfPart part() { return std::move(m_part); }

private:
    struct Colors;
    void begin(std::string_view name, const XmlAttributes& attributes);
    void beginCore(std::string_view name, const XmlAttributes& attributes);
    void beginModel(const XmlAttributes& attributes);
    void beginObject(const XmlAttributes& attributes);
    void addTriangle(const XmlAttributes& attributes);
    void end(std::string_view name);
    ThreeMfComponent componentOf(const XmlAttributes& attributes) const;

    const FileBytes& m_file;
    StopCheck m_stopCheck;
    ThreeMfPart m_part;
    ThreeMfObject* m_object = nullptr; ///< the one that is being read
    std::unique_ptr<Colors> m_colors;
    XmlReader m_xml; ///< last: it calls
};
} // namespace core::io
