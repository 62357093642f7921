#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

namespace app
{
/// A value of an FBX record, and its position in the file.
struct FbxValue
{
    char type = 0;               ///< in binary files FBX's type letter; in text 'S' if quoted, 'T' otherwise
    std::size_t at = 0;          ///< offset in the file, bytes
    std::string_view bytes = {}; ///< the value's bytes, without quotes or length field

    /// Returns the value as a number; nothing if it is not a number.
    std::optional<double> number() const;
    /// Returns the value as a 64-bit integer; nothing if it is not an integer. Unsigned text ids wrap: 2^64 - 1 is -1.
    std::optional<std::int64_t> whole() const;
};

/// A record of an FBX file: its name, its values, and the requested records in its braces.
struct FbxRecord
{
    std::string_view name;
    std::vector<FbxValue> values;
    std::vector<FbxRecord> records;
};

/// Returns the records that describe the models of an FBX file of version 7, binary or text. They are: settings, the
/// models' property templates and properties, connections, objects without their content, and the point and corner
/// arrays of geometry.
/// In text, each array has a record "a" that keeps only the values that are not finite numbers.
/// Returns nothing if the file cannot be parsed; Assimp does not read such a file either. The records point into
/// `bytes`. Cost: memory of a few times the size of the models in the file.
std::optional<std::vector<FbxRecord>> fbxModelRecords(std::string_view bytes);

/// Returns the offsets in a binary file where a value has the type "Z". Assimp does not know it; it is a byte, like
/// type "C".
std::vector<std::size_t> fbxByteTypes(std::string_view bytes);

/// Returns the first record with this name; null if there is none.
const FbxRecord* recordIn(const std::vector<FbxRecord>& records, std::string_view name);
} // namespace app
