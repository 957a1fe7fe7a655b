#include "app/command_line/command_line.h"

#include "app/command_line/commands.h"
#include "core/formats/file.h"
#include "core/formats/numbers.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iostream>

#ifndef SPLINELOFT_VERSION
#define SPLINELOFT_VERSION "0.1.0"
#endif

namespace splineloft {
namespace {

constexpr int done = 0;
constexpr int refused = 1;
constexpr int wronglyCalled = 2;

/// A picture's sides, in pixels: enough for the window to have its parts, little enough for OpenGL.
constexpr long long shortestSide = 64;
constexpr long long longestSide = 8192;

/// The parts between separators, also empty ones.
std::vector<std::string> split(const std::string& list, char separator) {
    std::vector<std::string> parts(1);
    for (const char c : list) {
        if (c == separator) {
            parts.emplace_back();
        } else {
            parts.back() += c;
        }
    }
    return parts;
}

// Numbers are read here and not by the library, whose reading follows the locale.

double numberOf(const std::string& option, const std::string& text) {
    const auto value = numberFrom(text);
    if (!value) {
        throw CLI::ValidationError(option, inQuotes(text) + " is not a number");
    }
    return *value;
}

long long wholeNumberOf(const std::string& option, const std::string& text) {
    const auto value = wholeNumberFrom(text);
    if (!value) {
        throw CLI::ValidationError(option, inQuotes(text) + " is not a whole number");
    }
    return *value;
}

std::size_t countOf(const std::string& option, const std::string& text) {
    const auto value = wholeNumberOf(option, text);
    if (value < 0) {
        throw CLI::ValidationError(option, inQuotes(text) + " is negative");
    }
    return static_cast<std::size_t>(value);
}

std::vector<double> numbersOf(const std::string& option, const std::string& list) {
    std::vector<double> values;
    for (const auto& text : split(list, ',')) {
        values.push_back(numberOf(option, text));
    }
    return values;
}

/// All options, as they were written.
struct Written {
    std::vector<std::string> files; ///< of the editor or of `check`
    std::string file, curve, segment, u, t, perPiece, count, output, size, scale, show, format,
        family;
    std::string spacing = "parameter";
    std::string theme = "dark";
    std::string plot = "basis";
    std::string pace = "length";
    bool present = false;
    bool json = false;
};

CurveChoice choiceIn(const Written& written) {
    return {written.file, written.curve.empty() ? std::nullopt : std::optional(written.curve)};
}

SpotQuery queryIn(const Written& written) {
    if (!written.t.empty()) {
        return {choiceIn(written), std::nullopt, numbersOf("--t", written.t)};
    }
    if (written.segment.empty()) {
        throw CLI::ValidationError("which spots?", "give --segment with --u, or --t");
    }
    return {choiceIn(written), wholeNumberOf("--segment", written.segment),
            numbersOf("--u", written.u)};
}

Sampling samplingIn(const Written& written) {
    if (!written.perPiece.empty()) {
        return StepsPerPiece{countOf("--per-segment", written.perPiece)};
    }
    if (written.count.empty()) {
        throw CLI::ValidationError("how many samples?", "give --per-segment or --count");
    }
    using In = EvenSamples::In;
    const auto in = written.spacing == "length" ? In::length
                    : written.spacing == "time" ? In::time
                                                : In::parameter;
    return EvenSamples{countOf("--count", written.count), in};
}

DrawScreenshot screenshotIn(const Written& written) {
    DrawScreenshot shot;
    if (!written.file.empty()) {
        shot.file = written.file;
    }
    shot.output = written.output;
    shot.theme = written.theme;
    shot.present = written.present;
    shot.plot = written.plot;
    shot.pace = written.pace;
    if (!written.show.empty()) {
        shot.show = split(written.show, ',');
    }
    if (!written.size.empty()) {
        const auto sides = split(written.size, 'x');
        if (sides.size() != 2) {
            throw CLI::ValidationError("--size", inQuotes(written.size) + " is not like 1280x800");
        }
        const auto side = [](const std::string& text) {
            const auto value = wholeNumberOf("--size", text);
            if (value < shortestSide || value > longestSide) {
                throw CLI::ValidationError("--size", "a side of " + inQuotes(text) +
                                                         " is not within 64 to 8192");
            }
            return static_cast<int>(value);
        };
        shot.width = side(sides[0]);
        shot.height = side(sides[1]);
    }
    if (!written.scale.empty()) {
        shot.scale = numberOf("--scale", written.scale);
        constexpr double least = 0.5;
        constexpr double most = 4;
        if (shot.scale < least || shot.scale > most) {
            throw CLI::ValidationError("--scale",
                                       inQuotes(written.scale) + " is not within 0.5 to 4");
        }
    }
    return shot;
}

bool endsWith(const std::string& path, std::string_view extension) {
    return CLI::detail::to_lower(std::filesystem::path(path).extension().string()) == extension;
}

/// The program's options and commands, and what comes of them.
class CommandLine {
  public:
    explicit CommandLine(const Streams& streams) : streams_(streams) {
        app_.require_subcommand(0, 1);
        app_.set_version_flag("--version", "splineloft " SPLINELOFT_VERSION);
        app_.add_option("FILE", written_.files, "Documents to open");
        app_.failure_message([](const CLI::App*, const CLI::Error& error) {
            return std::string("splineloft: ") + error.what() + " (see --help)\n";
        });
        addFamilies();
        addEval();
        addBasis();
        addSample();
        addMeasure();
        addConvert();
        addCheck();
        addScreenshot();
    }

    Command run(int argc, const char* const* argv) {
        try {
            app_.parse(argc, argv);
            if (app_.get_subcommands().empty()) {
                return openEditor();
            }
        } catch (const CLI::Error& error) {
            const bool asked = app_.exit(error, streams_.out, streams_.err) == 0;
            return Finished{asked ? done : wronglyCalled};
        }
        return command_;
    }

  private:
    CLI::App* add(const std::string& name, const std::string& description) {
        return app_.add_subcommand(name, description);
    }

    void addFile(CLI::App& sub) {
        sub.add_option("FILE", written_.file, "The document; - is the standard input")->required();
    }

    void addCurve(CLI::App& sub) {
        sub.add_option("--curve", written_.curve, "Name or index of the curve (default: 0)")
            ->type_name("NAME|INDEX");
    }

    void addSpots(CLI::App& sub) {
        auto* segment = sub.add_option("--segment", written_.segment, "Index of the piece");
        auto* u = sub.add_option("--u", written_.u, "Where on that piece, 0 to 1");
        auto* t = sub.add_option("--t", written_.t, "Parameter values");
        segment->type_name("S")->needs(u);
        u->type_name("U[,U...]")->needs(segment);
        t->type_name("T[,T...]")->excludes(segment)->excludes(u);
    }

    void addFamilies() {
        auto* sub = add("families", "List the spline families");
        sub->add_flag("--json", written_.json, "As JSON, with parameters and ranges");
        sub->callback([this] { answer(written_.json ? familiesAsJson() : familiesAsTable()); });
    }

    void addEval() {
        auto* sub = add("eval", "Position, derivatives and curvature at spots of a curve, as JSON");
        addFile(*sub);
        addCurve(*sub);
        addSpots(*sub);
        sub->callback([this] { answer(evaluate(queryIn(written_), streams_.in)); });
    }

    void addBasis() {
        auto* sub = add("basis", "Weights of the control points at spots of a curve, as JSON");
        addFile(*sub);
        addCurve(*sub);
        addSpots(*sub);
        sub->callback([this] { answer(basisAt(queryIn(written_), streams_.in)); });
    }

    void addSample() {
        auto* sub = add("sample", "Samples along a curve, as CSV or JSON");
        addFile(*sub);
        addCurve(*sub);
        auto* perPiece =
            sub->add_option("--per-segment", written_.perPiece, "Steps on every piece");
        auto* count = sub->add_option("--count", written_.count, "Samples from start to end");
        perPiece->type_name("N")->excludes(count);
        count->type_name("N");
        sub->add_option("--spacing", written_.spacing,
                        "What they are even in; time is that of travel at constant speed")
            ->check(CLI::IsMember({"parameter", "length", "time"}))
            ->excludes(perPiece);
        sub->add_option("-o", written_.output, "Write to OUT.csv or OUT.json (default: print CSV)")
            ->type_name("OUT");
        sub->callback([this] { sampleInto(written_.output); });
    }

    void addMeasure() {
        auto* sub = add("measure", "Length, bounds and the continuity of each joint, as JSON");
        addFile(*sub);
        addCurve(*sub);
        sub->callback([this] { answer(measure(choiceIn(written_), streams_.in)); });
    }

    void addConvert() {
        auto* sub = add("convert", "The same curves as another family, in a document of their own");
        addFile(*sub);
        sub->add_option("-o", written_.output, "The new document")
            ->type_name("OUT.json")
            ->required();
        sub->add_option("--to", written_.format, "Format (default: by the ending of OUT)")
            ->check(CLI::IsMember({"json"}));
        sub->add_option("--family", written_.family,
                        "The family it shall be, by id (default: stay)");
        sub->callback([this] {
            if (written_.format.empty() && !endsWith(written_.output, ".json")) {
                throw CLI::ValidationError("-o", inQuotes(written_.output) +
                                                     " does not end in .json; or name a format "
                                                     "with --to json");
            }
            const auto family =
                written_.family.empty() ? std::nullopt : std::optional(written_.family);
            save(written_.output, convert(written_.file, family, streams_.in));
        });
    }

    void addCheck() {
        auto* sub = add("check", "Say of each file whether it is a good document");
        sub->add_option("FILE", written_.files, "Documents; - is the standard input")->required();
        sub->callback([this] {
            int code = done;
            for (const auto& file : written_.files) {
                answer(checkFile(file, streams_.in));
                code = std::max(code, std::get<Finished>(command_).exitCode);
            }
            command_ = Finished{code};
        });
    }

    void addScreenshot() {
        auto* sub = add("screenshot", "Draw a picture of the editor");
        sub->add_option("FILE", written_.file, "The document (default: an example)");
        sub->add_option("-o", written_.output, "The picture")->type_name("OUT.png")->required();
        sub->add_option("--size", written_.size, "In pixels (default: 1280x800)")->type_name("WxH");
        sub->add_option("--theme", written_.theme, "dark or light (default: dark)")
            ->check(CLI::IsMember({"dark", "light"}));
        sub->add_option("--show", written_.show, "Layers to show")->type_name("A,B,...");
        sub->add_option("--plot", written_.plot, "The plot below the canvas (default: basis)")
            ->check(CLI::IsMember({"basis", "speed", "acceleration", "curvature"}));
        sub->add_option("--pace", written_.pace, "Playing is even in it (default: length)")
            ->check(CLI::IsMember({"length", "parameter"}));
        sub->add_flag("--present", written_.present, "As it is shown to an audience (F11)");
        sub->add_option("--scale", written_.scale, "Size of the interface, 0.5 to 4 (default: 1)")
            ->type_name("S");
        sub->callback([this] {
            if (!endsWith(written_.output, ".png")) {
                throw CLI::ValidationError("-o",
                                           inQuotes(written_.output) + " does not end in .png");
            }
            command_ = screenshotIn(written_);
        });
    }

    Command openEditor() const {
        for (const auto& file : written_.files) {
            const bool isWord = file.find_first_of("./") == file.npos;
            if (isWord && !std::filesystem::exists(file)) {
                throw CLI::ValidationError(inQuotes(file), "neither a command nor a file");
            }
        }
        return OpenEditor{written_.files};
    }

    void sampleInto(const std::string& output) {
        const bool asJson = endsWith(output, ".json");
        if (!output.empty() && !asJson && !endsWith(output, ".csv")) {
            throw CLI::ValidationError("-o",
                                       inQuotes(output) + " ends neither in .csv nor in .json");
        }
        const auto path = sample(choiceIn(written_), samplingIn(written_), streams_.in);
        if (!path) {
            return refuse(path.refusal());
        }
        const auto text = asJson ? samplesAsJson(*path) : samplesAsCsv(*path);
        if (output.empty()) {
            return answer(text);
        }
        save(output, text);
    }

    void save(const std::string& output, const Result<std::string>& text) {
        if (!text) {
            return refuse(text.refusal());
        }
        const auto saved = saveFile(output, *text);
        if (!saved) {
            return refuse(saved.refusal());
        }
        command_ = Finished{done};
    }

    void answer(const Result<std::string>& result) {
        if (!result) {
            return refuse(result.refusal());
        }
        streams_.out << *result << std::flush;
        if (!streams_.out) {
            return refuse(
                {"standard output", "", "could not be written to", "a place that can be"});
        }
        command_ = Finished{done};
    }

    void refuse(const Refusal& refusal) {
        streams_.err << refusal.message() << '\n';
        command_ = Finished{refused};
    }

    const Streams& streams_;
    Written written_;
    Command command_ = Finished{done};
    CLI::App app_{"Splineloft: lay down points, choose how a curve goes through or near them",
                  "splineloft"};
};

} // namespace

Command runCommandLine(int argc, const char* const* argv, const Streams& streams) {
    try {
        return CommandLine(streams).run(argc, argv);
    } catch (const std::exception& error) {
        streams.err << "splineloft: " << error.what() << '\n';
        return Finished{refused};
    }
}

} // namespace splineloft
