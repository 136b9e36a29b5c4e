// Faults that a test switches on to prove that it would notice them. Shipped builds, without
// CD_MUTATIONS, contain no faults: `mutated` is always false.
#pragma once

#include <cstdint>

namespace cd {

enum class Mutation : std::uint8_t {
    None,
    LostLeaseForgotten,     ///< Work of a lost worker is not given to others.
    DrainedWorkForgotten,   ///< Work of a draining worker is not given to others.
    LostRangeForgotten,     ///< The rest of a lost range is not given to others.
    AnswerLeftAtWorker,     ///< An answered scenario still counts as the worker's.
    RoomNotGivenBack,       ///< A scenario that leaves a buffer still counts as unsent.
    PoisonToleratedTooLong, ///< A scenario that kills workers is never given up.
    PoisonGivenUpTooEarly,  ///< A scenario is given up one worker too early.
    SecondAnswerMerged,     ///< A scenario's second answer is merged as well.
    AnswerKeptTooEarly,     ///< The master acknowledges results that are not durable.
    JobAcceptedTooEarly,    ///< A client learns of the acceptance of a job that is not durable.
    EndToldTooEarly,        ///< A client learns of an end that is not durable.
    SegmentNotSynced,       ///< The index refers to records that are not durable.
    GroupNotRecovered,      ///< After a restart, the last result of a job is missing.
    DoneIsDoneAgain,        ///< After a restart, scenarios with a result go out again.
    RecalledLeftAtWorker,   ///< Returned work still counts as the worker's.
    RecalledIsLost,         ///< Returned work is not given to others.
    CopyLeftAtWorker,       ///< A copy of an answered scenario counts as running.
    CopyIsAlone,            ///< When a copy is lost, the original is forgotten, too.
    EvictionIgnored,        ///< Blocks that a worker evicted count as held.
    HeldWhenSent,           ///< Blocks sent to a worker count as held.
    LiarKept,               ///< Other results of a wrong worker are kept.
    OldEpochTaken,          ///< A session of an earlier incarnation is resumed.
    TooMuchInFlight,        ///< Blocks are sent without a limit in flight.
    ReadsOn,                ///< The master reads from a worker without a limit.
    EvictionNotTold,        ///< A worker evicts a block and does not report it.
    HeardAgainForgotten,    ///< A silent worker that is heard again gets no work.
    BatchesWithoutBound,    ///< A worker gets batches without a limit.
    NobodyAwaited,          ///< After a restart, work goes out before the workers return.
    OthersSourceNamed,      ///< A fetch names a peer that holds only the first block.
    IndexTakenForPosition,  ///< An answer counts for the position that equals its index.
    SplitRunLosesEnd,       ///< A hole in a run of positions removes the positions after it, too.
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
