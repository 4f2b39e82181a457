// The revisions of the open site: who saved when and what, what is different now, and the way back to one of them.
#pragma once

#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/base/site_document.h"
#include "ui/canvas/change_marks.h"
#include "ui/history/comparer.h"
#include "ui/history/revision_model.h"

class QAction;
class QLabel;
class QLineEdit;
class QListWidget;
class QSplitter;
class QStackedWidget;
class QTreeView;

namespace tessera::ui {

class RevisionPanel : public QWidget {
  Q_OBJECT
public:
  /// The document must outlive it.
  explicit RevisionPanel(SiteDocument& document, QWidget* parent = nullptr);
  ~RevisionPanel() override;

  /// The newest first.
  void setRevisions(std::vector<RevisionLine> lines);
  /// The answer to revisionWanted().
  void setRevision(qint64 id, std::shared_ptr<const floor::SiteMap> map);
  void setRevisionTrouble(qint64 id, const QString& sentence);
  /// Under which name the site is saved; proposed: what stands there when none was typed.
  void setAuthor(const QString& name, const QString& proposed);
  /// What differs, to be drawn on the floor; empty: nothing is compared.
  [[nodiscard]] ChangeMarks marks() const;

Q_SIGNALS:
  void revisionWanted(qint64 id);
  /// marks() are others.
  void changed();
  /// The operator wants to see this place on the floor.
  void placeWanted(const tessera::ui::SiteBox& place);
  void exportWanted(const std::shared_ptr<const tessera::floor::SiteMap>& map, const QDateTime& when);
  void authorChanged(const QString& name);
  /// One sentence: what was done, or why it was not.
  void told(const QString& sentence);

protected:
  void changeEvent(QEvent* event) override;

private:
  QWidget* makeBar();
  QWidget* makeDifferences();
  void retranslate();
  void refresh();
  void choose();
  void compareAgain();
  void takeUp(const std::shared_ptr<const Comparison>& comparison);
  void fillList();
  void goBack();
  void goTo(int row);
  void leave();

  SiteDocument& document_;
  RevisionModel* model_;
  Comparer* comparer_;
  QStackedWidget* pages_;
  QLabel* empty_;
  QSplitter* split_;
  QTreeView* table_;
  QLabel* head_ = nullptr;
  QListWidget* list_ = nullptr;
  QLabel* authorLabel_ = nullptr;
  QLineEdit* author_ = nullptr;
  QAction* back_ = nullptr;
  QAction* export_ = nullptr;
  QAction* leave_ = nullptr;
  std::optional<RevisionLine> chosen_;
  std::shared_ptr<const floor::SiteMap> revision_;  // of the chosen one, once it has been read
  std::shared_ptr<const Comparison> comparison_;    // of it with the present site
  QString trouble_;
  bool filling_ = false;
};

}  // namespace tessera::ui
