#include "model/results/result_file.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/core/error.h"
#include "algorithms/messages/render.h"
#include "model/formats/documents/parse_document.h"
#include "model/formats/documents/transform_document.h"
#include "model/settings/settings_file.h"

namespace remount::results {

using formats::DocumentNode;

namespace {

ResultFile example_file() {
  ResultFile file;
  calibration::CalibrationResult& result = file.result;
  result.status = calibration::Status::Degenerate;
  result.message = Message::verbatim("Solved; z is not observed.");
  result.advice = {Message::verbatim("Drive a ramp: z needs motion about a level axis.")};
  result.mounting.reference_from_sensor = rigid_from_six({0.9, -0.25, 0.75, 0.3, -0.02, 0.015});
  result.set_observed(~calibration::ParameterSet{calibration::Parameter::Z},
                      Message::verbatim("not shown by this drive"));
  for (int i = 0; i < 6; ++i)
    for (int k = 0; k < 6; ++k)
      result.covariance(i, k) = i == 2 || k == 2 ? std::nan("") : i == k ? 1e-4 * (i + 1) : 1e-7;
  constexpr double kBootstrap[] = {0.01, 0.02, 0.0, 0.003, 0.002, 0.001};
  for (const calibration::Parameter parameter : calibration::kParameters)
    if (parameter != calibration::Parameter::Z)
      result.known[parameter].bootstrap_sigma = kBootstrap[calibration::row_of(parameter)];
  result.directions.push_back(
      {Vector6d::Unit(2), std::numeric_limits<double>::infinity(), false, Message::verbatim("height z: flat driving")});
  result.pairs_proposed = 10, result.pairs_accepted = 7, result.pairs_rejected = 3;
  result.frobenius_sum = 0.123, result.rotation_rms_rad = 1e-4, result.translation_rms_m = 0.0123;
  result.time_offset = {0.0123, 0.001, false};
  result.candidates.push_back(
      {calibration::MountingSource::ParkMartin, result.mounting.reference_from_sensor, 0.123, true, {}});
  result.candidates.push_back({calibration::MountingSource::pair(motion::PairIndex{3}),
                               rigid_from_six({9, 0, 0, 3.0, 0, 0}), 5.0, false,
                               Message::verbatim("x = 9 m is above 5 m")});
  file.nominal_ins_from_lidar = rigid_from_six({1, 0, 1, 0, 0, 0});
  file.pairs.push_back({motion::SessionIndex{0}, 1317636475123456789LL, 1317636476123456789LL,
                        motion::PairState::Rejected, motion::DecidedBy::User, Message::verbatim("by \"hand\": no"), 0.1,
                        2.0, 0.03, 0.7, 1.2, 0.001, 0.02, 0.5, 9});
  file.findings = {
      {drive::Severity::Warning, "scan-unreadable", std::string("drive"), Message::verbatim("scan 7 was skipped")}};
  file.ins_axes = drive::InsAxes::RightForwardUp;
  file.settings.solve.max_listed_candidates = 55;
  file.inputs.push_back({"drive", "ins.csv", 123, std::string(64, 'a')});
  return file;
}

ResultFile read_back(const std::string& text, bool json) {
  const DocumentNode node = json ? formats::parse_json(text, "r.json") : formats::parse_yaml(text, "r.yaml");
  return result_from_document(formats::DocumentView(node, "r"));
}

std::string reading_error(const DocumentNode& node) {
  try {
    result_from_document(formats::DocumentView(node, "r"));
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

DocumentNode& member(DocumentNode& node, std::string_view key) { return const_cast<DocumentNode&>(*node.find(key)); }

TEST(result_file, reads_back_what_it_wrote_in_both_formats) {
  const ResultFile file = example_file();
  const std::string json = formats::to_json(result_document(file)), yaml = formats::to_yaml(result_document(file));
  EXPECT_EQ(formats::to_json(result_document(read_back(json, true))), json);
  EXPECT_EQ(formats::to_json(result_document(read_back(yaml, false))), json);
  const ResultFile back = read_back(yaml, false);
  EXPECT_EQ(back.result.mounting.reference_from_sensor.matrix(), file.result.mounting.reference_from_sensor.matrix());
  EXPECT_FALSE(back.result.estimate(calibration::Parameter::Z).sigma.has_value());
  EXPECT_DOUBLE_EQ(*back.result.estimate(calibration::Parameter::Yaw).sigma,
                   *file.result.estimate(calibration::Parameter::Yaw).sigma);
  EXPECT_EQ(back.pairs.at(0).stamp_a_ns, 1317636475123456789LL);
  EXPECT_EQ(back.pairs.at(0).reason, Message::verbatim("by \"hand\": no"));
  EXPECT_EQ(settings::settings_text(back.settings), settings::settings_text(file.settings));
  EXPECT_EQ(back.ins_axes, drive::InsAxes::RightForwardUp);
  DocumentNode unknown = result_document(file), older = unknown;
  member(unknown, "ins_axes") = DocumentNode::null();
  const auto place = std::find(older.keys.begin(), older.keys.end(), "ins_axes") - older.keys.begin();
  older.keys.erase(older.keys.begin() + place);
  older.items.erase(older.items.begin() + place);
  for (const DocumentNode& node : {unknown, older})
    EXPECT_FALSE(result_from_document(formats::DocumentView(node, "r")).ins_axes) << "a file need not say";
}

TEST(result_file, has_the_documented_keys_and_orders) {
  const DocumentNode node = result_document(example_file());
  const formats::DocumentView root(node, "r");
  EXPECT_EQ(root.at("format").string(), "remount-result/2");
  EXPECT_EQ(root.at("status").string(), "degenerate");
  EXPECT_EQ(root.at("ins_from_lidar").at("translation_m").numbers(3), (std::vector<double>{0.9, -0.25, 0.75}));
  EXPECT_EQ(root.at("ins_from_lidar").at("quaternion_xyzw").numbers(4).size(), 4U);
  const auto angles = root.at("ins_from_lidar").at("yaw_pitch_roll_deg").numbers(3);
  EXPECT_NEAR(angles[0], radians_to_degrees(0.3), 1e-12);
  EXPECT_NEAR(angles[1], radians_to_degrees(-0.02), 1e-12);
  EXPECT_NEAR(angles[2], radians_to_degrees(0.015), 1e-12);
  EXPECT_EQ(root.at("ins_from_lidar").at("matrix").items().size(), 4U);
  EXPECT_TRUE(root.at("sigma").at("translation_m").items().at(2).is_null());
  const auto rotation = root.at("sigma").at("rotation_deg").numbers(3);
  EXPECT_NEAR(rotation[0], radians_to_degrees(std::sqrt(6e-4)), 1e-12) << "roll comes first";
  EXPECT_NEAR(rotation[2], radians_to_degrees(std::sqrt(4e-4)), 1e-12) << "yaw comes last";
  EXPECT_FALSE(root.at("observed").at("z").boolean());
  EXPECT_EQ(root.at("pairs").at("rejected").integer(0, 100), 3);
  EXPECT_EQ(root.at("error").at("frobenius_sum").number(), 0.123);
  EXPECT_EQ(root.at("time_offset_s").number(), 0.0123);
  EXPECT_EQ(root.at("candidates").items().size(), 2U);
  EXPECT_FALSE(root.at("provenance").at("version").string().empty());
  EXPECT_EQ(root.at("provenance").at("settings").at("solve").at("max_listed_candidates").integer(0, 99), 55);
}

TEST(result_file, matrix_quaternion_and_angles_agree_for_any_rotation) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    Eigen::Quaterniond q(normal(random), normal(random), normal(random), normal(random));
    RigidTransform x = make_rigid(q.normalized().toRotationMatrix(), {normal(random), normal(random), normal(random)});
    if (i % 4 == 0) x = rigid_from_six({1, 2, 3, i % 8 ? kPi : -kPi, (i % 3 - 1) * (kPi / 2 - 1e-9 * (i % 5)), 0.1});
    const DocumentNode node = formats::transform_document(x);
    const RigidTransform back =
        formats::transform_from_document(formats::DocumentView(node, "r"));  // throws where they disagree
    EXPECT_LT((back.matrix() - x.matrix()).cwiseAbs().maxCoeff(), 1e-14);
  }
}

TEST(result_file, of_the_former_format_with_plain_sentences_is_read) {
  DocumentNode node = result_document(example_file());
  member(node, "format").text = "remount-result/1";
  member(node, "message") = DocumentNode::string("Solved, but for z.");
  member(node, "advice") = DocumentNode::sequence();
  member(node, "advice").add(DocumentNode::string("Drive a ramp."));
  member(member(node, "pair_list").items.at(0), "reason") = DocumentNode::string("overlap too small");
  const ResultFile file = result_from_document(formats::DocumentView(node, "r"));
  EXPECT_EQ(english(file.result.message), "Solved, but for z.");
  EXPECT_EQ(english(file.result.advice), std::vector<std::string>{"Drive a ramp."});
  EXPECT_EQ(english(file.pairs.at(0).reason), "overlap too small");
}

TEST(result_file, damaged_files_are_refused_with_the_place) {
  const DocumentNode good = result_document(example_file());
  ASSERT_EQ(reading_error(good), "");
  DocumentNode node = good;
  member(node, "format").text = "remount-result/9";
  EXPECT_NE(reading_error(node).find("format: expected \"remount-result/2\""), std::string::npos);
  node = good;
  member(member(node, "ins_from_lidar"), "matrix").items[0].items[0].text = "0.5";
  EXPECT_NE(reading_error(node).find("not orthonormal"), std::string::npos);
  node = good;
  member(member(node, "ins_from_lidar"), "matrix").items[0].items[3].text = "0.95";
  EXPECT_NE(reading_error(node).find("contradicts itself"), std::string::npos);
  node = good;
  member(member(node, "ins_from_lidar"), "translation_m").items[0].text = ".nan";
  EXPECT_NE(reading_error(node).find("finite number"), std::string::npos);
  node = good;
  member(member(node, "sigma"), "translation_m").items[2] = DocumentNode::number(0.1);
  EXPECT_NE(reading_error(node).find("z, which is not observed"), std::string::npos) << reading_error(node);
  node = good;
  member(node, "status").text = "great";
  EXPECT_NE(reading_error(node).find("not a status"), std::string::npos);
  for (const char* key :
       {"format", "status", "ins_from_lidar", "observed", "sigma", "pairs", "error", "candidates", "provenance"}) {
    node = good;
    for (std::size_t i = 0; i < node.keys.size(); ++i)
      if (node.keys[i] == key) node.keys[i] = "other";
    EXPECT_NE(reading_error(node).find(key), std::string::npos) << key;
  }
}

TEST(result_file, settings_of_another_version_do_not_make_a_result_unreadable) {
  DocumentNode node = result_document(example_file());
  DocumentNode& provenance = member(node, "provenance");
  member(provenance, "settings").items[0].keys[0] = "setting_of_the_future";
  EXPECT_NE(reading_error(node).find("setting_of_the_future"), std::string::npos) << reading_error(node);
  member(provenance, "version").text = "99.0";
  EXPECT_EQ(reading_error(node), "");
}

TEST(result_file, mutated_files_never_crash) {
  const std::string good = formats::to_yaml(result_document(example_file()));
  std::mt19937 random(11);
  int refused = 0;
  for (int i = 0; i < 300; ++i) {
    std::string text = good;
    text[random() % text.size()] = static_cast<char>(random() % 256);
    try {
      read_back(text, false);
    } catch (const Error&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 30);
}

TEST(result_file, says_which_topics_of_bags_it_was_made_of) {
  ResultFile file = example_file();
  file.topics = {{"drive", {{"lidar", "/front/points"}, {"ins", "/ins/imu"}, {"gnss", "none"}}, {{"gnss", "none"}}},
                 {"other", {}, {}}};
  const ResultFile back = read_back(formats::to_yaml(result_document(file)), false);
  ASSERT_EQ(back.topics.size(), 2U);
  EXPECT_EQ(back.topics[0].session, "drive");
  EXPECT_EQ(back.topics[0].topics, file.topics[0].topics);
  EXPECT_EQ(back.topics[0].asked, file.topics[0].asked);
  EXPECT_TRUE(back.topics[1].asked.empty());
  EXPECT_TRUE(read_back(formats::to_yaml(result_document(example_file())), false).topics.empty())
      << "a former version wrote it";
  DocumentNode node = result_document(file);
  DocumentNode& topics = member(member(member(node, "provenance"), "topics").items[0], "topics");
  topics.keys[0] = "camera";
  EXPECT_NE(reading_error(node).find("known are lidar, ins"), std::string::npos) << reading_error(node);
  node = result_document(file);
  member(member(node, "provenance"), "topics").items[0].keys[0] = "name";
  EXPECT_NE(reading_error(node).find("session"), std::string::npos) << reading_error(node);
}

TEST(result_file, keeps_the_frames_of_its_mounting_and_refuses_unknown_ones) {
  ResultFile file = example_file();
  for (const calibration::BodyFrame reference : calibration::kFrames)
    for (const calibration::BodyFrame sensor : calibration::kFrames) {
      file.result.mounting.reference = reference;
      file.result.mounting.sensor = sensor;
      EXPECT_EQ(read_back(formats::to_yaml(result_document(file)), false).result.mounting.frames(),
                (calibration::MountingFrames{reference, sensor}));
    }
  for (const char* key : {"reference_frame", "calibrated"}) {
    DocumentNode node = result_document(file);
    member(node, key) = DocumentNode::string("trailer");
    EXPECT_NE(reading_error(node).find("expected a frame"), std::string::npos) << reading_error(node);
    EXPECT_NE(reading_error(node).find("trailer"), std::string::npos) << reading_error(node);
  }
}

TEST(result_file, says_again_why_a_parameter_is_not_observed) {
  ResultFile file = example_file();
  calibration::ObservabilityDirection up;
  up.direction = Vector6d::Unit(2);
  up.observed = false;
  up.words = Message::verbatim("height: flat driving");
  file.result.directions = {up};
  const calibration::Estimate z =
      read_back(formats::to_yaml(result_document(file)), false).result.estimate(calibration::Parameter::Z);
  EXPECT_FALSE(z.sigma);
  EXPECT_EQ(english(z.why_not_observed), "height: flat driving");
}

TEST(result_file, usable_needs_a_solution_and_something_observed) {
  calibration::CalibrationResult result = example_file().result;
  EXPECT_TRUE(calibration::is_usable(result));
  EXPECT_EQ(calibration::parameter_names(~result.observed()), "z");
  result.set_observed({}, Message::verbatim("not shown by this drive"));
  EXPECT_FALSE(calibration::is_usable(result));
  result.set_observed(calibration::ParameterSet::all(), {});
  result.status = calibration::Status::Inconsistent;
  EXPECT_FALSE(calibration::is_usable(result));
}

}  // namespace
}  // namespace remount::results
