#include "client/document/run_names.hpp"

#include "client/document/html.hpp"
#include "common/core/words.hpp"

namespace cd {

std::string RunNames::name_of(std::uint64_t scenario) const {
    const std::string number = "#" + std::to_string(scenario);
    if (job_.scene) {
        return number + place_in_scene(scenario);
    }
    if (scenario < job_.labels.integers.size()) {
        return number + ", id " + std::to_string(job_.labels.integers[scenario]);
    }
    return scenario < job_.labels.texts.size()
               ? number + ", id " + short_name(job_.labels.texts[scenario])
               : number;
}

std::string RunNames::place_in_scene(std::uint64_t scenario) const {
    const std::string step = ", step " + std::to_string(job_.scene->steps->step_of(scenario));
    const auto read = job_.poses->read(scenario, 1);
    if (!read) {
        return step; // The poses cannot be read any more; the bodies are not known.
    }
    const Scenario& found = read.value().front();
    const std::string one = short_name(job_.names[found.body_a]);
    const auto views = views_of(job_.spec, *job_.meshes[0]);
    if (views == nullptr) {
        return step + ", " + one + " x " + short_name(job_.names[found.body_b]);
    }
    const std::string bundle = views->id_of(found.step.value_or(0) % views->bundles());
    return step + ", " + one + (bundle.empty() ? "" : ", " + bundle);
}

std::string RunNames::label_of(std::uint64_t scenario) const {
    std::string text = name_of(scenario);
    if (job_.scene) {
        const StepIndex& steps = *job_.scene->steps;
        return text + ", t " + exact_text(steps.time_of(steps.step_of(scenario)));
    }
    if (scenario < job_.labels.times.size()) {
        text += ", t " + exact_text(job_.labels.times[scenario]);
    }
    if (scenario < job_.labels.end_times.size()) {
        text += " to " + exact_text(job_.labels.end_times[scenario]);
    }
    return text;
}

std::string RunNames::part_name(std::uint32_t body, const std::string& part) const {
    return manifest_.bodies.size() == 2
               ? short_name(part)
               : short_name(manifest_.bodies[body].name) + "/" + short_name(part);
}

} // namespace cd
