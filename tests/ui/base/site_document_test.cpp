// The open site: steps are named, undone to nothing and redone, a drag is one step, a contradiction changes nothing.
#include "ui/base/site_document.h"

#include <gtest/gtest.h>

#include <QSignalSpy>
#include <random>

namespace tessera::ui {
namespace {

floor::Route routeCalled(const std::string& name) {
  return {name, {{Metres{0}, Metres{0}}, {Metres{1}, Metres{0}}}, Metres{0.2}};
}

class OpenDocument : public ::testing::Test {
protected:
  Result<void> add(const std::string& name) {
    return document.edit("Add route", [&](floor::Site& site) { site.routes.push_back(routeCalled(name)); });
  }
  void drag(double x, int key) {
    ASSERT_TRUE(document.edit(
        "Move vertex", [&](floor::Site& s) { s.routes[0].vertices[1].x = Metres{x}; }, key));
  }
  [[nodiscard]] double x() const { return document.site().routes.at(0).vertices[1].x.value(); }

  SiteDocument document;
  QSignalSpy changed{&document, &SiteDocument::changed};
  QSignalSpy modified{&document, &SiteDocument::modifiedChanged};
};

TEST_F(OpenDocument, beginsEmptyAndUnmodified) {
  ASSERT_NE(document.map(), nullptr);
  EXPECT_EQ(document.site(), floor::Site{});
  EXPECT_EQ(document.path(), "");
  EXPECT_FALSE(document.isModified());
}

TEST_F(OpenDocument, undoesToNothingAndRedoes) {
  ASSERT_TRUE(add("north"));
  ASSERT_TRUE(add("south"));
  EXPECT_NE(document.map()->route("south"), nullptr);
  const floor::Site full = document.site();
  EXPECT_EQ(document.undoStack().undoText(), "Add route");
  document.undoStack().undo();
  EXPECT_EQ(document.map()->route("south"), nullptr);
  EXPECT_NE(document.map()->route("north"), nullptr);
  document.undoStack().undo();
  EXPECT_EQ(document.site(), floor::Site{});
  EXPECT_FALSE(document.undoStack().canUndo());
  document.undoStack().redo();
  document.undoStack().redo();
  EXPECT_EQ(document.site(), full);
  EXPECT_NE(document.map()->route("south"), nullptr);
  EXPECT_EQ(changed.size(), 6);
}

TEST_F(OpenDocument, leavesWhoHoldsTheOldMapUndisturbed) {
  ASSERT_TRUE(add("north"));
  const auto before = document.map();
  ASSERT_TRUE(add("south"));
  EXPECT_EQ(before->site().routes.size(), 1U);
}

TEST_F(OpenDocument, makesOneStepOfADrag) {
  ASSERT_TRUE(add("north"));
  for (int i = 2; i < 50; ++i) drag(i, 7);
  drag(99, 8);
  EXPECT_EQ(document.undoStack().count(), 3);
  document.undoStack().undo();
  EXPECT_EQ(x(), 49);
  document.undoStack().undo();
  EXPECT_EQ(x(), 1);
}

TEST_F(OpenDocument, forgetsADragThatEndsWhereItBegan) {
  ASSERT_TRUE(add("north"));
  drag(2, 7);
  drag(1, 7);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(x(), 1);
}

TEST_F(OpenDocument, doesNotMergeStepsWithoutAKey) {
  ASSERT_TRUE(add("north"));
  drag(2, 0);
  drag(3, 0);
  EXPECT_EQ(document.undoStack().count(), 3);
}

TEST_F(OpenDocument, refusesWhatContradictsItselfAndChangesNothing) {
  ASSERT_TRUE(add("north"));
  const auto before = document.map();
  const auto refused = add("north");
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.english().find("north"), std::string::npos) << refused.error().sentence;
  EXPECT_EQ(document.map(), before);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_EQ(changed.size(), 1);
}

TEST_F(OpenDocument, isMendedWhereItContradictsItselfAndUndoneToThat) {
  floor::Site broken;
  broken.routes = {routeCalled("north"), routeCalled("north"), routeCalled("south")};
  document.replace(floor::SiteMap::build(broken, floor::Ambiguity::Carried).value(), {});
  EXPECT_FALSE(add("south")) << "not another contradiction";
  ASSERT_TRUE(document.edit("Rename", [](floor::Site& site) { site.name = "hall"; }));
  EXPECT_EQ(document.map()->contradictions().size(), 1U);
  ASSERT_TRUE(document.edit("Rename route", [](floor::Site& site) { site.routes[1].name = "west"; }));
  EXPECT_TRUE(document.map()->contradictions().empty());
  document.undoStack().undo();
  EXPECT_EQ(document.map()->contradictions().size(), 1U);
  document.undoStack().undo();
  EXPECT_EQ(document.site(), broken);
  document.undoStack().redo();
  document.undoStack().redo();
  EXPECT_TRUE(document.map()->contradictions().empty());
  EXPECT_EQ(document.site().routes[1].name, "west");
}

TEST_F(OpenDocument, countsAnEditThatChangesNothingAsNone) {
  ASSERT_TRUE(document.edit("Nothing", [](floor::Site&) {}));
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_TRUE(changed.isEmpty());
  EXPECT_FALSE(document.isModified());
}

TEST_F(OpenDocument, isModifiedUntilItIsSavedAndAgainWhenUndoneBeyond) {
  ASSERT_TRUE(add("north"));
  EXPECT_TRUE(document.isModified());
  document.markSaved();
  EXPECT_FALSE(document.isModified());
  document.undoStack().undo();
  EXPECT_TRUE(document.isModified());
  document.undoStack().redo();
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(modified.size(), 4);
}

TEST_F(OpenDocument, forgetsItsStepsWhenAnotherSiteIsOpened) {
  ASSERT_TRUE(add("north"));
  QSignalSpy replaced{&document, &SiteDocument::replaced};
  QSignalSpy path{&document, &SiteDocument::pathChanged};
  floor::Site other;
  other.name = "Other hall";
  document.replace(floor::SiteMap::build(other).value(), "/sites/other.tessera.json");
  EXPECT_EQ(document.site().name, "Other hall");
  EXPECT_EQ(document.path(), "/sites/other.tessera.json");
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_FALSE(document.isModified());
  EXPECT_EQ(replaced.size(), 1);
  EXPECT_EQ(path.size(), 1);
}

TEST_F(OpenDocument, restoresAWholeSiteAsOneStep) {
  ASSERT_TRUE(add("north"));
  floor::Site found;
  found.name = "Found again";
  document.restore("Restore", floor::SiteMap::build(found).value());
  EXPECT_EQ(document.site().name, "Found again");
  EXPECT_TRUE(document.isModified());
  document.undoStack().undo();
  EXPECT_EQ(document.site().routes.size(), 1U);
}

// As an operator's day: everything that can be edited, drags among it, there and back again and again.
TEST_F(OpenDocument, goesBothWaysOverAnySequenceOfSteps) {
  std::mt19937 random{7};
  std::vector<floor::Site> sites{document.site()};
  for (int n = 0; n < 60; ++n) {
    const auto name = std::to_string(n);
    const int kind = static_cast<int>(random() % 4);
    const auto step = [&](floor::Site& site) {
      if (kind == 0)
        site.routes.insert(site.routes.begin() + static_cast<std::ptrdiff_t>(random() % (site.routes.size() + 1)),
                           routeCalled(name));
      if (kind == 1) site.name = name;
      if (kind == 2 && !site.routes.empty())
        site.routes.erase(site.routes.begin() + static_cast<std::ptrdiff_t>(random() % site.routes.size()));
      if (kind == 3 && !site.routes.empty()) site.routes.back().vertices[1].x = Metres{1.0 + n};
    };
    ASSERT_TRUE(document.edit("Step", step, kind == 3 ? 9 : 0));
    sites.resize(static_cast<std::size_t>(document.undoStack().count()));
    sites.push_back(document.site());
  }
  ASSERT_GT(sites.size(), 30U);
  for (int round = 0; round < 2; ++round) {
    for (std::size_t n = sites.size() - 1; n-- > 0;) {
      document.undoStack().undo();
      ASSERT_EQ(document.site(), sites[n]) << n;
    }
    for (std::size_t n = 1; n < sites.size(); ++n) {
      document.undoStack().redo();
      ASSERT_EQ(document.site(), sites[n]) << n;
    }
  }
}

}  // namespace
}  // namespace tessera::ui
