#include "core/journal/journal_base.h"

#include "core/journal/delta_images.h"

#include "core/util/atomic_file.h"

#include <algorithm>

namespace core
{
namespace
{
constexpr Slot slotsPerPart = 1 << 16; ///< one part is then about 5 MB
} // namespace

void writeBase(const std::filesystem::path& file, const Mesh& mesh, const BaseRecord& base, std::uint64_t number)
{
    AtomicFile out(file);
    const SlotCounts counts = mesh.slots();
    const Slot end = std::max({counts.vertices, counts.edges, counts.faces});
    for (Slot first = 0; first < end; first += slotsPerPart) {
        out.write(pack(PartRecord{imageOf(mesh, first, first + slotsPerPart)}, 0));
        out.sync();
    }
    out.write(pack(base, number));
    out.commit();
}
} // namespace core
