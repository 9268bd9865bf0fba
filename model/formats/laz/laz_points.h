// Points of compressed LAS files (LAZ).
#pragma once

#include "model/formats/laz/las_record.h"
#include "model/formats/laz/laz_layout.h"

namespace remount::formats {

/// Gives the points in the order of the file. Read are point formats 0 to 5 in LASzip's version 2 of the compression
/// and 6 to 10 in versions 3 and 4, in chunks of whatever size; memory is taken for the models of one chunk, and for
/// the list of chunks. Throws Error(Unsupported) for other ways of compressing, by name, and Error(Format) with the
/// chunk or the byte where a file is damaged: points before it were given.
void unpack_laz(const LazFile& file, const TakeRecord& take);

}  // namespace remount::formats
