#pragma once

#include "core/util/file_error.h"

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace app
{
/// Properties of an FBX model that Assimp does not pass on. A property that the model lacks is taken from the template.
struct FbxModel
{
    /// The ways in which a model inherits its parent's scale; RrSs, RSrs and Rrs are FBX's names.
    enum class Inherit {
        ComponentWise, ///< RrSs: the parent's scale applies along the model's own axes
        Usual,         ///< RSrs: the parent's full matrix applies
        WithoutParents ///< Rrs: the parent's scale applies to the model's position only
    };

    std::string name;
    std::vector<std::size_t> below;                  ///< indices of the child models, in Assimp's order
    Eigen::Vector3d scale = Eigen::Vector3d::Ones(); ///< the model's own scale, with signs
    Inherit inherit = Inherit::Usual;
    bool hasActiveRotations = true;
    std::size_t meshes = 0;         ///< number of meshes with faces, according to the file
    bool isLodGroup = false;        ///< whether the children are levels of detail, finest first
    bool isShown = true;            ///< whether the model itself is shown
    bool isVisible = true;          ///< whether the model is visible, with the children that inherit visibility
    bool inheritsVisibility = true; ///< whether the model is hidden if its parent is hidden
};

/// An FBX file prepared so that Assimp reads it correctly.
struct FbxForAssimp
{
    bool isFollowed = true;             ///< false: the records could not be parsed, so nothing was checked or changed
    std::optional<std::string> changed; ///< the modified file; empty: no change is needed
    std::vector<FbxModel> models;       ///< all models; the first entry is the scene itself
    /// The reason why the scene shows nothing, if it has no mesh with faces although the file has one.
    std::optional<core::FileError> whyEmpty = {};
};

/// Modifies an FBX file so that Assimp reads it by the rules of FBX.
/// Text ids are written without a sign, modulo 2^64. Binary value types unknown to Assimp are replaced by equivalent
/// types. Repeated connections of models and meshes, and connections of unknown kinds, are changed to a kind that
/// Assimp ignores.
/// Names of models in text files are cut to 900 bytes, but whole in `models`.
/// Geometric rotations are rewritten because Assimp applies the model's rotation order to them; FBX always uses XYZ.
/// Rotations of a model with inactive rotations are rewritten in the same way; addFbxScene() drops its pre- and
/// post-rotations.
/// Throws core::FileError: TooDeep for models that contain themselves or are nested more than 4096 deep. ReaderRefused
/// for a rotation in the order SphericXYZ, and for a rotation of the template that would need several values.
/// NotANumber if a transform, unit or axis is not a finite number, or, in text files, a mesh point or corner is not.
FbxForAssimp fbxForAssimp(const std::filesystem::path& path, std::string_view bytes);
} // namespace app
