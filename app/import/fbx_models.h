#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app
{
/// Says of a model what Assimp does not hand on. What it has not of its own is by the template of its kind.
struct FbxModel
{
    /// Names the ways in which a model follows its parent's scale.
    enum class Inherit {
        ComponentWise, ///< by its own axes: RrSs
        Usual,         ///< as matrices do: RSrs
        WithoutParents ///< not at all; the place does: Rrs
    };

    std::string name;
    std::vector<std::size_t> below; ///< indices of the models below it, in the order in which Assimp has them
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(); ///< its own one, with signs
    Inherit inherit = Inherit::Usual;
    bool hasActiveRotations = true;
    std::size_t meshes = 0;         ///< number of its meshes that have faces, as the file says
    bool isLodGroup = false;        ///< whether those below it stand for each other, the finest one first
    bool isShown = true;            ///< itself
    bool isVisible = true;          ///< with those below it that inherit that
    bool inheritsVisibility = true; ///< whether it is hidden with its parent
};

/// An FBX file as Assimp reads it right.
struct FbxForAssimp
{
    bool isFollowed = true;             ///< false: its records could not be followed, so nothing was checked or changed
    std::optional<std::string> changed; ///< the changed file; empty: nothing has to be changed
    std::vector<FbxModel> models;       ///< the first one stands for the scene
};

/// Changes an FBX file so that Assimp reads it by the rules of FBX. Ids of text are written without a sign, modulo
/// 2^64, types of binary values that Assimp does not know as those that are read alike, and connections of models and
/// meshes that come again, or that are of no known kind, as some over which Assimp passes. Rotations are such that
/// Assimp turns models right: geometric rotations go about x, then y, then z, whatever the order of the model's own,
/// and so do those of a model whose rotations are not active; that it has no rotations before and behind then is left
/// to who places it. Throws core::FileError: TooDeep for models that hold themselves, or that are nested more than 4096
/// deep; ReaderRefused for a rotation of the order SphericXYZ, and for one of the template that would have to become
/// different ones; NotANumber for the place, rotation or scale of a model or the template, the file's unit or axes, or,
/// in text, a point or corner of a mesh that is no finite number.
FbxForAssimp fbxForAssimp(const std::filesystem::path& path, std::string_view bytes);
} // namespace app
