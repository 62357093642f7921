#include "core/mesh/mesh_delta.h"

#include <algorithm>
#include <istream>
#include <ostream>

namespace core
{
namespace
{
template <class T> void writeVector(std::ostream& out, const std::vector<T>& values)
{
    const std::uint64_t count = values.size();
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
    out.write(reinterpret_cast<const char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T> void readVector(std::istream& in, std::vector<T>& values)
{
    std::uint64_t count = 0;
    if (!in.read(reinterpret_cast<char*>(&count), sizeof count))
        return;
    values.resize(count);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
}

template <class T> void writeValue(std::ostream& out, const T& value)
{
    static_assert(std::is_trivially_copyable_v<T>);
    out.write(reinterpret_cast<const char*>(&value), sizeof value);
}

template <class T> T readValue(std::istream& in)
{
    static_assert(std::is_trivially_copyable_v<T>);
    T value{};
    in.read(reinterpret_cast<char*>(&value), sizeof value);
    return value;
}

void writeFrame(std::ostream& out, const MeshFrame& frame)
{
    writeValue(out, frame.lattice.exponent());
    writeValue(out, frame.uniformDetail);
    for (const double x : frame.place)
        writeValue(out, x);
    writeValue(out, frame.parts.size());
    for (const Part& part : frame.parts.all()) {
        writeValue(out, part.id);
        writeVector(out, std::vector<char>(part.name.begin(), part.name.end()));
        writeValue(out, part.isVisible);
        writeValue(out, part.isLocked);
        writeValue(out, part.tag);
        for (const double x : part.axes.coeffs())
            writeValue(out, x);
    }
}

MeshFrame readFrame(std::istream& in)
{
    MeshFrame frame{Lattice(readValue<int>(in)), readValue<double>(in)};
    for (double& x : frame.place)
        x = readValue<double>(in);
    std::vector<Part> parts(std::min(readValue<std::size_t>(in), PartList::maxParts));
    for (Part& part : parts) {
        part.id = readValue<PartId>(in);
        std::vector<char> name;
        readVector(in, name);
        part.name.assign(name.begin(), name.end());
        part.isVisible = readValue<bool>(in);
        part.isLocked = readValue<bool>(in);
        part.tag = readValue<std::optional<Rgb>>(in);
        for (double& x : part.axes.coeffs())
            x = readValue<double>(in);
    }
    if (PartList::isUsable(parts))
        frame.parts = PartList(std::move(parts));
    return frame;
}

template <class T> std::size_t bytesOf(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}
} // namespace

std::size_t MeshDelta::bytes() const
{
    return sizeof *this + bytesOf(vertices) + bytesOf(edges) + bytesOf(faces);
}

void MeshDelta::write(std::ostream& out) const
{
    writeVector(out, vertices);
    writeVector(out, edges);
    writeVector(out, faces);
    writeValue(out, counts);
    writeValue(out, meshHash);
    writeFrame(out, frame);
}

MeshDelta MeshDelta::read(std::istream& in)
{
    MeshDelta delta;
    readVector(in, delta.vertices);
    readVector(in, delta.edges);
    readVector(in, delta.faces);
    delta.counts = readValue<SlotCounts>(in);
    delta.meshHash = readValue<std::uint64_t>(in);
    delta.frame = readFrame(in);
    return delta;
}
} // namespace core
