#pragma once

#include "core/io/mesh_io.h"

#include <QString>

inline void writeModel(const QString& path, const core::TriangleMesh& mesh)
{
    core::writeMesh(path.toStdU16String(), mesh);
}
