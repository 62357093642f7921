#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace app
{
/// A value of a record, and where it is in the file.
struct FbxValue
{
    char type = 0;               ///< of binary files as they name it; of text 'S' for what is in quotes, else 'T'
    std::size_t at = 0;          ///< byte of the file
    std::string_view bytes = {}; ///< without the quotes or the length

    /// Returns its number; empty if it is none.
    std::optional<double> number() const;
    /// Returns its whole number, of 64 bits; empty if it is none. Ids of text may be without a sign: 2^64 - 1 is -1.
    std::optional<std::int64_t> whole() const;
};

/// A record of an FBX file: name, values, and the records in its braces as far as they were asked for.
struct FbxRecord
{
    std::string_view name;
    std::vector<FbxValue> values;
    std::vector<FbxRecord> records;
};

/// Returns those records of an FBX file of version 7, binary or text, that tell of its models: its settings, the
/// property templates and properties of models, the connections, the objects, without what is in them, and of geometry
/// the arrays of points and corners. In text these have a record "a" each, which keeps only those of its values that
/// are no finite numbers. Empty if the file cannot be followed, which Assimp does not read then either. The records
/// point into `bytes`. Memory: a few times what the models take in the file.
std::optional<std::vector<FbxRecord>> fbxModelRecords(std::string_view bytes);

/// Returns the bytes of a binary file at which "Z" is the type of a value: a byte, as "C" is, which Assimp does not
/// know.
std::vector<std::size_t> fbxByteTypes(std::string_view bytes);

/// Returns the first record of the name; null if there is none.
const FbxRecord* recordIn(const std::vector<FbxRecord>& records, std::string_view name);
} // namespace app
