#pragma once

#include <string>
#include <string_view>
#include <vector>

/// The functions that a class declares. Not counted: deleted and defaulted functions, friends, functions of nested
/// classes.
struct ClassOutline
{
    std::string name; ///< qualified name such as "core::Mesh", without anonymous namespaces
    int line = 0;
    int publicFunctions = 0;  ///< including signals and slots
    int privateFunctions = 0; ///< including protected functions
};

/// A function with a body.
struct FunctionOutline
{
    std::string name; ///< qualified name such as "core::Mesh::split"
    int line = 0;
    int lines = 0; ///< from the declaration to the closing brace
};

/// The classes and functions that a C++ source defines.
struct SourceOutline
{
    std::vector<ClassOutline> classes;
    std::vector<FunctionOutline> functions;
    bool isBalanced = true; ///< false: the braces do not match, so the outline is unreliable
};

/// Parses a source in this project's style. Does not preprocess: all branches of #if are read.
SourceOutline outlineOf(std::string_view source);
