#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace app
{
/// Returns an FBX file with the rotations of its models as Assimp turns them right, by the rules of FBX: geometric
/// rotations go about x, then y, then z, whatever the order of the model's own; a model whose rotations are not active
/// (by itself, or by the template of its kind) has neither an order nor rotations before and behind. Nothing: the file
/// is right as it is, or cannot be followed. Throws core::FileError: TooDeep for models that hold themselves, or that
/// are nested more than 4096 deep; ReaderRefused for a rotation of the order SphericXYZ.
std::optional<std::string> fbxAsAssimpReadsIt(const std::filesystem::path& path, std::string_view bytes);
} // namespace app
