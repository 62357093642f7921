// Source: the code of PrusaSlicer (Metadata/Slic3r_PE_model.config) and of Bambu Studio (model_settings.config).
#include "core/io/mesh/threemf_slicer_parts.h"

#include "core/io/mesh/xml_reader.h"

namespace core::io
{
namespace
{
/// Gathers the volumes of PrusaSlicer's file: an element `volume` with the numbers of its triangles, in it metadata.
class VolumeReader
{
public:
    explicit VolumeReader(ThreeMfSlicerParts& parts) : m_parts(parts) {}

    void begin(std::string_view name, const XmlAttributes& attributes)
    {
        if (name == "object") {
            m_object = attributes.whole("id");
        } else if (name == "volume") {
            m_volume = {attributes.whole("firstid"), attributes.whole("lastid"), false};
            m_isMatter = true;
        } else if (name == "metadata" && attributes.text("type") == "volume") {
            const std::string_view key = attributes.text("key"), value = attributes.text("value");
            if (key == "volume_type" && value != "ModelPart") {
                m_isMatter = false;
                m_volume.isNegative = value == "NegativeVolume";
            } else if (key == "modifier" && value == "1") { // before PrusaSlicer 1.42
                m_isMatter = false;
            }
        }
    }
    void end(std::string_view name)
    {
        if (name == "volume" && !m_isMatter)
            m_parts.triangles[m_object].push_back(m_volume);
    }

private:
    ThreeMfSlicerParts& m_parts;
    std::uint32_t m_object = 0;
    ThreeMfSlicerParts::Triangles m_volume;
    bool m_isMatter = true;
};

void readPart(const FileBytes& file, ZipReader& package, const std::string& name, XmlReader::Begin begin,
              XmlReader::End end)
{
    const std::optional<std::string> part = package.find(name);
    if (!part)
        return;
    XmlReader xml(file, std::move(begin), std::move(end));
    package.read(*part, [&xml](std::string_view piece) { xml.take(piece); });
}
} // namespace

ThreeMfSlicerParts ThreeMfSlicerParts::in(const FileBytes& file, ZipReader& package)
{
    ThreeMfSlicerParts parts;
    try {
        VolumeReader volumes(parts);
        readPart(
            file, package, "Metadata/Slic3r_PE_model.config",
            [&](std::string_view name, const XmlAttributes& attributes) { volumes.begin(name, attributes); },
            [&](std::string_view name) { volumes.end(name); });
        readPart(
            file, package, "Metadata/model_settings.config",
            [&](std::string_view name, const XmlAttributes& attributes) {
                if (name == "part" && attributes.text("subtype") == "negative_part")
                    parts.negativeObjects.insert(attributes.whole("id"));
            },
            [](std::string_view) {});
    } catch (const FileError&) {
        return {}; // the model does not need it
    }
    return parts;
}
} // namespace core::io
