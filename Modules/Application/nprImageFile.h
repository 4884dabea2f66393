// SPDX-FileCopyrightText: Copyright (c) 2026 the vtkNPR authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file nprImageFile.h
 * @brief Files that are either written whole or not at all.
 */
#ifndef nprImageFile_h
#define nprImageFile_h

#include <functional>
#include <string>
#include <vector>

class vtkImageData;

namespace npr
{
/// In lower case, with its dot.
std::string ExtensionOf(const std::string& file);

/// Before any long work: is the extension one that can be written, does the folder exist?
/// Throws a CommandError that says what to do.
/// `others` are extensions that somebody else writes, for the message.
void CheckImageFile(const std::string& file, const std::vector<std::string>& others = {});
void CheckWritable(const std::string& file);
/// Throws a CommandError where images of the file's kind have no transparent pixels.
void CheckTransparency(const std::string& file);

void WriteImage(vtkImageData* image, const std::string& file);

/// Calls write with a name beside the file, which becomes the file only when write returned true.
void WriteWhole(const std::string& file, const std::function<bool(const std::string&)>& write);
}

#endif
