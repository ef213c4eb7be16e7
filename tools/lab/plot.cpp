#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>

#include "report.hpp"

namespace islet::lab {
namespace {

constexpr double floor_of_picture = 0.1 * levels.back();

/// Okabe and Ito's colours, which people who see red and green alike can tell apart; relatives share one, and differ by their dashes.
struct Look {
    const char* color;
    int dashes;      // gnuplot's dash types
    int point = -1;  // gnuplot's point type for methods of few iterations; -1: a line alone
};

Look look_of(lcp::Method method) {
    using lcp::Method;
    switch (method) {
    case Method::pgs: return {"#000000", 1};
    case Method::psor: return {"#000000", 2};
    case Method::symmetric_pgs: return {"#0072B2", 1};
    case Method::red_black: return {"#0072B2", 2};
    case Method::block_pgs: return {"#009E73", 1};
    case Method::jacobi: return {"#E69F00", 1};
    case Method::l1_jacobi: return {"#E69F00", 2};
    case Method::nncg: return {"#D55E00", 1};
    case Method::newton: return {"#CC79A7", 1, 7};
    case Method::lemke: return {"#56B4E9", 3, 9};
    }
    return {"#000000", 1};
}

std::string style_of(const Measurement& m) {
    const Look look = look_of(m.method->method);
    const std::string line = fmt::format("lc rgb '{}' lw 2 dt {}", look.color, look.dashes);
    return look.point < 0 ? "with lines " + line : fmt::format("with linespoints {} pt {} ps 0.7", line, look.point);
}

/// In gnuplot's single quotes only the quote itself has a meaning.
std::string quoted(const std::string& text) {
    std::string out = "'";
    for (const char c : text) out += c == '\'' ? "''" : std::string(1, c);
    return out + "'";
}

bool is_drawn(const Measurement& m) { return m.history.size() > 1; }

struct Ranges {
    double iterations = 10, least_ms = 1e9, most_ms = 0, residual = 1;
};

Ranges ranges_of(const IslandReport& report) {
    Ranges r;
    for (const Measurement& m : report.measurements) {
        for (const HistoryPoint& p : m.history) {
            r.iterations = std::max(r.iterations, double(p.iteration));
            if (p.iteration > 0 && p.seconds > 0) r.least_ms = std::min(r.least_ms, 1e3 * p.seconds);
            r.most_ms = std::max(r.most_ms, 1e3 * p.seconds);
            if (p.residual < 1e3) r.residual = std::max(r.residual, p.residual);  // what diverges may leave the picture
        }
    }
    if (r.most_ms <= r.least_ms) r.least_ms = 0.1 * r.most_ms;
    return r;
}

/// Data under names d0, d1, ...: iteration, ms, residual. An iteration of 0 has no place on a logarithmic axis.
std::string data_of(const IslandReport& report) {
    std::string text;
    for (std::size_t i = 0; i < report.measurements.size(); ++i) {
        const Measurement& m = report.measurements[i];
        if (!is_drawn(m)) continue;
        text += fmt::format("$d{} << EOD\n", i);
        for (const HistoryPoint& p : thinned(m.history)) {
            if (p.iteration > 0)
                text += fmt::format("{} {:.6g} {:.6g}\n", p.iteration, 1e3 * p.seconds, std::max(p.residual, floor_of_picture));
        }
        text += "EOD\n";
    }
    return text;
}

/// One of the four panels. `column` of the data is x.
std::string panel(const IslandReport& report, bool warm, int column) {
    const double start = std::max(warm ? report.warm_residual : 1.0, floor_of_picture);
    std::string text = fmt::format("plot {:.6g} with lines lc rgb '#b0b0b0' lw 1 dt 3 notitle", start);
    for (std::size_t i = 0; i < report.measurements.size(); ++i) {
        const Measurement& m = report.measurements[i];
        if (m.warm == warm && is_drawn(m)) text += fmt::format(", \\\n  $d{} using {}:3 {} notitle", i, column, style_of(m));
    }
    return text + "\n";
}

/// A panel without axes whose key is the legend.
std::string legend(const IslandReport& report) {
    std::string text =
        "unset border\nunset tics\nunset xlabel\nunset ylabel\nunset title\nunset grid\nunset logscale\nset key at graph 0, graph 1 left "
        "top Left reverse "
        "spacing 1.5 samplen 3\nset xrange [0:1]\nset yrange [0:1]\nplot ";
    std::vector<const MethodInfo*> named;
    for (const Measurement& m : report.measurements) {
        if (!m.left_out.empty() || std::find(named.begin(), named.end(), m.method) != named.end()) continue;
        named.push_back(m.method);
        text += fmt::format("NaN {} title {}, \\\n  ", style_of(m), quoted(label_of(m)));
    }
    return text + "NaN with lines lc rgb '#b0b0b0' lw 1 dt 3 title 'the start'\n";
}

}  // namespace

std::string plot_script(const IslandReport& report, const std::string& path) {
    const Island& island = report.island;
    const Ranges r = ranges_of(report);
    std::string text = data_of(report);
    text += fmt::format(
        "set terminal svg size 1180,780 font 'Helvetica,13' background '#ffffff' noenhanced\nset output {}\nset encoding utf8\n",
        quoted(path));
    text += fmt::format("set multiplot title {} font ',16'\n",
                        quoted(fmt::format("{} after step {}: {} bodies, {} rows, substep of {:.3g} ms", island.scene, island.step,
                                           island.bodies, island.problem.rows(), 1e3 * island.h)));
    text +=
        "set logscale xy\nset format y '10^{%L}'\nset grid lc rgb '#e0e0e0' lt 1\nset border 3\nset tics nomirror\nset termoption "
        "enhanced\n";
    text += fmt::format("set yrange [{:.3g}:{:.3g}]\n", 0.6 * floor_of_picture, 1.5 * r.residual);
    struct Place {
        bool warm;
        int column;
        double x, y;
    };
    constexpr double width = 0.42, height = 0.47;
    for (const Place& place : {Place{false, 1, 0, 0.48}, Place{false, 2, width, 0.48}, Place{true, 1, 0, 0}, Place{true, 2, width, 0}}) {
        text += fmt::format("set origin {},{}\nset size {},{}\n", place.x, place.y, width, height);
        text += fmt::format("set title '{}'\n", place.warm ? "from the impulses of the substep before (warm)" : "from zero (cold)");
        text += place.column == 1 ? "set ylabel 'natural residual (x = 0: 1)'\n" : "unset ylabel\n";
        if (place.column == 1)
            text += fmt::format("set xlabel 'iterations'\nset format x '10^{{%L}}'\nset xrange [0.8:{:.6g}]\n", 1.1 * r.iterations);
        if (place.column == 2)
            text +=
                fmt::format("set xlabel 'ms'\nset format x '10^{{%L}}'\nset xrange [{:.3g}:{:.3g}]\n", 0.9 * r.least_ms, 1.1 * r.most_ms);
        text += panel(report, place.warm, place.column);
    }
    text += fmt::format("set origin {},0.1\nset size {},0.8\n{}unset multiplot\nunset output\n", 2 * width, 1 - 2 * width,
                        "set termoption noenhanced\n" + legend(report));
    return text;
}

bool can_plot() {
    std::FILE* pipe = popen("gnuplot --version 2>/dev/null", "r");
    if (pipe == nullptr) return false;
    char line[16] = {};
    const bool answered = std::fgets(line, sizeof line, pipe) != nullptr;
    return pclose(pipe) == 0 && answered;
}

bool run_gnuplot(const std::string& script) {
    std::FILE* pipe = popen("gnuplot", "w");
    if (pipe == nullptr) return false;
    const bool written = std::fwrite(script.data(), 1, script.size(), pipe) == script.size();
    return pclose(pipe) == 0 && written;
}

}  // namespace islet::lab
