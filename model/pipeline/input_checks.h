// What is wrong with the input of a calibration, before and after keyframes are looked for.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "algorithms/calibration/calibration_result.h"
#include "model/drive/session.h"
#include "model/pipeline/drive_motion.h"
#include "model/pipeline/pipeline.h"
#include "model/pipeline/register_stage.h"
#include "model/settings/settings.h"

namespace remount::pipeline {

/// The same input with what is impossible in its sessions left out (model/conventions/impossible_motion.h): every
/// method starts so.
PipelineInput with_possible_motion(PipelineInput input);

/// Throws Error(Unsupported) for a session without an INS or without a LiDAR, and Error(Contract) for sessions whose
/// INS axes differ, for they have no common X, and for one that is given twice, by path or by content: its pairs would
/// count as evidence twice. To compare contents it reads up to two scans of each session that shares stamps with
/// another, and the first of two that have equally many; scans of the same times are the same where the INS moves
/// alike, whatever points they hold; of LiDAR poses most of those that share stamps must be equal. What
/// stands still is compared by its scans alone.
void check_sessions(const std::vector<std::shared_ptr<const drive::Session>>& sessions);

/// What check_sessions says of sessions beside each other: their axes, and that none is given twice.
void check_companions(const std::vector<std::shared_ptr<const drive::Session>>& sessions);

/// Whether two sessions are one recording, as check_sessions finds it.
bool same_recording(const drive::Session& a, const drive::Session& b);

/// Throws Error(Io) where the files of a session are no longer there: a disk that was taken out while its scans were
/// read looks like a recording with fewer scans.
void refuse_vanished(const std::vector<std::shared_ptr<const drive::Session>>& sessions);

/// Why the LiDAR's stamps of a session all lie outside its INS data; for a session where none lies within.
Message why_not_covered(const DriveMotion& motion, motion::SessionIndex session);

/// Notes that keyframes were taken closer together than a spacing that was set larger than the default, since there
/// were fewer than the minimum. Says nothing where they were not.
/// @param asked_for keyframes at that spacing
void report_closer_keyframes(const drive::Session& session, const motion::KeyframeOptions& options,
                             std::size_t asked_for, std::size_t chosen, std::vector<drive::Finding>& findings);

/// The result where no pair was found, with the cause: clocks, settings, or a vehicle that stands still.
calibration::CalibrationResult result_without_pairs(const DriveMotion& motion,
                                                    const std::vector<motion::Keyframe>& keyframes,
                                                    const settings::Settings& settings);

/// The result where no scan that is needed can be read; `first` is the first message.
calibration::CalibrationResult result_without_scans(std::size_t scans, const Message& first);

/// Where all scans that `pairs` need are unreadable: the first message. Empty otherwise.
Message all_scans_unreadable(const std::vector<KeyframeObjects>& objects,
                             const std::vector<motion::Keyframe>& keyframes, const std::vector<motion::Pair>& pairs,
                             const DriveMotion& motion, std::size_t& scans);

}  // namespace remount::pipeline
