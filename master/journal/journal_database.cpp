#include "master/journal/journal_database.hpp"

#include "common/core/check.hpp"
#include "common/core/files/disk_file.hpp"
#include "master/base/remedy.hpp"
#include "master/journal/database_copy.hpp"

#include <sqlite3.h>
#include <unistd.h>

#include <cctype>
#include <cstring>
#include <optional>
#include <string_view>

namespace cd {

namespace {

constexpr int application_id = 0x43'44'4a'31; // "CDJ1"
/// Version of the tables and of the row encoding; no other version is read.
constexpr int schema_version = 15;
constexpr std::uint64_t mark_magic = 0x31'4b'52'4d'44'43'00'00; // "\0\0CDMRK1"
constexpr std::uint64_t mark_bytes = 3 * sizeof(std::uint64_t);

constexpr const char* schema =
    "CREATE TABLE meta(name TEXT PRIMARY KEY, value BLOB NOT NULL);"
    "CREATE TABLE jobs(job INTEGER PRIMARY KEY, record BLOB NOT NULL, progress BLOB, ended BLOB);"
    "CREATE TABLE results(number INTEGER PRIMARY KEY, job INTEGER NOT NULL, content BLOB NOT NULL);"
    "CREATE INDEX results_of_job ON results(job);";

/// Kind of a row. The row's checksum covers the kind, so that a row is never read as another kind.
enum class RowKind : std::uint64_t {
    Meta = 1,
    Record = 2,
    Progress = 3,
    End = 4,
    Results = 5,
    Alarms = 6
};

Bytes sealed(std::span<const std::byte> content, RowKind kind, std::uint64_t key) {
    ByteWriter out;
    put_bytes(out, content);
    out.put(static_cast<std::uint64_t>(kind));
    out.put(key);
    const std::uint64_t sum = checksum(out.bytes());
    ByteWriter row;
    put_bytes(row, content);
    row.put(sum);
    return row.take();
}

std::optional<Bytes> unsealed(std::span<const std::byte> row, RowKind kind, std::uint64_t key) {
    if (row.size() < sizeof(std::uint64_t)) {
        return std::nullopt;
    }
    const auto content = row.first(row.size() - sizeof(std::uint64_t));
    const Bytes again = sealed(content, kind, key);
    if (!std::equal(row.begin(), row.end(), again.begin(), again.end())) {
        return std::nullopt;
    }
    return Bytes(content.begin(), content.end());
}

/// Reinterprets the 64 bits as a signed number, since SQLite stores no unsigned numbers.
sqlite3_int64 to_column(std::uint64_t value) {
    return static_cast<sqlite3_int64>(value);
}

/// Returns the path as a file URI (RFC 3986).
std::string as_uri(const std::filesystem::path& path) {
    constexpr std::string_view digits = "0123456789ABCDEF";
    constexpr std::string_view plain = "/._-";
    std::string uri = "file:";
    for (const char letter : path.string()) {
        const auto code = static_cast<unsigned char>(letter);
        if (std::isalnum(code) != 0 || plain.find(letter) != std::string_view::npos) {
            uri += letter;
        } else {
            uri += {'%', digits[code >> 4], digits[code & 15]};
        }
    }
    return uri;
}

struct CloseDatabase {
    void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
};
struct FinalizeStatement {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, CloseDatabase>;

/// A prepared statement. After an error, `step` returns false and `sqlite3_errmsg` has the reason.
class Statement {
  public:
    Statement(sqlite3* database, const char* text) {
        sqlite3_stmt* made = nullptr;
        sqlite3_prepare_v2(database, text, -1, &made, nullptr);
        statement_.reset(made);
    }
    Statement& bind(int place, std::uint64_t value) {
        sqlite3_bind_int64(statement_.get(), place, to_column(value));
        return *this;
    }
    Statement& bind(int place, std::span<const std::byte> value) {
        sqlite3_bind_blob64(statement_.get(), place, value.data(), value.size(), SQLITE_TRANSIENT);
        return *this;
    }
    Statement& bind(int place, const char* text) {
        sqlite3_bind_text(statement_.get(), place, text, -1, SQLITE_STATIC);
        return *this;
    }
    /// Fetches the next row. False if there is none, or after an error (see `failed`).
    [[nodiscard]] bool step() {
        code_ = statement_ == nullptr ? SQLITE_ERROR : sqlite3_step(statement_.get());
        return code_ == SQLITE_ROW;
    }
    [[nodiscard]] bool failed() const { return code_ != SQLITE_ROW && code_ != SQLITE_DONE; }
    [[nodiscard]] std::uint64_t number(int column) const {
        return static_cast<std::uint64_t>(sqlite3_column_int64(statement_.get(), column));
    }
    [[nodiscard]] std::span<const std::byte> bytes(int column) const {
        const void* data = sqlite3_column_blob(statement_.get(), column);
        const int size = sqlite3_column_bytes(statement_.get(), column);
        return {static_cast<const std::byte*>(data), static_cast<std::size_t>(size)};
    }
    [[nodiscard]] std::string text(int column) const {
        const auto content = bytes(column);
        return {reinterpret_cast<const char*>(content.data()), content.size()};
    }

  private:
    std::unique_ptr<sqlite3_stmt, FinalizeStatement> statement_;
    int code_ = SQLITE_OK;
};

Error missing_mark(const std::filesystem::path& database) {
    return with_remedy(
        {ErrorCode::Io,
         (database.parent_path() / "journal.mark").string() +
             " is missing or empty, so that nothing tells whether commits are lost"});
}

/// The journal's index in SQLite. No other class uses SQLite.
class SqliteDatabase final : public JournalDatabase {
  public:
    explicit SqliteDatabase(const std::filesystem::path& directory)
        : path_(directory / "journal.db") {}
    ~SqliteDatabase() override;
    /// Errors: as `JournalDatabase::open`.
    [[nodiscard]] Status open(const Options& options);

    [[nodiscard]] const Sha256& cluster() const override { return cluster_; }
    [[nodiscard]] JobId last_job() const override { return JobId{last_job_}; }
    [[nodiscard]] Result<std::vector<DatabaseJob>> jobs() const override;
    [[nodiscard]] Result<Bytes> record(JobId job) const override;
    [[nodiscard]] Result<Bytes> alarms() const override;
    [[nodiscard]] Status
    for_each_results(JobId job,
                     const std::function<Status(std::span<const std::byte>)>& take) const override;
    [[nodiscard]] Status check_owners() const override;
    [[nodiscard]] Status write(std::span<const DatabaseChange> changes) override;
    [[nodiscard]] const std::filesystem::path& path() const override { return path_; }

  private:
    [[nodiscard]] Error failure(const std::string& what) const {
        return {ErrorCode::Io,
                "cannot " + what + " " + path_.string() + ": " +
                    std::string(sqlite3_errmsg(database_.get()))};
    }
    [[nodiscard]] Error damage(const std::string& why) const {
        return {ErrorCode::Io, path_.string() + " is damaged: " + why};
    }
    [[nodiscard]] Error refusal(const std::string& why) const { return with_remedy(damage(why)); }
    [[nodiscard]] bool run(const char* text) const {
        return sqlite3_exec(database_.get(), text, nullptr, nullptr, nullptr) == SQLITE_OK;
    }

    [[nodiscard]] Status connect(const Options& options, bool create);
    [[nodiscard]] Status make();
    [[nodiscard]] Status make_mark();
    [[nodiscard]] Status check_unmarked(const Options& options);
    [[nodiscard]] bool is_empty() const;
    [[nodiscard]] Status check();
    [[nodiscard]] Status check_version();
    [[nodiscard]] Result<Bytes> meta(const char* name) const;
    [[nodiscard]] bool set_meta(const char* name,
                                std::span<const std::byte> value,
                                RowKind kind = RowKind::Meta) const;
    [[nodiscard]] bool set_number(const char* name, std::uint64_t value) const;
    [[nodiscard]] Status read_meta();
    [[nodiscard]] Result<std::uint64_t> read_mark() const;
    [[nodiscard]] Status write_mark() const;
    [[nodiscard]] bool apply(const DatabaseChange& change);

    std::filesystem::path path_;
    std::optional<DiskFile> mark_;
    std::optional<DatabaseCopy> copy_; ///< Read instead of `path_`, if set.
    Database database_;
    bool writing_ = false; ///< True after the first write. Closing then checkpoints the log.
    Sha256 cluster_;
    std::uint64_t last_job_ = 0;
    std::uint64_t commits_ = 0;
};

} // namespace

// ---- Opening ------------------------------------------------------------------------------------

Status SqliteDatabase::connect(const Options& options, bool create) {
    sqlite3* opened = nullptr;
    // `cdmaster check` may run in a read-only folder, where SQLite opens a database without a log
    // only as immutable, and cannot open a database with a log: then a copy is read.
    std::error_code none;
    const std::uintmax_t log_bytes = std::filesystem::file_size(path_.string() + "-wal", none);
    const bool is_at_rest = !options.create && (none || log_bytes == 0);
    if (!options.create && !is_at_rest && ::access(path_.parent_path().c_str(), W_OK) != 0) {
        auto made = DatabaseCopy::make(path_);
        if (!made) {
            return made.error();
        }
        copy_.emplace(std::move(made.value()));
    }
    const std::string name =
        is_at_rest ? as_uri(path_) + "?immutable=1" : (copy_ ? copy_->path() : path_).string();
    const int flags = is_at_rest ? SQLITE_OPEN_READONLY | SQLITE_OPEN_URI
                                 : SQLITE_OPEN_READWRITE | (create ? SQLITE_OPEN_CREATE : 0);
    const int code = sqlite3_open_v2(name.c_str(), &opened, flags | SQLITE_OPEN_NOMUTEX, nullptr);
    database_.reset(opened);
    if (code != SQLITE_OK) {
        return failure("open");
    }
    // By default, closing moves the log into the database file. Without a write that must not
    // happen, because the log may be damaged.
    sqlite3_db_config(opened, SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, 1, nullptr);
    sqlite3_extended_result_codes(opened, 1);
    const std::string settings =
        "PRAGMA locking_mode=EXCLUSIVE; PRAGMA temp_store=MEMORY; PRAGMA cell_size_check=ON;"
        "PRAGMA synchronous=" +
        std::string(options.synced ? "FULL" : "OFF");
    return run(settings.c_str()) ? Status(Done{}) : failure("open");
}

Status SqliteDatabase::make() {
    const std::string names = "PRAGMA application_id=" + std::to_string(application_id) +
                              "; PRAGMA user_version=" + std::to_string(schema_version);
    cluster_ = random_secret();
    const bool made = run("PRAGMA journal_mode=WAL") && run("BEGIN IMMEDIATE") &&
                      run(names.c_str()) && run(schema) && set_meta("cluster", cluster_.bytes) &&
                      set_number("last_job", 0) && set_number("commits", 0) && run("COMMIT") &&
                      // Moves the tables into the database file, so that a state whose log is lost
                      // later does not look new.
                      run("PRAGMA wal_checkpoint(TRUNCATE)");
    if (!made) {
        return failure("create");
    }
    writing_ = true;
    return make_mark();
}

Status SqliteDatabase::make_mark() {
    const std::filesystem::path mark_path = path_.parent_path() / "journal.mark";
    Result<DiskFile> file = DiskFile::create_for(mark_path);
    if (!file) {
        return file.error();
    }
    mark_.emplace(std::move(file.value()));
    if (Status status = write_mark(); !status) {
        return status;
    }
    return mark_->commit();
}

/// Accepts that `journal.mark` is missing only if the creation of the journal was interrupted.
Status SqliteDatabase::check_unmarked(const Options& options) {
    if (commits_ != 0 || !options.owned.empty()) {
        return missing_mark(path_);
    }
    return options.create ? make_mark() : Status(Done{});
}

/// Returns whether the database has no tables yet, for example after an interrupted creation.
bool SqliteDatabase::is_empty() const {
    Statement id(database_.get(), "PRAGMA application_id");
    return id.step() && id.number(0) == 0;
}

Status SqliteDatabase::check() {
    Statement id(database_.get(), "PRAGMA application_id");
    if (!id.step()) {
        return refusal(sqlite3_errmsg(database_.get()));
    }
    if (id.number(0) != static_cast<std::uint64_t>(application_id)) {
        return refusal("it is no journal");
    }
    if (Status known = check_version(); !known) {
        return known;
    }
    Statement check(database_.get(), "PRAGMA quick_check(1)");
    if (!check.step()) {
        return refusal(sqlite3_errmsg(database_.get()));
    }
    if (check.text(0) != "ok") {
        return refusal(check.text(0));
    }
    return read_meta();
}

Status SqliteDatabase::check_version() {
    Statement number(database_.get(), "PRAGMA user_version");
    if (!number.step()) {
        return refusal(sqlite3_errmsg(database_.get()));
    }
    const std::uint64_t version = number.number(0);
    if (version == schema_version) {
        return Done{};
    }
    return Error{
        ErrorCode::Io,
        path_.string() + " is of version " + std::to_string(version) +
            ", and this cdmaster reads version " + std::to_string(schema_version) +
            "; nothing was changed: let its jobs end with the cdmaster that wrote it and fetch "
            "their results, then delete journal.* and jobs in " +
            path_.parent_path().string() + " (meshes and identity stay)"};
}

Status SqliteDatabase::read_meta() {
    const Result<Bytes> name = meta("cluster");
    const Result<Bytes> last = meta("last_job");
    const Result<Bytes> commit = meta("commits");
    for (const Result<Bytes>* each : {&name, &last, &commit}) {
        if (!*each) {
            return each->error();
        }
    }
    ByteReader in_name(name.value());
    cluster_ = get_hash(in_name);
    last_job_ = ByteReader(last.value()).get<std::uint64_t>();
    commits_ = ByteReader(commit.value()).get<std::uint64_t>();
    const Result<std::uint64_t> marked = mark_ ? read_mark() : commits_;
    if (!marked) {
        return marked.error();
    }
    if (marked.value() > commits_) {
        return with_remedy({ErrorCode::Io,
                            path_.string() + "-wal is damaged or missing: " +
                                std::to_string(marked.value() - commits_) +
                                " commits are not in it"});
    }
    return Done{};
}

Result<std::uint64_t> SqliteDatabase::read_mark() const {
    const Result<Bytes> bytes = mark_->read_at(0, mark_bytes);
    if (!bytes) {
        return with_remedy(bytes.error());
    }
    ByteReader in(bytes.value());
    const auto magic = in.get<std::uint64_t>();
    const auto commit = in.get<std::uint64_t>();
    const auto sum = in.get<std::uint64_t>();
    if (magic != mark_magic || sum != checksum(std::span(bytes.value()).first(2 * sizeof sum))) {
        return with_remedy(
            {ErrorCode::Io, mark_->path().string() + " is damaged: its checksum is wrong"});
    }
    return commit;
}

// Called after each commit, without a sync: an outdated mark names fewer commits, which is valid.
Status SqliteDatabase::write_mark() const {
    ByteWriter out;
    out.put(mark_magic);
    out.put(commits_);
    out.put(checksum(out.bytes()));
    return mark_->write_at(0, out.bytes());
}

SqliteDatabase::~SqliteDatabase() {
    if (database_ != nullptr) { // After a write, lets SQLite move the log into the database file.
        sqlite3_db_config(
            database_.get(), SQLITE_DBCONFIG_NO_CKPT_ON_CLOSE, writing_ ? 0 : 1, nullptr);
    }
}

Status SqliteDatabase::open(const Options& options) {
    const std::filesystem::path mark_path = path_.parent_path() / "journal.mark";
    const bool is_there = std::filesystem::exists(path_);
    std::error_code none;
    const std::uintmax_t mark_size = std::filesystem::file_size(mark_path, none);
    const bool has_mark = !none && mark_size != 0;
    if (!is_there && (has_mark || !options.owned.empty())) {
        const std::string beside = has_mark ? mark_path.string() : options.owned.string();
        return with_remedy({ErrorCode::Io, path_.string() + " is missing, but there is " + beside});
    }
    if (!is_there && !options.create) {
        return Error{ErrorCode::NotFound, path_.parent_path().string() + " holds no journal"};
    }
    if (has_mark) {
        Result<DiskFile> mark =
            options.create ? DiskFile::open_to_write(mark_path) : DiskFile::open(mark_path);
        if (!mark) {
            return mark.error();
        }
        mark_.emplace(std::move(mark.value()));
    }
    Status status = connect(options, !is_there);
    const bool may_be_new = !has_mark && options.owned.empty() && options.create;
    if (status && may_be_new && is_empty()) {
        status = make();
    } else if (status) {
        status = check();
        if (status && !has_mark) {
            status = check_unmarked(options);
        }
    }
    return status;
}

// ---- Reading ------------------------------------------------------------------------------------

Result<Bytes> SqliteDatabase::meta(const char* name) const {
    Statement statement(database_.get(), "SELECT value FROM meta WHERE name=?");
    statement.bind(1, name);
    if (!statement.step()) {
        return refusal(std::string(name) + " is missing");
    }
    auto value = unsealed(statement.bytes(0), RowKind::Meta, 0);
    if (!value) {
        return refusal(std::string(name) + " has a wrong checksum");
    }
    return std::move(*value);
}

Result<std::vector<DatabaseJob>> SqliteDatabase::jobs() const {
    std::vector<DatabaseJob> jobs;
    Statement statement(database_.get(),
                        "SELECT job, record, progress, ended FROM jobs ORDER BY job");
    while (statement.step()) {
        const std::uint64_t id = statement.number(0);
        DatabaseJob job;
        job.id = JobId{id};
        const std::array<std::pair<RowKind, Bytes*>, 3> parts{{{RowKind::Record, &job.record},
                                                               {RowKind::Progress, &job.progress},
                                                               {RowKind::End, &job.end}}};
        for (int column = 1; column <= 3; ++column) {
            const auto& [kind, part] = parts[static_cast<std::size_t>(column) - 1];
            const auto row = statement.bytes(column);
            if (row.empty() && kind != RowKind::Record) {
                continue;
            }
            auto content = unsealed(row, kind, id);
            if (!content) {
                return damage("job " + std::to_string(id) + " has a wrong checksum");
            }
            *part = std::move(*content);
        }
        jobs.push_back(std::move(job));
    }
    if (statement.failed()) {
        return failure("read");
    }
    return jobs;
}

Result<Bytes> SqliteDatabase::record(JobId job) const {
    const std::string name = "job " + std::to_string(job.value);
    Statement statement(database_.get(), "SELECT record FROM jobs WHERE job=?");
    statement.bind(1, job.value);
    if (!statement.step()) {
        return statement.failed() ? failure("read")
                                  : Error{ErrorCode::NotFound, "no " + name + " is known here"};
    }
    auto record = unsealed(statement.bytes(0), RowKind::Record, job.value);
    if (!record) {
        return damage(name + " has a wrong checksum");
    }
    return std::move(*record);
}

Result<Bytes> SqliteDatabase::alarms() const {
    Statement statement(database_.get(), "SELECT value FROM meta WHERE name='alarms'");
    if (!statement.step()) {
        return statement.failed() ? Result<Bytes>(failure("read")) : Result<Bytes>(Bytes());
    }
    auto value = unsealed(statement.bytes(0), RowKind::Alarms, 0);
    if (!value) {
        return damage("the list of alarms has a wrong checksum");
    }
    return std::move(*value);
}

Status SqliteDatabase::for_each_results(
    JobId job, const std::function<Status(std::span<const std::byte>)>& take) const {
    Statement statement(database_.get(), "SELECT content FROM results WHERE job=? ORDER BY number");
    statement.bind(1, job.value);
    while (statement.step()) {
        const auto content = unsealed(statement.bytes(0), RowKind::Results, job.value);
        if (!content) {
            return damage("results of job " + std::to_string(job.value) + " have a wrong checksum");
        }
        if (Status status = take(*content); !status) {
            return status;
        }
    }
    return statement.failed() ? Status(failure("read")) : Status(Done{});
}

Status SqliteDatabase::check_owners() const {
    Statement statement(database_.get(),
                        "SELECT job FROM results WHERE job NOT IN (SELECT job FROM jobs) LIMIT 1");
    if (statement.step()) {
        return damage("results of job " + std::to_string(statement.number(0)) +
                      ", which is not there");
    }
    return statement.failed() ? Status(failure("read")) : Status(Done{});
}

// ---- Writing ------------------------------------------------------------------------------------

bool SqliteDatabase::set_meta(const char* name,
                              std::span<const std::byte> value,
                              RowKind kind) const {
    Statement statement(database_.get(), "INSERT OR REPLACE INTO meta(name, value) VALUES(?, ?)");
    statement.bind(1, name).bind(2, sealed(value, kind, 0));
    return !statement.step() && !statement.failed();
}

bool SqliteDatabase::set_number(const char* name, std::uint64_t value) const {
    return set_meta(name, std::as_bytes(std::span(&value, 1)));
}

bool SqliteDatabase::apply(const DatabaseChange& change) {
    using Kind = DatabaseChange::Kind;
    const std::uint64_t job = change.job.value;
    const auto run_with = [&](const char* text, RowKind kind) {
        Statement statement(database_.get(), text);
        statement.bind(1, job).bind(2, sealed(change.content, kind, job));
        return !statement.step() && !statement.failed();
    };
    const auto run_for = [&](const char* text) {
        Statement statement(database_.get(), text);
        statement.bind(1, job);
        return !statement.step() && !statement.failed();
    };
    switch (change.kind) {
    case Kind::Accept:
        return run_with("INSERT INTO jobs(job, record) VALUES(?, ?)", RowKind::Record) &&
               set_number("last_job", std::max(last_job_, job));
    case Kind::Record:
        return run_with("UPDATE jobs SET record=?2 WHERE job=?1", RowKind::Record);
    case Kind::Results:
        return run_with("INSERT INTO results(job, content) VALUES(?, ?)", RowKind::Results);
    case Kind::Progress:
        return run_with("UPDATE jobs SET progress=?2 WHERE job=?1", RowKind::Progress);
    case Kind::End:
        return run_with("UPDATE jobs SET ended=?2 WHERE job=?1", RowKind::End);
    case Kind::Drop:
        return run_for("DELETE FROM results WHERE job=?") &&
               run_for("DELETE FROM jobs WHERE job=?");
    case Kind::Alarms:
        return set_meta("alarms", change.content, RowKind::Alarms);
    }
    return false;
}

Status SqliteDatabase::write(std::span<const DatabaseChange> changes) {
    if (!mark_->has_its_name()) {
        return Error{ErrorCode::Io,
                     path_.parent_path().string() +
                         " was removed or replaced under the running master: nothing more can be "
                         "kept; put it back, or start the master again"};
    }
    bool written = run("BEGIN IMMEDIATE");
    for (const DatabaseChange& change : changes) {
        written = written && apply(change);
    }
    written = written && set_number("commits", commits_ + 1) && run("COMMIT");
    if (!written) {
        const Error why = failure("write");
        (void)run("ROLLBACK"); // Fails harmlessly if SQLite has already rolled back.
        return why;
    }
    ++commits_;
    writing_ = true;
    for (const DatabaseChange& change : changes) {
        if (change.kind == DatabaseChange::Kind::Accept) {
            last_job_ = std::max(last_job_, change.job.value);
        }
    }
    // An error is ignored: the mark then names fewer commits, which is valid.
    (void)write_mark();
    return Done{};
}

Result<std::unique_ptr<JournalDatabase>>
JournalDatabase::open(const std::filesystem::path& directory, const Options& options) {
    auto database = std::make_unique<SqliteDatabase>(directory);
    if (const Status opened = database->open(options); !opened) {
        return opened.error();
    }
    return std::unique_ptr<JournalDatabase>(std::move(database));
}

} // namespace cd
