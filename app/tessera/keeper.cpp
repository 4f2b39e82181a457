#include "app/tessera/keeper.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <algorithm>
#include <chrono>
#include <utility>

#include "host/supervisor_thread.h"
#include "store/site_store.h"
#include "supervisor/parameter_texts.h"
#include "ui/base/wording.h"

namespace tessera::desktop {
namespace {

constexpr int kRestMs = 400;  // edits of one drag are kept once
constexpr int kHistory = 300;
constexpr int kPage = 500;

Sentence sentenceOf(const store::Wording& wording) {
  if (!wording.isPattern) return wording.text;
  std::vector<Sentence> arguments;
  for (const auto& argument : wording.arguments) arguments.push_back(sentenceOf(argument));
  return Sentence::restored(wording.text, std::move(arguments));
}

/// Oldest first.
std::vector<ui::JournalLine> linesOf(const store::JournalPage& page) {
  std::vector<ui::JournalLine> lines;
  for (auto entry = page.entries.rbegin(); entry != page.entries.rend(); ++entry)
    lines.push_back(
        {QDateTime::fromMSecsSinceEpoch(entry->utcMs), entry->severity, entry->vehicle, sentenceOf(entry->wording)});
  return lines;
}

}  // namespace

QString Keeper::databasePath() {
  return QDir{QStandardPaths::writableLocation(QStandardPaths::AppDataLocation)}.filePath(
      QStringLiteral("tessera.sqlite"));
}

QDateTime Keeper::wallClock(Seconds instant) {
  const double ago = (host::steadyNow() - instant).value();
  return QDateTime::currentDateTime().addMSecs(-static_cast<qint64>(ago * 1000.0));
}

Keeper::Keeper(ui::SiteDocument& document, ui::FleetLink& fleet, QObject* parent)
    : QObject{parent}, document_{document} {
  QDir{}.mkpath(QFileInfo{databasePath()}.path());
  store::StoreThread::Options options;
  options.file = databasePath().toStdString();
  store_ = std::make_unique<store::StoreThread>(options);
  connect(store_.get(), &store::StoreThread::failed, this,
          [this](const Sentence& sentence) { Q_EMIT failed(ui::text(sentence)); });
  connect(store_.get(), &store::StoreThread::journalFound, this,
          [this](quint64 request, const store::JournalPage& page) {
            if (request == history_) Q_EMIT historyLoaded(linesOf(page));
            if (request == page_) takePage(page);
          });
  connect(store_.get(), &store::StoreThread::requestFailed, this, [this](quint64 request, const Sentence& sentence) {
    if (request == page_) Q_EMIT dayFailed(ui::text(sentence));
    Q_EMIT requestFailed(request, ui::text(sentence));
  });
  connect(store_.get(), &store::StoreThread::recovered, this, &Keeper::recovered);
  connect(store_.get(), &store::StoreThread::revisionsListed, this, &Keeper::revisionsListed);
  connect(store_.get(), &store::StoreThread::revisionLoaded, this, &Keeper::revisionLoaded);
  connect(store_.get(), &store::StoreThread::magneticMapLoaded, this, &Keeper::magneticMapLoaded);
  store_->start();
  edits_.setSingleShot(true);
  edits_.setInterval(kRestMs);
  connect(&edits_, &QTimer::timeout, this, [this] { keepSite(document_.isModified()); });
  connect(&document_, &ui::SiteDocument::replaced, this, [this] {
    edits_.stop();
    use(document_.path().isEmpty() ? store::freshKey() : store::keyOfFile(document_.path().toStdString()));
  });
  connect(&document_, &ui::SiteDocument::changed, this, [this] { edits_.start(); });
  connect(&fleet, &ui::FleetLink::eventsArrived, this, &Keeper::note);
}

Keeper::~Keeper() { close(); }

std::shared_ptr<const floor::SiteMap> Keeper::unsaved(const QString& path) {
  // A connection of its own: the answer is needed before anything else goes on.
  auto database = store::Database::open(databasePath().toStdString());
  if (!database) return nullptr;
  const store::SiteStore sites{**database};
  const std::string key = store::keyOfFile(path.toStdString());
  const auto kept = sites.find(key);
  if (!kept || !*kept || !(*kept)->differsFromFile) return nullptr;
  auto site = sites.load(key);
  if (!site || !*site) return nullptr;
  const auto map = floor::SiteMap::build(std::move(**site), floor::Ambiguity::Carried);
  return map ? *map : nullptr;
}

std::optional<qint64> Keeper::holderOf(const QString& path) const {
  return lock_.holderOf(store::keyOfFile(path.toStdString()));
}

void Keeper::use(const std::string& key) {
  key_ = key;
  lock_.take(key);
}

std::vector<Keeper::Homeless> Keeper::homeless() {
  std::vector<Homeless> found;
  auto database = store::Database::open(databasePath().toStdString());
  if (!database) return found;
  const store::SiteStore sites{**database};
  const auto kept = sites.list();
  if (!kept) return found;
  for (const store::KeptSite& site : *kept) {
    if (!site.differsFromFile || !site.file().empty() || site.key == key_ || lock_.holderOf(site.key)) continue;
    auto loaded = sites.load(site.key);
    if (!loaded || !*loaded) continue;
    if (const auto map = floor::SiteMap::build(std::move(**loaded), floor::Ambiguity::Carried))
      found.push_back({site.key, QDateTime::fromMSecsSinceEpoch(site.savedUtcMs), *map});
  }
  return found;
}

void Keeper::onSaved(const QString& path) {
  const std::string old = key_;
  use(store::keyOfFile(path.toStdString()));
  // Under its new name it is another site; what the old file holds did not change.
  if (!old.empty() && old != key_) {
    store_->removeSite(old);
    store_->copyRevisions(old, key_);
  }
  keepSite(false);
  if (old != key_) Q_EMIT keyChanged(QString::fromStdString(old));
}

void Keeper::onGivenUp(const QString& path) {
  edits_.stop();
  store_->removeSite(path.isEmpty() ? key_ : store::keyOfFile(path.toStdString()));
}

void Keeper::keepSite(bool differsFromFile) {
  edits_.stop();
  if (!key_.empty()) store_->keepSite(key_, document_.map(), QDateTime::currentMSecsSinceEpoch(), differsFromFile);
}

void Keeper::note(const std::vector<supervisor::Event>& events) {
  std::vector<store::Note> notes;
  for (const auto& event : events)
    if (!supervisor::isSample(event))
      notes.push_back({wallClock(event.time).toMSecsSinceEpoch(), document_.site().name, event});
  store_->appendEvents(std::move(notes));
}

void Keeper::loadHistory() {
  store::JournalFilter filter;
  filter.limit = kHistory;
  history_ = store_->queryJournal(filter);
}

void Keeper::readDay(const ui::JournalDay& day) {
  day_ = {};
  day_.fromUtcMs = day.day.startOfDay().toMSecsSinceEpoch();
  day_.untilUtcMs = day.day.addDays(1).startOfDay().toMSecsSinceEpoch();
  day_.vehicle = day.vehicle;
  day_.atLeast = day.least;
  day_.limit = kPage;
  ofDay_ = 0;
  askForPage();
}

void Keeper::askForPage() {
  page_ = store_->queryJournal(day_);
  if (page_ == 0) Q_EMIT dayFailed(tr("The journal cannot be read just now. Try again in a moment."));
}

void Keeper::takePage(const store::JournalPage& page) {
  ofDay_ += page.entries.size();
  const bool on = page.more && ofDay_ < ui::EventModel::kMost;
  Q_EMIT dayRead(linesOf(page), on          ? ui::JournalPart::Page
                                : page.more ? ui::JournalPart::TooMany
                                            : ui::JournalPart::Last);
  if (!on) return;
  day_.beforeId = page.entries.back().id;
  askForPage();
}

void Keeper::addRevision(const store::RevisionNote& note, const std::shared_ptr<const floor::SiteMap>& map) {
  if (!key_.empty()) store_->addRevision(key_, map, note);
}

void Keeper::keepMagneticMap(const std::string& key, bool simulated, std::shared_ptr<const locate::MagneticMap> map) {
  store::KeptSite site;
  site.key = key;
  if (site.file().empty()) return;
  store_->keepMagneticMap(key, simulated, std::move(map), QDateTime::currentMSecsSinceEpoch());
}

quint64 Keeper::listRevisions() { return store_->listRevisions(key_); }
quint64 Keeper::loadRevision(qint64 id) { return store_->loadRevision(id); }
quint64 Keeper::loadMagneticMap(const std::string& key, bool simulated) {
  return store_->loadMagneticMap(key, simulated);
}

bool Keeper::close() {
  if (edits_.isActive()) keepSite(document_.isModified());
  return store_->close();
}

}  // namespace tessera::desktop
