// Corrections of a LiDAR's beams without the mounting that they were found with, and where they are taken from.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "algorithms/cloud/beam_errors.h"
#include "algorithms/cloud/beam_options.h"
#include "algorithms/core/error.h"
#include "model/formats/documents/document.h"
#include "model/results/result_file.h"

namespace remount::results {

inline constexpr std::string_view kBeamsFormat = "remount-beams/1";

/// What "remount-beams/1" holds.
formats::DocumentNode beams_document(const cloud::BeamEstimate& beams);
/// Throws Error(Format) for what is no such document, or holds what no LiDAR errs by.
cloud::BeamEstimate beams_from_document(const formats::DocumentView& root);

/// Those that a drive told. Throws Error(`code`) at `where`, which says what to do, where there are none.
const cloud::BeamEstimate& told_beams(const ResultFile& result, ErrorCode code, const std::string& where);

/// Whether they tell the share of all ranges, which few formats of others have a place for.
bool tells_scale(const cloud::BeamEstimate& beams);

/// What is to be taken out of scans that X of the result is applied to, for it was solved from scans without; empty
/// where it was not.
cloud::BeamEstimate beams_of_scans(const ResultFile& result);

/// Of a file of "remount-beams/1" or of a result. Throws Error(Io) where there is none, Error(Format) where it holds
/// none.
cloud::BeamEstimate load_beams(const std::filesystem::path& path);
/// Of the file that the options name, for these sessions, and of the result of several LiDARs of theirs by its name;
/// empty where they name none. Throws as load_beams does, and Error(Contract) where no session has scans that could be
/// mended or the file has no such LiDAR.
cloud::BeamEstimate known_beams(const cloud::BeamOptions& options,
                                const std::vector<std::shared_ptr<const drive::Session>>& sessions);

}  // namespace remount::results
