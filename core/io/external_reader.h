#pragma once

#include "core/io/mesh_io.h"

#include <functional>

namespace core
{
/// Reads formats that core does not know; it is made where there is more than core.
struct ExternalReader
{
    std::vector<std::string_view> endings; ///< lower case, without dot, the best known first; none of ours
    /// Throws FileError and ReadingCancelled. What it gives has indices in range and finite points, in millimetres as
    /// far as the file says what it is in, with Y up as far as it says what is up.
    std::function<ReadResult(const std::filesystem::path& path, const std::stop_token& stop)> read;
    /// Reads glTF that Draco packed, as read(), colours and masks with it; empty: nobody does. `bytes`: the size of the
    /// file and of what it names.
    std::function<ReadResult(const std::filesystem::path& path, std::uint64_t bytes, const std::stop_token& stop)>
        readDraco;
};

/// From now on readModel() reads those, too. Not while any thread reads: the program's start is the place.
void setExternalReader(ExternalReader reader);
const ExternalReader& externalReader();
} // namespace core
