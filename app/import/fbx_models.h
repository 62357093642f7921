#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace app
{
/// An FBX file as Assimp reads it right.
struct FbxForAssimp
{
    bool isFollowed = true;             ///< false: its records could not be followed, so nothing was checked or changed
    std::optional<std::string> changed; ///< the changed file; empty: nothing has to be changed
};

/// Changes the rotations of the models of an FBX file so that Assimp turns them by the rules of FBX: geometric
/// rotations go about x, then y, then z, whatever the order of the model's own; a model whose rotations are not active
/// (by itself, or by the template of its kind) has neither an order nor rotations before and behind. Throws
/// core::FileError: TooDeep for models that hold themselves, or that are nested more than 4096 deep; ReaderRefused for
/// a rotation of the order SphericXYZ; NotANumber for a model's place, rotation or scale that is no finite number.
FbxForAssimp fbxForAssimp(const std::filesystem::path& path, std::string_view bytes);
} // namespace app
