#include "model/formats/documents/document_fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "algorithms/core/error.h"
#include "messages/files.h"
#include "model/formats/documents/notations.h"
#include "model/formats/documents/parse_document.h"

namespace remount::formats {
namespace {

enum class Drive { Front, Rear, All };

struct Axle {
  int wheels = 2;
  double load = 0.0;
};

struct Cart {
  std::string name = "cart";
  double length_m = 1.0, width_m = 1.0, slope_rad = 0.0, reach = 0.0;
  int seats = 0, driver = 0;
  std::int64_t stamp_ns = 0;
  std::uint64_t bytes = 0;
  bool open = false, braked = false;
  Drive drive = Drive::Front, gear = Drive::Front;
  std::string owner;
  std::optional<double> height_m, draught_m;
  Message said;
  std::vector<Message> advice;
  RigidTransform cart_from_hook = RigidTransform::Identity(), cart_from_lamp = RigidTransform::Identity();
  Eigen::Vector3d up = Eigen::Vector3d::UnitZ();
  Axle axle;
  std::vector<Axle> axles;
  std::vector<double> loads;
  std::vector<bool> locks;
  std::string paint = "grey", nickname;
};

}  // namespace

void describe(RecordOf<Axle> auto& axle, auto& fields) {
  fields.on_one_line();
  fields("wheels", axle.wheels);
  fields("load", axle.load);
  fields.require(!(axle.load < 0.0), "load", say::document_negative);
}

void describe(RecordOf<Cart> auto& cart, auto& fields) {
  fields.only_written("format", DocumentNode::string("cart/1"));
  fields("name", cart.name);
  fields("length_m", cart.length_m);
  fields("width_m", cart.width_m, Finite());
  fields("slope_deg", cart.slope_rad, Degrees());
  fields("reach", cart.reach, Number{1e9});
  fields("seats", cart.seats);
  fields("driver", cart.driver, below(3));
  fields("stamp_ns", cart.stamp_ns);
  fields("bytes", cart.bytes);
  fields("open", cart.open);
  fields.where(cart.braked, "braked", cart.braked);
  fields("drive", cart.drive, OneOf{{"front", "rear", "all"}});
  fields("gear", cart.gear, Whole{0, 2});
  fields("owner", cart.owner, TextOrNull());
  fields("height_m", cart.height_m);
  fields.optional("draught_m", cart.draught_m);
  fields("said", cart.said);
  fields("advice", cart.advice);
  fields("hook", cart.cart_from_hook);
  fields.spread(cart.cart_from_lamp, kShortTransform);
  fields("up", cart.up);
  fields("axle", cart.axle);
  fields("axles", cart.axles, ListOf{Notation<Axle>(), 2});
  fields("loads", cart.loads);
  fields("locks", cart.locks);
  fields.later("paint", cart.paint);
  fields.later_or("nickname", cart.nickname, [&] { return "little " + cart.name; });
  fields.require(cart.seats < 9, say::document_negative);
}

namespace {

Cart full_cart() {
  Cart cart;
  cart.name = "hay cart";
  cart.length_m = 4.5, cart.width_m = 1.75, cart.slope_rad = 0.5, cart.reach = 2.0;
  cart.seats = 3, cart.driver = 2, cart.stamp_ns = -7, cart.bytes = 1ULL << 40U;
  cart.open = cart.braked = true;
  cart.drive = Drive::All, cart.gear = Drive::Rear;
  cart.owner = "nobody";
  cart.height_m = 2.5, cart.draught_m = 0.5;
  cart.said = Message::verbatim("squeaks");
  cart.advice = {say::document_negative(), Message::verbatim("grease it")};
  cart.cart_from_hook = rigid_from_six({1, 2, 3, 0.1, 0.2, 0.3});
  cart.cart_from_lamp = rigid_from_six({3, 2, 1, 0.1, 0.2, 0.3});
  cart.up = {0.0, 0.6, 0.8};
  cart.axle = {4, 0.5};
  cart.axles = {{2, 0.25}, {4, std::nan("")}};
  cart.loads = {1.0, std::nan("")};
  cart.locks = {true, false};
  cart.paint = "green", cart.nickname = "hay";
  return cart;
}

DocumentNode parsed(const DocumentNode& node) { return parse_yaml(to_yaml(node), "cart.yaml"); }

Cart cart_in(const DocumentNode& node) {
  Cart cart;
  read_fields(DocumentView(node, "cart.yaml"), cart);
  return cart;
}

DocumentNode& value_of_key(DocumentNode& node, std::string_view key) {
  return const_cast<DocumentNode&>(*node.find(key));
}

void remove(DocumentNode& node, std::string_view key) {
  const auto place = std::find(node.keys.begin(), node.keys.end(), key) - node.keys.begin();
  node.keys.erase(node.keys.begin() + place);
  node.items.erase(node.items.begin() + place);
}

/// What is said of a full cart that was changed.
std::string error_of(const std::function<void(DocumentNode&)>& change) {
  DocumentNode node = parsed(document_of(full_cart()));
  change(node);
  try {
    cart_in(node);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

std::string error_at(std::string_view key, const DocumentNode& value) {
  return error_of([&](DocumentNode& node) {
    const int line = value_of_key(node, key).line;
    value_of_key(node, key) = value;
    value_of_key(node, key).line = line;
  });
}

TEST(document_fields, every_kind_comes_back_as_it_was_written) {
  const Cart cart = full_cart(), back = cart_in(parsed(document_of(cart)));
  EXPECT_EQ(back.name, cart.name);
  EXPECT_EQ(back.length_m, cart.length_m);
  EXPECT_EQ(back.width_m, cart.width_m);
  EXPECT_NEAR(back.slope_rad, cart.slope_rad, 1e-15);
  EXPECT_EQ(back.reach, cart.reach);
  EXPECT_EQ(back.seats, cart.seats);
  EXPECT_EQ(back.driver, cart.driver);
  EXPECT_EQ(back.stamp_ns, cart.stamp_ns);
  EXPECT_EQ(back.bytes, cart.bytes);
  EXPECT_TRUE(back.open);
  EXPECT_TRUE(back.braked);
  EXPECT_EQ(back.drive, cart.drive);
  EXPECT_EQ(back.gear, cart.gear);
  EXPECT_EQ(back.owner, cart.owner);
  EXPECT_EQ(back.height_m, cart.height_m);
  EXPECT_EQ(back.draught_m, cart.draught_m);
  EXPECT_EQ(back.said, cart.said);
  EXPECT_EQ(back.advice, cart.advice);
  EXPECT_LT(difference(back.cart_from_hook, cart.cart_from_hook).norm(), 1e-14);
  EXPECT_LT(difference(back.cart_from_lamp, cart.cart_from_lamp).norm(), 1e-14);
  EXPECT_EQ(back.up, cart.up);
  EXPECT_EQ(back.axle.wheels, 4);
  ASSERT_EQ(back.axles.size(), 2U);
  EXPECT_EQ(back.axles[0].load, 0.25);
  EXPECT_TRUE(std::isnan(back.axles[1].load));
  ASSERT_EQ(back.loads.size(), 2U);
  EXPECT_EQ(back.loads[0], 1.0);
  EXPECT_TRUE(std::isnan(back.loads[1]));
  EXPECT_EQ(back.locks, cart.locks);
  EXPECT_EQ(back.paint, cart.paint);
  EXPECT_EQ(back.nickname, cart.nickname);
}

TEST(document_fields, keys_stand_in_the_order_of_the_description) {
  Cart cart;
  cart.slope_rad = kPi / 4;
  cart.axles = {{}, {}, {}};
  DocumentNode node = document_of(cart);
  EXPECT_EQ(value_of_key(node, "hook").keys.size(), 4U);
  value_of_key(node, "hook") = DocumentNode::null();
  EXPECT_EQ(to_yaml(node), R"(format: "cart/1"
name: cart
length_m: 1
width_m: 1
slope_deg: 45
reach: 0
seats: 0
driver: 0
stamp_ns: 0
bytes: 0
open: false
drive: front
gear: 0
owner: null
height_m: null
said: ""
advice: []
hook: null
translation_m: [0, 0, 0]
quaternion_xyzw: [0, 0, 0, 1]
up: [0, 0, 1]
axle: {wheels: 2, load: 0}
axles:
  - {wheels: 2, load: 0}
  - {wheels: 2, load: 0}
loads: []
locks: []
paint: grey
nickname: ""
)") << "the third axle is beyond what is listed";
}

TEST(document_fields, null_is_what_the_notation_says) {
  Cart cart = full_cart();
  cart.length_m = cart.slope_rad = cart.reach = std::numeric_limits<double>::infinity();
  cart.owner.clear();
  cart.height_m.reset();
  cart.draught_m.reset();
  const Cart back = cart_in(parsed(document_of(cart)));
  EXPECT_TRUE(std::isnan(back.length_m));
  EXPECT_TRUE(std::isnan(back.slope_rad));
  EXPECT_EQ(back.reach, 1e9);
  EXPECT_EQ(back.owner, "");
  EXPECT_FALSE(back.height_m);
  EXPECT_FALSE(back.draught_m);
}

TEST(document_fields, keys_that_may_be_missing_leave_the_value_or_say_what_it_is) {
  DocumentNode node = parsed(document_of(full_cart()));
  for (const char* key : {"braked", "draught_m", "paint", "nickname", "format"}) remove(node, key);
  const Cart back = cart_in(node);
  EXPECT_FALSE(back.braked);
  EXPECT_FALSE(back.draught_m);
  EXPECT_EQ(back.paint, "grey");
  EXPECT_EQ(back.nickname, "little hay cart");
}

TEST(document_fields, keys_that_are_missing_are_refused_by_their_names) {
  for (const char* key : {"name",  "length_m",      "width_m", "slope_deg", "reach", "seats",    "driver", "stamp_ns",
                          "bytes", "open",          "drive",   "gear",      "owner", "height_m", "said",   "advice",
                          "hook",  "translation_m", "up",      "axle",      "axles", "loads",    "locks"})
    EXPECT_NE(error_of([&](DocumentNode& node) { remove(node, key); }).find("\"" + std::string(key) + "\" is missing"),
              std::string::npos)
        << key;
}

TEST(document_fields, what_is_no_value_of_its_kind_is_refused_with_file_line_and_key) {
  EXPECT_EQ(error_at("seats", DocumentNode::integer(3)), "");
  EXPECT_EQ(error_at("seats", DocumentNode::integer(-1)).find("cart.yaml:7: seats: expected a whole number"), 0U)
      << error_at("seats", DocumentNode::integer(-1));
  const std::vector<std::pair<const char*, DocumentNode>> wrong{
      {"name", DocumentNode::null()},         {"length_m", DocumentNode::string("long")},
      {"width_m", DocumentNode::null()},      {"slope_deg", DocumentNode::boolean(true)},
      {"reach", DocumentNode::string("far")}, {"seats", DocumentNode::integer(3'000'000'000)},
      {"driver", DocumentNode::integer(3)},   {"stamp_ns", DocumentNode::number(0.5)},
      {"bytes", DocumentNode::integer(-1)},   {"open", DocumentNode::integer(1)},
      {"braked", DocumentNode::null()},       {"drive", DocumentNode::string("none")},
      {"gear", DocumentNode::integer(3)},     {"owner", DocumentNode::sequence()},
      {"height_m", DocumentNode::string("")}, {"draught_m", DocumentNode::string("deep")},
      {"said", DocumentNode::null()},         {"advice", DocumentNode::map()},
      {"hook", DocumentNode::null()},         {"quaternion_xyzw", DocumentNode::numbers({0, 0, 0, 2})},
      {"up", DocumentNode::numbers({0, 1})},  {"axle", DocumentNode::null()},
      {"axles", DocumentNode::null()},        {"loads", DocumentNode::integer(1)},
      {"locks", DocumentNode::numbers({1})},  {"paint", DocumentNode::null()}};
  for (const auto& [key, value] : wrong)
    EXPECT_NE(error_at(key, value).find(": " + std::string(key)), std::string::npos) << key << error_at(key, value);
}

TEST(document_fields, what_must_hold_is_refused_at_its_key_or_at_the_record) {
  const std::string negative = error_of([](DocumentNode& node) {
    value_of_key(value_of_key(node, "axles").items[1], "load") = DocumentNode::number(-1.0);
  });
  EXPECT_NE(negative.find("axles[1].load: "), std::string::npos) << negative;
  const std::string crowded = error_at("seats", DocumentNode::integer(9));
  EXPECT_EQ(crowded.find("cart.yaml:1: "), 0U) << crowded;
  EXPECT_EQ(crowded.find("seats"), std::string::npos) << crowded;
}

TEST(document_fields, a_description_knows_all_its_keys) {
  const auto refusal = [](const DocumentNode& node) {
    try {
      Notation<Cart>().allow_no_others(DocumentView(node, "cart.yaml"), Cart());
    } catch (const Error& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  DocumentNode node = parsed(document_of(full_cart()));
  EXPECT_EQ(refusal(node), "") << "those that are written only sometimes are known as well";
  node.add("wings", DocumentNode::integer(2));
  EXPECT_NE(refusal(node).find("wings: "), std::string::npos) << refusal(node);
  EXPECT_NE(refusal(node).find("draught_m"), std::string::npos) << refusal(node);
}

}  // namespace
}  // namespace remount::formats
