// Whatever is done, undo leads back through equal sites and redo forth again.
#include <random>

#include "laying_board.h"

namespace tessera::ui {
namespace {

class LayHistory : public LayingBoard {
protected:
  // One gesture or key at random, by real events.
  void doSomething(std::mt19937& dice) {
    const auto upTo = [&](int n) { return static_cast<int>(dice() % static_cast<unsigned>(n)); };
    const auto x = [&] { return 0.3 + 0.6 * upTo(9); };
    const auto y = [&] { return 0.3 + 0.6 * upTo(6); };
    switch (upTo(14)) {
      case 0:
      case 1:
        key(Qt::Key_L);
        drag(x(), y(), x(), y());
        break;
      case 2:
        key(Qt::Key_L);
        drag(x(), y(), x(), y(), Qt::ShiftModifier);
        break;
      case 3:
        key(Qt::Key_R);
        break;
      case 4:
        key(Qt::Key_C);
        click(x(), y());
        break;
      case 5:
        key(Qt::Key_C);
        drag(x(), y(), x(), y());
        break;
      case 6:
        key(Qt::Key_A, Qt::ControlModifier);
        break;
      case 7:
        key(Qt::Key_Delete);
        break;
      case 8:
        key(Qt::Key_D, Qt::ControlModifier);
        break;
      case 9:
        key(Qt::Key_C, Qt::ControlModifier);
        key(Qt::Key_V, Qt::ControlModifier);
        click(x(), y());
        break;
      case 10:
        key(std::array{Qt::Key_Left, Qt::Key_Right, Qt::Key_Up, Qt::Key_Down}[static_cast<std::size_t>(upTo(4))]);
        break;
      case 11:
        tool.align(static_cast<LayEdits::Line>(upTo(5)));
        break;
      case 12:
        key(Qt::Key_R, Qt::ShiftModifier);
        break;
      default:
        document.undoStack().undo();
        break;
    }
    if (tool.isPasting()) key(Qt::Key_Escape);
  }

  void expectNoneUponAnother() const {
    const auto& placements = site().placements;
    for (std::size_t a = 0; a < placements.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        const Box one = floor::boxOf(placements[a], site().tileTypes[0]);
        const Box other = floor::boxOf(placements[b], site().tileTypes[0]);
        ASSERT_FALSE(lieUpon(one, other, Metres{0.031})) << placements[a].serial << ", " << placements[b].serial;
      }
    }
  }
};

TEST_F(LayHistory, LeadsBackThroughEqualSitesAndForthAgain) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    std::mt19937 dice{seed};
    undoAll();
    document.undoStack().clear();
    tool.choose({});
    const floor::Site first = site();
    for (int n = 0; n < 40; ++n) doSomething(dice);
    ASSERT_NO_FATAL_FAILURE(expectNoneUponAnother()) << "seed " << seed;
    ASSERT_GT(document.undoStack().count(), 3) << "seed " << seed << " did nothing";
    redoAll();
    std::vector<floor::Site> sites{site()};
    while (document.undoStack().canUndo()) {
      document.undoStack().undo();
      sites.push_back(site());
    }
    EXPECT_EQ(site(), first) << "seed " << seed;
    for (auto expected = sites.rbegin() + 1; expected != sites.rend(); ++expected) {
      document.undoStack().redo();
      ASSERT_EQ(site(), *expected) << "seed " << seed;
    }
  }
}

TEST_F(LayHistory, UndoesAWholeFloorToNothingAndRedoesIt) {
  const floor::Site nothing = site();
  fill(6, 4);
  key(Qt::Key_A, Qt::ControlModifier);
  key(Qt::Key_R);
  key(Qt::Key_Up);
  key(Qt::Key_Up);
  const floor::Site all = site();
  undoAll();
  EXPECT_EQ(site(), nothing);
  redoAll();
  EXPECT_EQ(site(), all);
}

}  // namespace
}  // namespace tessera::ui
