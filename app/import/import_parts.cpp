#include "app/import/import_parts.h"

#include "core/io/mesh/object_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace app
{
namespace
{
/// The properties of a part, except its name, which follows.
struct PartRecord
{
    std::array<double, 4> axes{}; ///< x, y, z and w of the quaternion
    std::uint32_t nameBytes = 0;
    core::PartId id = 0;
    core::Rgb tag{};
    std::uint8_t hasTag = 0, isVisible = 1, isLocked = 0;
};
static_assert(sizeof(PartRecord) <= 64); // see maxPackedParts

/// Returns the part, whose name is the start of `rest`, and removes the name from there. Returns nothing if the name is
/// too long, the id too high, or the axes no rotation.
std::optional<core::Part> partOf(const PartRecord& record, std::string_view& rest)
{
    if (record.nameBytes > std::min(rest.size(), core::PartList::maxNameBytes))
        return std::nullopt;
    core::Part part{record.id, core::io::cleanName(rest.substr(0, record.nameBytes)), record.isVisible != 0,
                    record.isLocked != 0, std::nullopt};
    rest.remove_prefix(record.nameBytes);
    if (record.hasTag != 0)
        part.tag = record.tag;
    part.axes.coeffs() = Eigen::Map<const Eigen::Vector4d>(record.axes.data());
    constexpr double tolerance = 1e-6;
    const bool areAxes = std::abs(part.axes.norm() - 1) <= tolerance; // false for NaN
    return areAxes && part.id <= core::maxPartId ? std::optional(std::move(part)) : std::nullopt;
}
} // namespace

std::string packedParts(const core::PartList& parts)
{
    std::string bytes;
    for (const core::Part& part : parts.all()) {
        PartRecord record{.nameBytes = static_cast<std::uint32_t>(part.name.size()),
                          .id = part.id,
                          .tag = part.tag.value_or(core::Rgb()),
                          .hasTag = part.tag ? std::uint8_t(1) : std::uint8_t(0),
                          .isVisible = part.isVisible ? std::uint8_t(1) : std::uint8_t(0),
                          .isLocked = part.isLocked ? std::uint8_t(1) : std::uint8_t(0)};
        Eigen::Map<Eigen::Vector4d>(record.axes.data()) = part.axes.coeffs();
        bytes.append(reinterpret_cast<const char*>(&record), sizeof record).append(part.name);
    }
    return bytes;
}

std::optional<core::PartList> unpackedParts(std::string_view bytes)
{
    std::vector<core::Part> parts;
    while (!bytes.empty()) {
        PartRecord record;
        if (bytes.size() < sizeof record || parts.size() == core::PartList::maxParts)
            return std::nullopt;
        std::memcpy(&record, bytes.data(), sizeof record);
        bytes.remove_prefix(sizeof record);
        auto part = partOf(record, bytes);
        if (!part)
            return std::nullopt;
        parts.push_back(*std::move(part));
    }
    return core::PartList::isUsable(parts) ? std::optional(core::PartList(std::move(parts))) : std::nullopt;
}
} // namespace app
