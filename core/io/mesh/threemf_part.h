#pragma once

#include "core/io/mesh/xml_reader.h"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace core::io
{
/// A reference to an object, with its placement.
struct ThreeMfComponent
{
    std::string part; ///< path of the part that contains the object; empty: the same part
    std::uint32_t object = 0;
    /// Transform of column vectors to the unit of the part that contains the reference.
    Eigen::Matrix4d transform = Eigen::Matrix4d::Identity();
};

struct ThreeMfObject
{
    TriangleMesh mesh; ///< mesh in the part's unit; indices are in range
    std::string name;  ///< a cleanName()
    std::vector<ThreeMfComponent> components;
    /// false: a support, a solid support, a mesh that changes settings in Cura, or another object that is not part of
    /// the model
    bool isSolid = true;
    std::string otherShape; ///< extension that defines this object's shape in a way that is not supported, or empty
};

/// The content of one model part of a 3MF.
struct ThreeMfPart
{
    double millimetres = 1; ///< length of the part's unit in mm
    std::map<std::uint32_t, ThreeMfObject> objects;
    std::vector<ThreeMfComponent> build;
    bool hasTextures = false;
    std::size_t beams = 0;
};

/// Returns a package path, as written in a part, without its leading slash. Throws FileError::Malformed if it leaves
/// the package.
std::string threeMfPath(const FileBytes& file, std::string_view path);

/// Parses a model part, which is passed piece by piece. Throws FileError with lines of that part.
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
    /// Begins a setting of Cura for the object.
    void beginSetting(std::string_view name);
    void addTriangle(const XmlAttributes& attributes);
    void end(std::string_view name);
    ThreeMfComponent componentOf(const XmlAttributes& attributes) const;

    const FileBytes& m_file;
    StopCheck m_stopCheck;
    ThreeMfPart m_part;
    ThreeMfObject* m_object = nullptr; ///< the object that is being read
    bool m_isInOtherUse = false;       ///< in a setting that says whether the object is no material
    std::string m_otherUse;            ///< value of that setting
    std::unique_ptr<Colors> m_colors;
    XmlReader m_xml; ///< declared last, because its callbacks use the other members
};
} // namespace core::io
