#include "library/borrowed_poses.hpp"

#include "common/core/errors.hpp"
#include "library/errors.hpp"

namespace cdcluster {

namespace {

cd::PoseLayout layout_of(PoseForm form) {
    switch (form) {
    case PoseForm::Matrix44:
        return cd::PoseLayout::Matrix44;
    case PoseForm::Matrix34:
        return cd::PoseLayout::Matrix34;
    case PoseForm::Xyzw:
        return cd::PoseLayout::Xyzw;
    case PoseForm::Wxyz:
        break;
    }
    return cd::PoseLayout::Wxyz;
}

} // namespace

BorrowedPoses::BorrowedPoses(const Poses& poses, std::uint64_t first)
    : poses_(poses), first_(first), layout_(layout_of(poses.form)), size_(cd::numbers_of(layout_)) {
    if (poses.numbers.empty() || poses.numbers.size() % size_ != 0) {
        throw Error(ErrorCode::BadInput,
                    "poses have " + std::to_string(poses.numbers.size()) +
                        " numbers; a pose of this form has " + std::to_string(size_) +
                        ", and there is at least one pose");
    }
    for (std::uint64_t i = 0; i < count(); ++i) {
        static_cast<void>(value_of(at(i)));
    }
}

std::string BorrowedPoses::place_of(std::uint64_t scenario) const {
    return "row " + std::to_string(first_ + scenario);
}

cd::Result<cd::Scenario> BorrowedPoses::at(std::uint64_t row) const {
    const auto numbers = poses_.numbers.subspan(row * size_, size_);
    auto pose = cd::checked_pose(numbers, layout_);
    if (!pose) {
        return cd::bad_input("poses, " + place_of(row) + ": " + pose.error().detail);
    }
    cd::Scenario made;
    made.index = first_ + row;
    made.poses.b = pose.value();
    return made;
}

cd::Result<std::vector<cd::Scenario>> BorrowedPoses::read(std::uint64_t first,
                                                          std::uint64_t count) {
    std::vector<cd::Scenario> scenarios;
    scenarios.reserve(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        scenarios.push_back(CD_TRY(at(first + i)));
    }
    return scenarios;
}

} // namespace cdcluster
