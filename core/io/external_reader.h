#pragma once

#include "core/io/mesh_io.h"

#include <functional>

namespace core
{
/// A reader of formats that core cannot read itself. The application registers it; programs made of core alone have
/// none.
struct ExternalReader
{
    /// File name extensions in lower case without dot, best known first; none that core reads itself.
    std::vector<std::string_view> endings;
    /// Reads a file. Uses the options `stop` and `keepsObjects`. Throws FileError and ReadingCancelled. The result has
    /// indices in range, finite points, and, if the points have labels, a part for each label. Points are in mm if the
    /// file states its unit, and Y is up if the file states its up axis.
    std::function<ReadResult(const std::filesystem::path& path, const ReadOptions& options)> read;
    /// Reads Draco-compressed glTF with its colours and masks; options and errors as read(). Empty: there is no such
    /// reader. `bytes` is the size of the file together with all files that it references.
    std::function<ReadResult(const std::filesystem::path& path, std::uint64_t bytes, const ReadOptions& options)>
        readDraco;
};

/// Makes readModel() use this reader for its formats. Precondition: no thread is reading a file; call it at program
/// start.
void setExternalReader(ExternalReader reader);
const ExternalReader& externalReader();
} // namespace core
