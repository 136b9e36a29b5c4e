// Lists the members of an aggregate, so that messages need no function each to be encoded.
#pragma once

#include <cstddef>
#include <type_traits>

namespace cd {

/// Stands for a member of any type in an initialiser; never evaluated.
struct AnyMember {
    template <class T>
    operator T() const;
};

/// Returns the number of members of an aggregate: the largest number of initialisers it accepts.
template <class T, class... Members>
consteval std::size_t member_count() {
    if constexpr (requires { T{Members{}..., AnyMember{}}; }) {
        return member_count<T, Members..., AnyMember>();
    } else {
        return sizeof...(Members);
    }
}

/// Calls `visit(members...)` with the members of an aggregate in the order of their declaration.
template <class T, class Visit>
void visit_members(T& value, const Visit& visit) {
    constexpr std::size_t count = member_count<std::remove_const_t<T>>();
    if constexpr (count == 1) {
        auto& [a] = value;
        visit(a);
    } else if constexpr (count == 2) {
        auto& [a, b] = value;
        visit(a, b);
    } else if constexpr (count == 3) {
        auto& [a, b, c] = value;
        visit(a, b, c);
    } else if constexpr (count == 4) {
        auto& [a, b, c, d] = value;
        visit(a, b, c, d);
    } else if constexpr (count == 5) {
        auto& [a, b, c, d, e] = value;
        visit(a, b, c, d, e);
    } else if constexpr (count == 6) {
        auto& [a, b, c, d, e, f] = value;
        visit(a, b, c, d, e, f);
    } else if constexpr (count == 7) {
        auto& [a, b, c, d, e, f, g] = value;
        visit(a, b, c, d, e, f, g);
    } else if constexpr (count == 8) {
        auto& [a, b, c, d, e, f, g, h] = value;
        visit(a, b, c, d, e, f, g, h);
    } else if constexpr (count == 9) {
        auto& [a, b, c, d, e, f, g, h, i] = value;
        visit(a, b, c, d, e, f, g, h, i);
    } else if constexpr (count == 10) {
        auto& [a, b, c, d, e, f, g, h, i, j] = value;
        visit(a, b, c, d, e, f, g, h, i, j);
    } else if constexpr (count == 12) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l] = value;
        visit(a, b, c, d, e, f, g, h, i, j, k, l);
    } else if constexpr (count == 14) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n] = value;
        visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n);
    } else if constexpr (count == 21) {
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u] = value;
        visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u);
    } else {
        static_assert(count == 22, "a number of members that no message had before: add its line");
        auto& [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v] = value;
        visit(a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, p, q, r, s, t, u, v);
    }
}

} // namespace cd
