// The journal: what goes in comes out in order, page by page, by every filter, and old entries go.
#include "store/journal.h"

#include "base/sentence.h"
#include "store/store_fixture.h"

namespace tessera::store {
namespace {

using supervisor::Severity;
using test::note;

class JournalOf : public test::StoreTest {
protected:
  JournalOf() : database_{open()}, journal_{*database_} {}
  std::vector<std::string> sentences(const JournalFilter& filter = {}) {
    const auto page = journal_.query(filter);
    if (!page) ADD_FAILURE() << page.error().sentence;
    std::vector<std::string> all;
    for (const JournalEntry& entry : page->entries) all.push_back(entry.sentence);
    return all;
  }

  std::unique_ptr<Database> database_;
  Journal journal_;
};

using Texts = std::vector<std::string>;

TEST_F(JournalOf, givesBackEveryPartOfAnEvent) {
  Note one = note(1'700'000'000'123, "Vehicle 3 stands.", Severity::Error, VehicleId{3});
  one.event.kind = supervisor::EventKind::Obstacle;
  one.event.over = true;
  ASSERT_TRUE(journal_.append(std::vector{one}));
  const auto entries = journal_.query({}).value().entries;
  ASSERT_EQ(entries.size(), 1U);
  JournalEntry expected;
  expected.id = entries[0].id;
  expected.utcMs = 1'700'000'000'123;
  expected.site = "Hall";
  expected.vehicle = VehicleId{3};
  expected.severity = Severity::Error;
  expected.kind = "obstacle";
  expected.over = true;
  expected.sentence = "Vehicle 3 stands.";
  expected.wording = {"Vehicle 3 stands.", false, {}};
  EXPECT_EQ(entries[0], expected);
}

TEST_F(JournalOf, givesBackWhatASentenceWasMadeOf) {
  Note one = note(1, "");
  one.event.sentence = phrase("Core", "%1 waits for %2 (%3 m).")
                           .with("Wagen \"7\" 地", phrase("Core", "the charging place %1").with(4), "1.5");
  ASSERT_TRUE(journal_.append(std::vector{one}));
  const auto entry = journal_.query({}).value().entries.at(0);
  EXPECT_EQ(entry.sentence, "Wagen \"7\" 地 waits for the charging place 4 (1.5 m).");
  const Wording expected{
      "%1 waits for %2 (%3 m).",
      true,
      {{"Wagen \"7\" 地", false, {}}, {"the charging place %1", true, {{"4", false, {}}}}, {"1.5", false, {}}}};
  EXPECT_EQ(entry.wording, expected);
}

TEST_F(JournalOf, findsByTimeVehicleSeveritySiteAndText) {
  Note other = note(40, "elsewhere");
  other.site = "Yard";
  ASSERT_TRUE(journal_.append(std::vector{note(10, "Alpha 100%", Severity::Info, VehicleId{1}),
                                          note(20, "beta_x", Severity::Warning, VehicleId{2}),
                                          note(30, "gamma ALPHA", Severity::Error), other}));
  EXPECT_EQ(sentences(), (Texts{"elsewhere", "gamma ALPHA", "beta_x", "Alpha 100%"}));
  EXPECT_EQ(sentences({.fromUtcMs = 20, .untilUtcMs = 40}), (Texts{"gamma ALPHA", "beta_x"}));
  EXPECT_EQ(sentences({.vehicle = VehicleId{2}}), (Texts{"beta_x"}));
  EXPECT_EQ(sentences({.site = "Yard"}), (Texts{"elsewhere"}));
  EXPECT_EQ(sentences({.atLeast = Severity::Warning}), (Texts{"gamma ALPHA", "beta_x"}));
  EXPECT_EQ(sentences({.text = "alpha"}), (Texts{"gamma ALPHA", "Alpha 100%"}));
  EXPECT_EQ(sentences({.text = "0%"}), (Texts{"Alpha 100%"}));
  EXPECT_EQ(sentences({.text = "a_x"}), (Texts{"beta_x"}));
  EXPECT_EQ(sentences({.text = "'; DROP TABLE journal; --"}), Texts{});
  EXPECT_EQ(sentences({.text = std::string(200'000, '%')}), Texts{});
}

TEST_F(JournalOf, givesPagesThatDoNotShiftWhenMoreIsWrittenOrTheClockIsSetBack) {
  for (int i = 0; i < 25; ++i) ASSERT_TRUE(journal_.append(std::vector{note(1000 - i, std::to_string(i))}));
  JournalFilter filter{.limit = 10};
  Texts all;
  for (int page = 0; page < 3; ++page) {
    const auto found = journal_.query(filter).value();
    EXPECT_EQ(found.more, page < 2);
    for (const JournalEntry& entry : found.entries) all.push_back(entry.sentence);
    filter.beforeId = found.entries.back().id;
    ASSERT_TRUE(journal_.append(std::vector{note(5, "later")}));
  }
  ASSERT_EQ(all.size(), 25U);
  for (int i = 0; i < 25; ++i) EXPECT_EQ(all[static_cast<std::size_t>(i)], std::to_string(24 - i));
}

TEST_F(JournalOf, losesTheOldestByAgeAndByNumber) {
  std::vector<Note> many;
  for (int i = 0; i < 45'000; ++i) many.push_back(note(i, "n"));
  ASSERT_TRUE(journal_.append(many));
  EXPECT_EQ(journal_.prune(41'000, 1'000'000).value(), 41'000);
  EXPECT_EQ(journal_.prune(0, 10).value(), 3990);
  const auto rest = journal_.query({.limit = 100}).value().entries;
  ASSERT_EQ(rest.size(), 10U);
  EXPECT_EQ(rest.front().utcMs, 44'999);
  EXPECT_EQ(rest.back().utcMs, 44'990);
  EXPECT_EQ(journal_.prune(0, 10).value(), 0);
  EXPECT_EQ(journal_.prune(0, 0).value(), 10);
  EXPECT_EQ(journal_.prune(0, 0).value(), 0);
}

TEST_F(JournalOf, tellsOfEntriesThatWereLost) {
  ASSERT_TRUE(journal_.appendLoss(17, 99));
  const auto entry = journal_.query({}).value().entries.at(0);
  EXPECT_EQ(entry.kind, kEntriesLost);
  EXPECT_EQ(entry.sentence, "Entries before this one were lost because the journal could not be written: 17.");
  EXPECT_EQ(entry.severity, Severity::Warning);
  EXPECT_EQ(entry.utcMs, 99);
}

}  // namespace
}  // namespace tessera::store
