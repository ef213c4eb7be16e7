// lcp_search [--from SEED] [--count N] [--findings N]: solves random problems (problems.hpp) and judges the answers (judge.hpp). A finding is made as
// small as it gets and printed as a program. Exit status 1 if there was one.
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>

#include <unistd.h>

#include "judge.hpp"

namespace islet::lcp_search {
namespace {

volatile std::uint64_t seed_at_work = 0;

/// Where a sanitizer or a signal ends the program, the seed must not be lost.
void tell_seed(int signal) {
    char text[80];
    const int length = std::snprintf(text, sizeof text, "lcp_search: at seed %llu\n", static_cast<unsigned long long>(seed_at_work));
    [[maybe_unused]] const auto written = write(STDERR_FILENO, text, static_cast<std::size_t>(length));
    std::signal(signal, SIG_DFL);
    std::raise(signal);
}

std::string promise_of(const std::string& found) { return found.substr(0, found.find(':')); }

// -- smaller -----------------------------------------------------------------------------------------------------------------------------------------

template <class T>
Case<T> without_row(const Case<T>& c, std::size_t gone) {
    Case<T> s = c;
    s.n = c.n - 1;
    s.m.clear(), s.present.clear();
    for (std::size_t k = 0; k < c.m.size(); ++k) {
        if (k / c.n == gone || k % c.n == gone) continue;
        s.m.push_back(c.m[k]), s.present.push_back(c.present[k]);
    }
    for (std::vector<T>* v : {&s.q, &s.lo, &s.hi, &s.x})
        if (!v->empty()) v->erase(v->begin() + static_cast<std::ptrdiff_t>(gone));
    const auto moved = [gone](std::uint32_t row) { return row > gone && row != lcp::no_row ? row - 1 : row; };
    if (!s.friction.empty()) s.friction.erase(s.friction.begin() + static_cast<std::ptrdiff_t>(gone));
    for (std::uint32_t& row : s.friction) row = row == gone ? lcp::no_row : moved(row);
    std::erase(s.order, static_cast<std::uint32_t>(gone));
    for (std::uint32_t& row : s.order) row = moved(row);
    for (std::uint32_t& first : s.blocks) first = moved(first);
    s.blocks.erase(std::unique(s.blocks.begin(), s.blocks.end()), s.blocks.end());
    if (!s.blocks.empty() && s.blocks.back() >= s.n) s.blocks.pop_back();
    return s;
}

/// Every change that might make the problem simpler, offered one by one; each that keeps the finding stays.
template <class T>
Case<T> smallest(Case<T> c, const std::string& promise) {
    bool is_smaller = true;
    const auto offer = [&](const Case<T>& simpler) {
        if (promise_of(finding(simpler)) != promise) return;
        c = simpler;
        is_smaller = true;
    };
    const auto offer_value = [&](auto member, std::size_t k, T value) {
        if ((c.*member)[k] == value) return;
        Case<T> simpler = c;
        (simpler.*member)[k] = value;
        offer(simpler);
    };
    for (int round = 0; round < 20 && is_smaller; ++round) {
        is_smaller = false;
        for (std::size_t i = c.n; i-- > 0 && c.n > 1;) offer(without_row(c, i));
        for (auto list : {&Case<T>::order, &Case<T>::blocks, &Case<T>::friction}) {
            Case<T> simpler = c;
            (simpler.*list).clear();
            if (!(c.*list).empty()) offer(simpler);
        }
        const auto set = [&](auto member, auto value) {
            Case<T> simpler = c;
            simpler.*member = value;
            if (c.*member != value) offer(simpler);
        };
        set(&Case<T>::sparse, false);
        set(&Case<T>::history, 0u);
        set(&Case<T>::check_every, 1u);
        set(&Case<T>::omega, T(1));
        set(&Case<T>::regularisation, T(0));
        set(&Case<T>::max_iterations, c.max_iterations / 2);
        set(&Case<T>::tolerance, T(0));
        for (auto member : {&Case<T>::m, &Case<T>::q, &Case<T>::lo, &Case<T>::hi, &Case<T>::x}) {
            for (std::size_t k = 0; k < (c.*member).size(); ++k) {
                const T now = (c.*member)[k];
                if (now == T(0)) continue;
                offer_value(member, k, T(0));
                if ((c.*member)[k] == now && now != T(1)) offer_value(member, k, T(1));
                if ((c.*member)[k] != now || !std::isfinite(now)) continue;
                char text[32];
                std::snprintf(text, sizeof text, "%.1g", double(now));
                const T rounded = static_cast<T>(std::strtod(text, nullptr));
                if (std::isfinite(rounded)) offer_value(member, k, rounded);
            }
        }
    }
    return c;
}

// -- as a program --------------------------------------------------------------------------------------------------------------------------------------

std::string literal(float v) {
    if (std::isinf(v)) return v > 0 ? "INFINITY" : "-INFINITY";
    char text[48];
    std::snprintf(text, sizeof text, "%.9g", double(v));
    return text;
}
std::string literal(double v) {
    if (std::isinf(v)) return v > 0 ? "INFINITY" : "-INFINITY";
    char text[48];
    std::snprintf(text, sizeof text, "%.17g", v);
    return text;
}
std::string literal(std::uint32_t v) { return v == lcp::no_row ? "no_row" : std::to_string(v); }

template <class V>
void print_array(const char* type, const char* name, const std::vector<V>& values) {
    std::printf("    std::vector<%s> %s = {", type, name);
    const bool is_index = std::is_same_v<V, std::uint32_t>;
    for (std::size_t i = 0; i < values.size(); ++i)
        std::printf(is_index ? "%s%s" : "%sT(%s)", i == 0 ? "" : ", ", literal(values[i]).c_str());
    std::printf("};\n");
}

template <class T>
void print_program(const Case<T>& c, const std::string& found, std::uint64_t seed) {
    const Arguments<T> a(c, c.sparse);
    const auto list = [](const auto& array) { return std::vector(array.span().begin(), array.span().end()); };
    std::printf("// seed %llu: %s\n#include <cmath>\n#include <cstdio>\n#include <vector>\n#include <islet/lcp.hpp>\n",
                static_cast<unsigned long long>(seed), found.c_str());
    std::printf("using namespace islet::lcp;\nusing T = %s;\nint main() {\n", sizeof(T) == sizeof(float) ? "float" : "double");
    for (const auto& [name, values] : {std::pair{"m", &a.m}, {"q", &a.q}, {"lo", &a.lo}, {"hi", &a.hi}, {"x", &a.x}})
        print_array("T", name, list(*values));
    for (const auto& [name, values] :
         {std::pair{"starts", &a.starts}, {"columns", &a.columns}, {"friction", &a.friction}, {"order", &a.order}, {"blocks", &a.blocks}})
        print_array("std::uint32_t", name, list(*values));
    std::printf("    Problem<T> p = {%s, .q = q, .lo = lo, .hi = hi, .friction = friction};\n",
                c.sparse ? ".sparse = {starts, columns, m}" : ".dense = {m}");
    std::printf(
        "    Options<T> o = {.method = Method(%u), .max_iterations = %u, .tolerance = T(%s), .omega = T(%s), .regularisation = T(%s), "
        ".check_every = %u, .order = order, .blocks = blocks};\n",
        static_cast<unsigned>(a.options.method), a.options.max_iterations, literal(a.options.tolerance).c_str(),
        literal(a.options.omega).c_str(), literal(a.options.regularisation).c_str(), a.options.check_every);
    std::printf("    std::vector<std::byte> memory(%zu);\n", a.memory_bytes);
    std::printf(
        "    const Result<T> r = solve<T>(p, o, x, memory);\n    std::printf(\"%%s natural residual %%g, x =\", describe(r.status), "
        "double(r.residuals.natural));\n");
    std::printf("    for (T v : x) std::printf(\" %%g\", double(v));\n    std::printf(\"\\n\");\n}\n\n");
}

template <class T>
bool try_seed(std::uint64_t seed, std::map<std::string, int>& met) {
    const Case<T> c = draw_case<T>(seed);
    const std::string found = finding(c);
    if (found.empty()) return true;
    const std::string kind =
        promise_of(found) + (sizeof(T) == sizeof(float) ? ", float, method " : ", double, method ") + std::to_string(c.method);
    if (++met[kind] > 1) return false;  // one program of each kind
    print_program(smallest(c, promise_of(found)), found, seed);
    std::fflush(stdout);
    return false;
}

int search(int argc, char** argv) {
    std::uint64_t from = 0, count = 10000, most = 20;
    for (int i = 1; i + 1 < argc; i += 2) {
        const std::string option = argv[i];
        const std::uint64_t value = std::strtoull(argv[i + 1], nullptr, 10);
        if (option == "--from")
            from = value;
        else if (option == "--count")
            count = value;
        else if (option == "--findings")
            most = value;
        else
            return std::fprintf(stderr, "lcp_search: no option %s; there are --from, --count and --findings\n", argv[i]), 2;
    }
    for (const int signal : {SIGABRT, SIGSEGV, SIGFPE, SIGBUS, SIGILL}) std::signal(signal, tell_seed);
    std::map<std::string, int> met;
    std::uint64_t findings = 0, done = 0;
    for (; done < count && findings < most; ++done) {
        seed_at_work = from + done;
        const bool is_float = seed_at_work % 2 == 0;
        if (!(is_float ? try_seed<float>(seed_at_work, met) : try_seed<double>(seed_at_work, met))) ++findings;
    }
    for (const auto& [kind, times] : met) std::printf("%d times: %s\n", times, kind.c_str());
    std::printf("%llu problems from seed %llu, %llu findings\n", static_cast<unsigned long long>(done),
                static_cast<unsigned long long>(from), static_cast<unsigned long long>(findings));
    return findings > 0 ? 1 : 0;
}

}  // namespace
}  // namespace islet::lcp_search

int main(int argc, char** argv) { return islet::lcp_search::search(argc, argv); }
