// Faults that a test switches on to prove that it would notice them. Shipped builds, without
// CD_MUTATIONS, contain no faults: `mutated` is always false.
#pragma once

#include <cstdint>

namespace cd {

enum class Mutation : std::uint8_t {
    None,
    LostLeaseForgotten,     ///< Work of a lost worker is not given to others.
    DrainedWorkForgotten,   ///< Work of a draining worker is not given to others.
    LostRangeForgotten,     ///< The unanswered rest of a lost range is not given to others.
    AnswerLeftAtWorker,     ///< An answered scenario still counts as the worker's.
    RoomNotGivenBack,       ///< A scenario that leaves the work queue still counts as unsent.
    PoisonToleratedTooLong, ///< A scenario that kills workers is never given up.
    PoisonGivenUpTooEarly,  ///< A scenario is given up one worker too early.
    SecondAnswerMerged,     ///< The second result of a scenario is merged, too.
    AnswerKeptTooEarly,     ///< The master acknowledges results that are not durable.
    JobAcceptedTooEarly,    ///< A client learns of the acceptance of a job that is not durable.
    EndToldTooEarly,        ///< A client learns of an end that is not durable.
    SegmentNotSynced,       ///< The index refers to records that are not durable.
    GroupNotRecovered,      ///< After a restart, the last result of a job is missing.
    DoneIsDoneAgain,        ///< After a restart, scenarios with a result are sent again.
    RecalledLeftAtWorker,   ///< Recalled work still counts as the worker's.
    RecalledIsLost,         ///< Recalled work is not given to others.
    CopyLeftAtWorker,       ///< A copy of an answered scenario still counts as running.
    CopyIsAlone,            ///< Scenarios of a lost copy are queued again despite the original.
    EvictionIgnored,        ///< Blocks that a worker evicted count as held.
    HeldWhenSent,           ///< A worker counts as a holder of a block that is only sent.
    LiarKept,               ///< The other results of a worker with a wrong result stay valid.
    OldEpochTaken,          ///< A session from before a restart of the master is resumed.
    TooMuchInFlight,        ///< Blocks are sent without a limit on the unsent bytes.
    ReadsOn,                ///< The master takes result messages without a limit.
    EvictionNotTold,        ///< A worker evicts a block and does not report it.
    HeardAgainForgotten,    ///< A worker that was silent for a while gets no work afterwards.
    BatchesWithoutBound,    ///< A worker gets batches of scenarios without a limit.
    NobodyAwaited,          ///< After a restart, work is sent before the workers return.
    OthersSourceNamed,      ///< A fetch names a peer that holds only the first block.
    IndexTakenForPosition,  ///< A result counts for the position that equals its index.
    SplitRunLosesEnd,       ///< Removing a part of a run also removes the positions after it.
    count,
};

#ifdef CD_MUTATIONS
/// The fault that is switched on.
inline Mutation mutation = Mutation::None;
static inline bool mutated(Mutation one) {
    return one == mutation;
}
#else
static constexpr bool mutated(Mutation) {
    return false;
}
#endif

} // namespace cd
