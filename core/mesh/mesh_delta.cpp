#include "core/mesh/mesh_delta.h"

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
    out.write(reinterpret_cast<const char*>(&counts), sizeof counts);
    out.write(reinterpret_cast<const char*>(&meshHash), sizeof meshHash);
    out.write(reinterpret_cast<const char*>(&frame), sizeof frame);
}

MeshDelta MeshDelta::read(std::istream& in)
{
    MeshDelta delta;
    readVector(in, delta.vertices);
    readVector(in, delta.edges);
    readVector(in, delta.faces);
    in.read(reinterpret_cast<char*>(&delta.counts), sizeof delta.counts);
    in.read(reinterpret_cast<char*>(&delta.meshHash), sizeof delta.meshHash);
    in.read(reinterpret_cast<char*>(&delta.frame), sizeof delta.frame);
    return delta;
}
} // namespace core
