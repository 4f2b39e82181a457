// Sites that were open before: name, place, when. One that is gone is grey and can still be taken off the list.
#pragma once

#include <QDateTime>
#include <QLabel>
#include <QPushButton>
#include <QTreeWidget>
#include <QWidget>
#include <vector>

namespace tessera::ui {

struct RecentSite {
  QString name;
  QString path;
  QDateTime opened;
  bool missing = false;  ///< nothing is at `path` any more
};

class RecentList : public QWidget {
  Q_OBJECT
public:
  explicit RecentList(QWidget* parent = nullptr);
  void setSites(std::vector<RecentSite> sites);

Q_SIGNALS:
  void chosen(const QString& path);
  void forgotten(const QString& path);

protected:
  void changeEvent(QEvent* event) override;

private:
  void retranslate();
  void fill();
  void openCurrent();
  void forgetCurrent();
  void showCurrent();
  [[nodiscard]] const RecentSite* current() const;

  std::vector<RecentSite> sites_;
  QLabel heading_;
  QLabel empty_;
  QTreeWidget list_;
  QPushButton open_;
  QPushButton forget_;
};

}  // namespace tessera::ui
