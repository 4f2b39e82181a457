// Opening, saving and leaving sites, with the questions that a person must be asked on the way.
#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/tessera/settings.h"
#include "ui/base/site_document.h"

class QWidget;

namespace tessera::desktop {

class SiteFiles : public QObject {
  Q_OBJECT
public:
  SiteFiles(ui::SiteDocument& document, Settings& settings, QWidget& window);

  /// A site that contradicts itself is opened as well, to be mended. False: it could not be read, which has been told,
  /// or the person wants to stay with what is open.
  bool open(const QString& path);
  bool openAsking();
  bool openDemo();
  bool create();
  /// Offers a site that was never saved to a file and was left behind when the program ended. False: none was opened.
  bool openHomeless();
  /// Asks for a name where there is none yet. False: not saved.
  bool save();
  bool saveAs();
  /// Offers to save what is not saved. False: the person wants to stay.
  [[nodiscard]] bool mayLeave();
  /// A vehicle has a key that no file has yet: offers to save the site.
  void offerToSaveKey(const QString& vehicle);

  /// Where the demo site is kept, so that changes to it can be saved; made when it is not there.
  [[nodiscard]] static Result<QString> demoPath();
  /// Given a path, the unsaved site that an earlier run left behind for it, if any; asked at each opening.
  void setRecovery(std::function<std::shared_ptr<const floor::SiteMap>(const QString&)> recovery) {
    recovery_ = std::move(recovery);
  }

  /// Sites without a file that earlier runs left behind.
  struct Homeless {
    QString key;
    QString when;
    std::shared_ptr<const floor::SiteMap> map;
  };
  /// Given a path, the process of another copy of the program that has this site open; asked at each opening.
  void setSharing(std::function<std::optional<qint64>(const QString&)> sharing) { sharing_ = std::move(sharing); }
  /// Nobody is there to answer: what an earlier run left unsaved is taken up, another copy's site is opened as well,
  /// and a file that somebody else changed is overwritten, with what it held kept as a revision.
  void setUnattended() { unattended_ = true; }
  void setHomeless(std::function<std::vector<Homeless>()> homeless) { homeless_ = std::move(homeless); }

Q_SIGNALS:
  /// A site stands in the document that was not there before.
  void opened();
  /// What stands in the document is what this file holds.
  void saved(const QString& path);
  /// The open site's file is about to be overwritten, and holds what somebody else saved there at this time.
  void overwriting(const std::shared_ptr<const tessera::floor::SiteMap>& other, const QDateTime& when);
  /// The changes to this file's site, or with an empty path to one that has none yet, shall be forgotten.
  void givenUp(const QString& path);
  /// The site in the document is the one that was kept under this key.
  void takenUp(const QString& key);
  /// What was kept under this key shall be forgotten.
  void forgotten(const QString& key);

private:
  bool read(const QString& path);
  bool writeTo(const QString& path);
  void remember(const QString& path, std::shared_ptr<const floor::SiteMap> holds);
  enum class Changed { Overwrite, Elsewhere, Cancel };
  /// What shall become of a file that somebody else has changed since it was read or written here.
  [[nodiscard]] Changed askChanged(const QString& path);
  /// Undecided: the question was closed without an answer, as when the program has to end.
  enum class Recovery { TakeUp, Forget, Undecided };
  [[nodiscard]] Recovery askRecovery(const QString& path);
  [[nodiscard]] bool mayShare(const QString& path, qint64 process);
  [[nodiscard]] Recovery ask(const char* name, const QString& title, const QString& question, const QString& takeUp,
                             const QString& forget);
  [[nodiscard]] QWidget* above() const;
  void tellContradictions();
  void tell(const QString& title, const QString& sentence);

  ui::SiteDocument& document_;
  Settings& settings_;
  QWidget& window_;
  bool unattended_ = false;
  /// A file as it was read or written here last.
  struct Seen {
    QString path;
    QDateTime modified;
    qint64 size = 0;
    std::shared_ptr<const floor::SiteMap> holds;
  };
  Seen seen_;
  std::function<std::shared_ptr<const floor::SiteMap>(const QString&)> recovery_;
  std::function<std::optional<qint64>(const QString&)> sharing_;
  std::function<std::vector<Homeless>()> homeless_;
};

}  // namespace tessera::desktop
