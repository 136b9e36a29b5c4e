// Faults that a test switches on to see that it would notice them. In what is shipped there are
// none: without CD_MUTATIONS all of this is nothing.
#pragma once

#include <cstdint>

namespace cd {

enum class Mutation : std::uint8_t {
    None,
    LostLeaseForgotten,     ///< What was at a worker that is lost is not given to others.
    DrainedWorkForgotten,   ///< What a draining worker hands back is not given to others.
    LostRangeForgotten,     ///< The rest of a range that was lost is not done.
    AnswerLeftAtWorker,     ///< An answered scenario still counts as the worker's.
    RoomNotGivenBack,       ///< A scenario that leaves a buffer still counts as unsent.
    PoisonToleratedTooLong, ///< A scenario that takes workers down is never given up.
    PoisonGivenUpTooEarly,  ///< It is given up one worker too early.
    SecondAnswerMerged,     ///< A scenario's second answer is merged as well.
    AnswerKeptTooEarly,     ///< Results are acknowledged before they are on the disk.
    JobAcceptedTooEarly,    ///< A job is accepted before it is on the disk.
    EndToldTooEarly,        ///< A client hears of an end that is not on the disk.
    SegmentNotSynced,       ///< Records are named by the index before they are on the disk.
    GroupNotRecovered,      ///< After a restart the last commit of a job is missing.
    DoneIsDoneAgain,        ///< After a restart finished scenarios go out once more.
    RecalledLeftAtWorker,   ///< What a worker gave back still counts as the worker's.
    RecalledIsLost,         ///< What a worker gave back is not given to others.
    CopyLeftAtWorker,       ///< A copy whose scenario is answered still counts as its worker's.
    CopyIsAlone,            ///< With a copy, its scenario is lost, too.
    EvictionIgnored,        ///< What a worker let go counts as there.
    HeldWhenSent,           ///< What goes to a worker counts as there.
    LiarKept,               ///< What else came of a worker that was found wrong stays.
    OldEpochTaken,          ///< A session of a former life of the master goes on.
    TooMuchInFlight,        ///< A worker gets blocks however many are on their way to it.
    ReadsOn,                ///< A worker is listened to however much of it is in hand.
    EvictionNotTold,        ///< A worker lets a block go, and says nothing.
    HeardAgainForgotten,    ///< A worker that was silent is heard again, and gets nothing more.
    BatchesWithoutBound,    ///< A worker gets batch after batch, however many stand there.
    NobodyAwaited,          ///< After a restart work goes out before its workers are back.
    OthersSourceNamed,      ///< A worker is sent to one that has the first of the blocks alone.
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
